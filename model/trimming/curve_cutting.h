// Trim curves cut into rational Bézier arcs that only ever rise or only ever fall, in u and in v, and lie in
// one KSQuad each.
//
// Arcs that follow each other share their common end to the bit, so that who counts crossings never counts
// one twice or not at all.
#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry/trim_loop.h"

namespace knotspan {

// A rational Bézier curve: its control points. Part of a trim curve, from its parameter `from` to `to`.
struct TrimArc {
    std::vector<TrimPoint> points;
    double from = 0;
    double to = 1;

    [[nodiscard]] const Vec2& start() const { return points.front().position; }
    [[nodiscard]] const Vec2& end() const { return points.back().position; }
};

// Over the whole of its spans, in order; neighbours share their ends.
[[nodiscard]] std::vector<TrimArc> bezierArcs(const TrimCurve& curve);

// The two parts below and above t of 0 to 1 (de Casteljau).
[[nodiscard]] std::pair<TrimArc, TrimArc> split(const TrimArc& arc, double t);
// The place at t of 0 to 1.
[[nodiscard]] Vec2 placeOf(const std::vector<TrimPoint>& points, double t);

// The lines to cut at: along each axis the places, increasing; and lengths that count as nothing.
struct CuttingLines {
    std::vector<double> places[2];
    Vec2 nothing;

    // At the knots, and near enough to nothing: 1e-11 of the domain.
    [[nodiscard]] static CuttingLines of(const KnotVector& knotsU, const KnotVector& knotsV);
    [[nodiscard]] Vec2 low() const { return {places[0].front(), places[1].front()}; }
    [[nodiscard]] Vec2 high() const { return {places[0].back(), places[1].back()}; }
    // Onto a line that is so near that the way there is nothing.
    [[nodiscard]] Vec2 snapped(Vec2 place) const;
};

// In order, each with a control polygon that is monotone along both axes (so the arc is, too: it crosses no
// line more often than its polygon does), on one side of each line. Ends that lie on a line do so to the bit.
[[nodiscard]] std::vector<TrimArc> cutArcs(const TrimArc& arc, const CuttingLines& lines);

}  // namespace knotspan
