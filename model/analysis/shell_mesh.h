// Whether an eye is provably outside of a closed shell.
//
// The mesh of the KSQuads' corners winds round the eye as often as the shell itself, because each KSQuad and
// its polygon lie in the hull of its control points: where the eye is in none of them, one moves into the
// other without touching it. A hull that is too near is cut into four, again and again. The polygons of
// neighbours share their corners to the bit, those of T-joints included, so the mesh is closed.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "model/analysis/coincident_edges.h"
#include "model/analysis/shell_part.h"
#include "model/core/totals.h"

namespace knotspan {

class ShellMesh {
public:
    // A surface of a shell.
    struct Member {
        std::uint32_t surface = 0;
        std::shared_ptr<const ShellPart> part;
        bool turned = false;  // S_u x S_v, taken in model space, points to the inside
    };
    // A closed shell, consistently turned.
    ShellMesh(const std::vector<Member>& members, const CoincidentEdges& edges);

    // Member k is another surface now, with other borders or the same.
    void replace(size_t k, const Member& member, const CoincidentEdges& edges);
    [[nodiscard]] const std::shared_ptr<const ShellPart>& part(size_t k) const { return placed_[k].part; }
    // Whether member k was made a member so.
    [[nodiscard]] bool isTurned(size_t k) const { return placed_[k].turned; }

    [[nodiscard]] Box boxOfParts() const { return reaches_.all().box; }
    [[nodiscard]] Box box() const;  // with the margin
    // How far points that are joined may be apart.
    [[nodiscard]] double margin() const;
    // visit(k) of the members whose boxes satisfy the test, as all boxes around them do; increasing.
    template <class Test, class Visit>
    void visitWhere(const Test& test, const Visit& visit) const
    {
        reaches_.visitWhere([&](const Reach& reach) { return test(reach.box); }, visit);
    }

    // The whole ball lies outside, clear of the surface. False where that cannot be shown quickly. Remembers
    // what it saw from the last eye, so that members replaced since are all it looks at: one thread at a
    // time.
    [[nodiscard]] bool isOutside(const Vec3& eye, double radius) const;

private:
    // Where a surface's border runs: the corners of all who lie along it, by border side, each line from the
    // side's start to its end.
    struct Border {
        std::vector<std::uint32_t> starts;
        std::vector<Vec3> points;

        [[nodiscard]] std::span<const Vec3> line(std::uint32_t side) const
        {
            return {points.data() + starts[side], starts[side + 1] - starts[side]};
        }
    };
    struct Placed {
        std::shared_ptr<const ShellPart> part;
        Border border;
        bool turned = false;
    };
    struct Reach {
        Box box;
        double widest = 0;  // of the boxes, along any axis
        double apart = 0;   // joined corners

        void add(const Reach& other);
    };
    // What members look like from an eye.
    struct Seen {
        double turns = 0;  // round the eye
        int splits = 0;    // that it took to show that

        void add(const Seen& other)
        {
            turns += other.turns;
            splits += other.splits;
        }
    };
    struct Look {
        Vec3 eye{};
        double reach = 0;
        Totals<Seen> seen;
        bool failed = false;
        size_t failedAt = 0;  // by this member and those before it
    };
    class Proof;

    static Placed placedAs(const Member& member, const CoincidentEdges& edges);
    static Reach reachOf(const Member& member, const CoincidentEdges& edges);
    static Border borderOf(std::uint32_t surface, const CoincidentEdges& edges);
    [[nodiscard]] double proofMargin() const;
    void lookAll(const Vec3& eye, double reach) const;
    void lookAgain() const;

    std::vector<Placed> placed_;
    Totals<Reach> reaches_;
    mutable std::optional<Look> look_;
    mutable std::vector<size_t> replaced_;  // since that look
};

}  // namespace knotspan
