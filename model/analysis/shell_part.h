// What one surface adds to a shell, in model space, known from the surface alone: boxes, corners, the volume
// it sweeps. Immutable.
#pragma once

#include <memory>

#include "model/analysis/border_curves.h"

namespace knotspan {

// Seen from a point o, a surface sweeps a volume, positive where S_u x S_v, taken in model space, points away
// from o; those of a closed body add up to its volume.
struct SweptVolume {
    Vec3 from{};  // the point that `volume` is told from
    double volume = 0;
    Vec3 area{};       // the integral of the normals
    double error = 0;  // of the volume, about
    double areaError = 0;

    [[nodiscard]] double seenFrom(const Vec3& point) const;
    [[nodiscard]] double errorFrom(const Vec3& point) const;
};

class ShellPart {
public:
    explicit ShellPart(const PlacedSurface& placed);

    [[nodiscard]] std::uint32_t spansU() const { return spansU_; }
    [[nodiscard]] std::uint32_t spansV() const { return spansV_; }

    // Of the control points of the KSQuads' Bézier nets: of all, and of KSQuad (a, b).
    [[nodiscard]] const Box& box() const { return box_; }
    [[nodiscard]] const Box& box(std::uint32_t a, std::uint32_t b) const { return boxes_[a * spansV_ + b]; }

    // Lattice point (i, j), 0 <= i <= spansU.
    [[nodiscard]] const Vec3& corner(std::uint32_t i, std::uint32_t j) const
    {
        return corners_[i * (spansV_ + 1) + j];
    }

    // Integrates each time.
    [[nodiscard]] SweptVolume sweptVolume() const;
    [[nodiscard]] BezierNet net(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] bool isMirrored() const { return mirrored_; }
    // Whether another one, of the same knots, has the same KSQuad (a, b), to the bit.
    [[nodiscard]] bool isSameAt(std::uint32_t a, std::uint32_t b, const ShellPart& other) const;

private:
    // The conversion looks at the surface.
    struct Nets {
        explicit Nets(const NurbsSurface& of) : surface(of), conversion(surface) {}
        NurbsSurface surface;
        BezierConversion conversion;
    };

    Mat4 transform_;
    std::unique_ptr<const Nets> nets_;
    std::uint32_t spansU_;
    std::uint32_t spansV_;
    bool mirrored_;
    Box box_;
    std::vector<Box> boxes_;
    std::vector<Vec3> corners_;
};

}  // namespace knotspan
