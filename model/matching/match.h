// Match: makes an edge G0, G1 or G2 with the edge it runs along, by moving as few rows of control points as
// that takes: the edge's own, the next, the one after it.
//
// The edge's own row becomes the other edge exactly (one degree, one set of knots along it); the rows behind
// it are fitted by least squares, with knots inserted along the edge only where the tolerance is not reached
// otherwise. An edge that already runs within the gap of one that is parametrized differently is left where
// it is.
#pragma once

#include <optional>

#include "model/friends/friends.h"

namespace knotspan {

enum class MatchSides { a, b, both };

struct MatchRequest {
    PlacedSurface a;
    PlacedSurface b;
    // As found by Friends. The same `surface` in both: a seam; a and b are then the same surface.
    EdgePart edgeA;
    EdgePart edgeB;
    bool reversed = false;
    Continuity wanted = Continuity::g1;  // g0, g1 or g2
    MatchSides move = MatchSides::b;     // `both` meets in the middle
    FriendTolerances tolerances{1e-3, 0.01, 0.01};
};

// A surface that takes the place of the one before. Where knots or degrees rose it is the same surface again
// with more rows; apart from that no control point differs outside rows `firstRow` to `lastRow`.
struct MatchedSurface {
    NurbsSurface surface;
    Direction across = Direction::U;  // rows are counted along it
    int firstRow = 0;                 // of the new net; lastRow < firstRow where nothing had to move
    int lastRow = -1;
    double moved = 0;      // the largest distance between points of before and after, measured at many (u, v)
    double movedMost = 0;  // and a bound that it is guaranteed not to exceed
};

struct MatchProposal {
    std::optional<MatchedSurface> a;  // where that side moves
    std::optional<MatchedSurface> b;
    // What is left, measured at many points along the edge.
    double gap = 0;
    double angleDeg = 0;
    double curvature = 0;      // largest difference of normal curvatures, 1/unit
    double curvaturePart = 0;  // the same as a part of the larger one, as FriendTolerances limit it
};

// Fails, with a sentence that says why, where the tolerances cannot be reached: a moved edge of which only a
// part takes part, no tangent plane along it, surfaces that meet at more than 90 degrees, a kink along the
// edge that rows of the other side cannot follow. Transforms are affine and invertible.
[[nodiscard]] Result<MatchProposal> matchEdge(const MatchRequest& request);

}  // namespace knotspan
