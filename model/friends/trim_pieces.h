// A trim curve as short polynomials of low degree, each inside one KSQuad, which can be put into the surface
// exactly.
#pragma once

#include <functional>

#include "model/friends/bernstein_products.h"
#include "model/geometry/trim_loop.h"

namespace knotspan {

struct TrimPiece {
    double from = 0;  // the curve's parameter
    double to = 1;
    int spanU = 0;  // the KSQuad's knot spans
    int spanV = 0;
    // Coefficients of the Bernstein basis over the piece, of places that are 0 to 1 across the KSQuad; one
    // where the place does not change.
    Scalars u;
    Scalars v;
    double deviation = 0;  // in space: no point of the curve is further away at the same parameter
};

struct TrimAccuracy {
    double deviation = 0;  // in space, of a piece
    int degree = 1;        // of a piece at most; 1, 2 or 3
    // How far a point of the surface moves at most, by each of the places on a KSQuad.
    std::function<Vec2(int spanU, int spanV)> speeds;
};

// In order, without holes. Where the curve runs along a knot line, pieces lie in the KSQuad to its left. At
// 512 pieces of one of its spans in one KSQuad no more are made, and their deviation says what is missing.
[[nodiscard]] std::vector<TrimPiece> trimPieces(const TrimCurve& curve, const KnotVector& knotsU,
                                                const KnotVector& knotsV, const TrimAccuracy& accuracy);

}  // namespace knotspan
