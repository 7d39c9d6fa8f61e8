// The grid of fewest triangles that keeps a KSQuad within a tolerance in pixels: candidates from the closed
// form of screen_error.h, made smaller as long as a proof over parts of the net still holds.
//
// The promise, for every KSQuad and view: where the picture shows a triangle's point, the surface's point at
// the same (u, v) is no further off than the tolerance. Parts that cannot show (hull beyond a side of the
// picture or behind the near plane) ask for nothing. Of parts that cross the near plane only what is in front
// counts: there w >= z, which bounds w from below, and the shown point lies in the picture, which bounds s;
// so the one uniform grid is right for the whole KSQuad and nothing is split or left out.
#pragma once

#include "model/analysis/screen_error.h"

namespace knotspan {

// How cells are cut. `any` holds for all triangles that fit into a cell, as those that stitch a grid to the
// vertices of an edge of another factor; it asks for the most.
enum class Triangles { risingDiagonal, fallingDiagonal, eitherDiagonal, any };  // rising: (0, 0) to (1, 1)

// How far a proof may go: how often blocks of cells are halved, how often in each direction the error
// polynomial of a single cell (-1: it is not looked at), and how many blocks and parts of cells are
// divided in all. A proof
// that does not come to its end proves nothing: less effort gives larger grids, as true as others.
struct ProofEffort {
    int divisions = 64;
    int polynomialLevels = 2;
    int blocks = 2048;
};

// Whether every visible point of the grid's triangles is proved to be within the tolerance.
[[nodiscard]] bool keepsTolerance(const BezierNet& pixels, const ScreenView& view, const Grid& grid,
                                  double tolerance, Triangles triangles, const ProofEffort& effort = {});

struct GridChoice {
    Grid grid;
    bool visible = true;  // false: the picture shows nothing of it; the grid is then 1 x 1
    bool kept = true;     // false: even `largest` cells along a side were not enough; split the KSQuad
};

// tolerance > 0.
[[nodiscard]] GridChoice chooseGrid(const BezierNet& pixels, const ScreenView& view, double tolerance,
                                    Triangles triangles = Triangles::eitherDiagonal,
                                    int largest = kLargestFactor, const ProofEffort& effort = {});

}  // namespace knotspan
