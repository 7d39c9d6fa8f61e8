// The borders of placed surfaces as Bézier curves in model space, one for each KSQuad side that is its
// surface's border, and how those sides and the corners between them are numbered.
//
// A surface of m x n KSQuads has 2 (m + n) border sides, numbered by border in the order of `Side`, each
// along its parameter; and as many border corners: the rows v = start and v = end whole, then what is left of
// the columns u = start and u = end. The next surface's numbers follow.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/geometry/bezier_conversion.h"
#include "model/geometry/trim_loop.h"

namespace knotspan {

// What it points to is only looked at during the call it is given to.
struct PlacedSurface {
    const NurbsSurface* surface = nullptr;
    Mat4 transform{1.0};                               // affine
    const std::vector<TrimLoop>* trimLoops = nullptr;  // for those that ask about edges; null: none
};

// Surface `index` of several is now this one.
struct SurfaceChange {
    std::uint32_t index = 0;
    PlacedSurface placed;
};

// Where the KSQuads and the borders of one surface stand among those of all.
struct BorderNumbers {
    std::uint32_t spansU = 0;
    std::uint32_t spansV = 0;
    std::uint32_t firstKsquad =
        0;  // KSQuad (a, b) is number firstKsquad + a spansV + b, as ksQuads() has them
    std::uint32_t firstBorder = 0;  // of its sides and of its corners

    [[nodiscard]] std::uint32_t borderCount() const { return 2 * (spansU + spansV); }
    // Of lattice place (i, j) on the border, 0 <= i <= spansU.
    [[nodiscard]] std::uint32_t corner(std::uint32_t i, std::uint32_t j) const;
    // The corners at the parameter's start and end of border side firstBorder + k.
    [[nodiscard]] std::array<std::uint32_t, 2> cornersOf(std::uint32_t k) const;
    // 4 KSQuad + Side of border side firstBorder + k.
    [[nodiscard]] std::uint32_t sideName(std::uint32_t k) const;
    // Of lattice place (i, j), the least 4 KSQuad + corner; the corner is 1 for u's end, 2 for v's.
    [[nodiscard]] std::uint32_t cornerName(std::uint32_t i, std::uint32_t j) const;
};
[[nodiscard]] std::vector<BorderNumbers> borderNumbers(const std::vector<PlacedSurface>& surfaces);

// In the order of the numbers.
[[nodiscard]] std::vector<BezierNet> borderCurves(const PlacedSurface& placed);

}  // namespace knotspan
