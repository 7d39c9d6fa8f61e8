// Whether an eye is provably outside of a closed shell.
//
// The mesh of the KSQuads' corners winds round the eye as often as the shell itself, because each KSQuad and
// its polygon lie in the hull of its control points: where the eye is in none of them, one moves into the
// other without touching it. A hull that is too near is cut into four, again and again. The polygons of
// neighbours share their corners to the bit, those of T-joints included, so the mesh is closed.
#pragma once

#include <memory>
#include <span>

#include "model/analysis/coincident_edges.h"
#include "model/analysis/shell_part.h"

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

    [[nodiscard]] const Box& box() const { return box_; }
    // How far points that are joined may be apart.
    [[nodiscard]] double margin() const { return margin_; }

    // The whole ball lies outside, clear of the surface. False where that cannot be shown quickly.
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
    class Proof;

    static Border borderOf(std::uint32_t surface, const CoincidentEdges& edges);

    std::vector<Placed> placed_;
    Box box_;
    double margin_ = 0;
};

}  // namespace knotspan
