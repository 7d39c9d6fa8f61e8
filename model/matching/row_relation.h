// How the rows of control points on the two sides of a smooth edge hang together, where that is simple
// enough to be kept while they move.
#pragma once

#include "model/friends/friends.h"

namespace knotspan {

// Where a control point stands in a surface's net, counted from one of its edges.
class NetRows {
public:
    NetRows(const NurbsSurface& surface, Side side) : surface_(&surface), side_(side) {}

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

// The two sides of an edge.
struct EdgeRows {
    PlacedSurface placedA;
    PlacedSurface placedB;
    NetRows a;
    NetRows b;
    bool reversed = false;

    EdgeRows(const FriendEdge& edge, const PlacedSurface& ofA, const PlacedSurface& ofB);

    // Of b's row, the number that goes with k of a's.
    [[nodiscard]] int alongB(int k) const { return reversed ? b.length() - 1 - k : k; }
};

// Whether the edge stays closed when points k of the two rows 0 move by the same: whole edges, one degree,
// the same knots but for an affine map, rows that begin at the edge, the same points to the gap tolerance,
// the same weights but for a factor. Otherwise why not.
[[nodiscard]] Result<void> requireSameRows(const FriendEdge& edge, const EdgeRows& rows, double gap);

// Of an edge with the same rows. Fails where rows 1 do not hang together like that, or where the rows 0 do
// not run as much alike as tangent planes need it.
[[nodiscard]] Result<RowRelation> rowRelation(const EdgeRows& rows);

}  // namespace knotspan
