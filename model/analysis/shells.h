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

    // `edges` have been given the changes. Looks again at the changed surfaces, and at what joins all.
    void update(const std::vector<CoincidentEdges::Change>& changes, const CoincidentEdges& edges);

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
    struct Shell {
        std::vector<std::uint32_t> surfaces;
        bool closed = false;
        std::shared_ptr<const ShellMesh> mesh;  // where surfaces have sides
    };

    void join(const CoincidentEdges& edges);
    void findSides(Shell& shell, const std::vector<char>& turned, const CoincidentEdges& edges);

    std::vector<std::shared_ptr<const ShellPart>> parts_;
    std::vector<std::uint32_t> shellOf_;
    std::vector<int> sides_;
    std::vector<Shell> shells_;
    ShellCrossings crossings_;
};

}  // namespace knotspan
