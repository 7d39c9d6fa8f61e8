// How far triangles of any shape, and chords of an outline, may be from a face: proved, before any is made.
//
// Within the outline a triangle is as good as its box in the parameters (space_error.h). Between the
// outline's curve and its chord lies a sliver that triangles lack or have too much. Each of its points is as
// far from a point of the chord as the curve's control points are, at most, which no surface point moves
// faster than its KSQuad's speed; and the chord is as good as a triangle with its box.
#pragma once

#include "model/mesh/cell_counts.h"
#include "model/trimming/face_outline.h"

namespace knotspan {

class FaceErrors {
public:
    // Of the KSQuads from `first` on, `countV` along v. With `keepsCells` no triangle may be larger than the
    // cells that the KSQuad asks for, whatever it is off by.
    FaceErrors(const CellCounts& counts, const KsQuadShapes& shapes, std::uint32_t first, int countV,
               double deviation, bool keepsCells)
        : counts_(counts),
          shapes_(shapes),
          first_(first),
          countV_(countV),
          deviation_(deviation),
          keepsCells_(keepsCells)
    {
    }

    // What of a deviation cells may use up.
    static constexpr double kForCells = 0.7;

    [[nodiscard]] const Grid& grid(int a, int b) const { return counts_.grids[number(a, b)]; }
    // A triangle or a chord with a box of that size.
    [[nodiscard]] double bound(int a, int b, const Vec2& size) const;
    [[nodiscard]] bool isFine(int a, int b, const Vec2& size) const;
    // In cells: what to cut is what is longest.
    [[nodiscard]] double lengthInCells(int a, int b, const Vec2& size) const
    {
        return std::max(size.x * grid(a, b).u, size.y * grid(a, b).v);
    }
    // How far a place is beyond a KSQuad, in space, at most.
    [[nodiscard]] double spill(int a, int b, const OutlinePlace& place) const;
    // Of a part of an arc: how far its chord is from the surface, how far points of its sliver are from
    // points of the chord, ...
    [[nodiscard]] double chord(const OutlineArc& arc, double from, double to) const;
    [[nodiscard]] double sliver(const OutlineArc& arc, double from, double to) const;
    // ... and, of one inside a KSQuad, whether its chord may stand for it.
    [[nodiscard]] bool isFine(const OutlineArc& arc, double from, double to) const;

    [[nodiscard]] bool isNothing(double sliver) const { return sliver <= 1e-9 * deviation_; }

private:
    [[nodiscard]] size_t number(int a, int b) const
    {
        return first_ + static_cast<size_t>(a) * static_cast<size_t>(countV_) + static_cast<size_t>(b);
    }

    const CellCounts& counts_;
    const KsQuadShapes& shapes_;
    std::uint32_t first_;
    int countV_;
    double deviation_;
    bool keepsCells_;
};

}  // namespace knotspan
