// One side of a match while it is worked on: its surface turned so that the edge comes first, and the rows
// moved so far.
#pragma once

#include "model/matching/edge_frame.h"
#include "model/matching/partner.h"

namespace knotspan {

class MovingSide {
public:
    // A surface of which the edge u = start is to move, in its own space.
    MovingSide(NurbsSurface surface, const Mat4& transform);

    // In model space.
    [[nodiscard]] const NurbsSurface& before() const { return before_; }
    [[nodiscard]] const NurbsSurface& now() const { return now_; }

    // More control points, the same shape. Rows moved so far go back to where they were.
    void raiseAcross(int degree);
    void raiseAlong(int degree);
    void insertAlong(const std::vector<double>& knots);

    // In model space.
    void moveRow(int row, const std::vector<ControlPoint>& points);

    [[nodiscard]] int firstRow() const { return firstRow_; }
    [[nodiscard]] int lastRow() const { return lastRow_; }

    // In its own space; rows that were not moved have their bits.
    [[nodiscard]] NurbsSurface result() const;

    // The largest distance between points of before and now at the same parameters, in model space.
    [[nodiscard]] double measuredMove() const;
    // An upper bound of it, from the control points.
    [[nodiscard]] double boundedMove() const;

private:
    void restart(NurbsSurface surface);

    NurbsSurface own_;
    Mat4 transform_;
    NurbsSurface before_;
    NurbsSurface now_;
    int firstRow_ = 0;
    int lastRow_ = -1;
};

}  // namespace knotspan
