// How the rows of control points on the two sides of a smooth edge hang together, where that is simple
// enough to be kept while they move.
#pragma once

#include "model/friends/friends.h"

namespace knotspan {

// Where a control point stands in a surface's net, counted from one of its edges.
class EdgeRows {
public:
    EdgeRows(const NurbsSurface& surface, Side side) : surface_(&surface), side_(side) {}

    [[nodiscard]] int length() const;  // of a row
    [[nodiscard]] int count() const;   // of rows
    [[nodiscard]] const KnotVector& along() const;
    [[nodiscard]] bool isClamped() const;           // otherwise row 0 is not the edge
    [[nodiscard]] int index(int row, int k) const;  // into controlPoints(); row 0 is the edge
    [[nodiscard]] const ControlPoint& at(int row, int k) const;

private:
    const NurbsSurface* surface_;
    Side side_;
};

// Row 1 of b is a times the edge plus b times row 1 of a, in homogeneous points, all along: then the two
// surfaces are G1 whatever the rows are, as b is below zero.
struct RowRelation {
    double ofEdge = 0;
    double ofRow = 0;
};

// Whether point k of one edge's row goes with point k, or last - k, of the other's: whole edges, one degree,
// the same knots but for an affine map, rows that begin at the edge. Otherwise why not.
[[nodiscard]] Result<void> requireSameRows(const FriendEdge& edge, const EdgeRows& a, const EdgeRows& b);

// Fails where rows 1 do not hang together like that. Transforms are those of a and b.
[[nodiscard]] Result<RowRelation> rowRelation(const FriendEdge& edge, const EdgeRows& a, const Mat4& placeA,
                                              const EdgeRows& b, const Mat4& placeB);

}  // namespace knotspan
