// Bodies: surfaces that are joined along their borders, whether they enclose a space, and where it is. Back
// faces may be left undrawn where a body is closed and is seen from outside.
#pragma once

#include "model/analysis/shell_crossings.h"
#include "model/analysis/shell_mesh.h"

namespace knotspan {

// A shell is all surfaces that borders connect, directly or through others. It is closed where each part of a
// border is a pole or has exactly one other part along it.
class Shells {
public:
    Shells() = default;
    // `edges` are those of the surfaces.
    Shells(const std::vector<PlacedSurface>& surfaces, const CoincidentEdges& edges);

    // `edges` have been given the changes. Looks again at the changed surfaces and those beside them alone,
    // where all are joined as they were; else at all.
    void update(const std::vector<CoincidentEdges::Change>& changes, const CoincidentEdges& edges);

    // Changes with what the shells are made of, are closed and have for sides.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    // Shells are numbered by their first surface.
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(shells_.size()); }
    [[nodiscard]] std::uint32_t shellOf(std::uint32_t surface) const { return shellOf_[surface]; }
    [[nodiscard]] bool isClosed(std::uint32_t shell) const { return shells_[shell].closed; }

    // 1: S_u x S_v points outwards, -1: inwards, in the surface's own coordinates (in front of a point S is
    // an eye e with (S_u x S_v) (e - S) > 0, both in them: mirrored or not, the side stays, though the normal
    // seen in model space turns). 0: its shell is open, cannot be turned consistently (Klein's bottle),
    // encloses no volume to speak of or may go through itself (shell_crossings.h), for then parts of it can
    // be turned inside out.
    [[nodiscard]] int side(std::uint32_t surface) const { return sides_[surface]; }

    // Whether the ball round an eye in model space provably lies outside of a shell that has sides.
    [[nodiscard]] bool isOutside(std::uint32_t shell, const Vec3& eye, double radius) const;
    // The same of an eye at infinity that looks along `direction`, and sees what has dot(point, direction) >=
    // `nearest`.
    [[nodiscard]] bool isOutsideAlong(std::uint32_t shell, const Vec3& direction, double nearest) const;

private:
    // What one part adds to the volume that a shell encloses, seen from a point that all share.
    struct Swept {
        double volume = 0;
        Vec3 area{};
        double error = 0;
        double areaError = 0;

        void add(const Swept& other);
    };
    // Its members are its surfaces, increasing.
    struct Shell {
        std::vector<std::uint32_t> surfaces;
        bool closed = false;
        // Of closed ones that can be turned consistently; else none.
        bool turnable = false;
        bool sided = false;
        bool looked = false;  // for crossings, when it changed last
        Vec3 seenFrom{};
        Totals<Swept> swept;
        std::unique_ptr<ShellMesh> mesh;  // of those that can be turned
    };

    void join(const CoincidentEdges& edges);
    void begin(Shell& shell, const CoincidentEdges& edges);
    void follow(Shell& shell, const std::vector<std::uint32_t>& changed, const CoincidentEdges& edges);
    void findSides(Shell& shell, const CoincidentEdges& edges, const std::vector<std::uint32_t>* changed);
    void makeMesh(Shell& shell, bool inverted, const CoincidentEdges& edges);
    void setSides(Shell& shell, bool sided, const std::vector<std::uint32_t>* changed);
    [[nodiscard]] Swept sweptBy(std::uint32_t surface, const Vec3& seenFrom) const;
    [[nodiscard]] ShellMesh::Member memberOf(std::uint32_t surface, bool inverted) const;

    std::vector<std::shared_ptr<const ShellPart>> parts_;
    std::vector<std::uint32_t> shellOf_;
    std::vector<char> turned_;  // against the first of its shell
    std::vector<int> sides_;
    std::vector<Shell> shells_;
    ShellCrossings crossings_;
    std::uint64_t joined_ = 0;  // the revision of the edges that the shells are of
    std::uint64_t revision_ = 0;
};

}  // namespace knotspan
