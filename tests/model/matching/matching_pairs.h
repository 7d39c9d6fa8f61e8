// Pairs of surfaces with a break between them, for tests of Match, and what they look like measured without
// any of its code.
#pragma once

#include <random>

#include "model/matching/match.h"

namespace knotspan::testing {

// Two surfaces owned by the pair; edges and direction as Friends would report them.
struct BrokenPair {
    NurbsSurface a;
    NurbsSurface b;
    EdgePart edgeA;
    EdgePart edgeB;
    bool reversed = false;

    [[nodiscard]] MatchRequest request(Continuity wanted, MatchSides move) const;
};

struct PairShape {
    int degreeA = 3;  // along the edge
    int degreeB = 5;
    int acrossA = 3;
    int acrossB = 3;
    int spansA = 4;
    int spansB = 5;
    bool rationalA = false;
    bool rationalB = false;
    double breakDeg = 5;
    double gap = 0.0;
    Side sideA = Side::endU;
    Side sideB = Side::startU;
    bool reversed = false;
};

// Both follow one wavy sheet, 10 along and 6 across, as closely as their knots let them, so their edges are
// apart by a little; b is turned by the break about the edge and lifted by the gap.
[[nodiscard]] BrokenPair brokenPair(std::mt19937& random, const PairShape& shape);

// Random shapes of the above.
[[nodiscard]] PairShape randomShape(std::mt19937& random);

struct MeasuredFit {
    double gap = 0;
    double angleDeg = 0;   // between normals, taken as unsigned planes
    bool runsOn = true;    // and not back
    double curvature = 0;  // largest relative difference of the normal curvature across the edge
};
// At `count` points along the whole edge of b; both in one space.
[[nodiscard]] MeasuredFit measuredFit(const BrokenPair& pair, int count);

// The pair with what was proposed in place.
[[nodiscard]] BrokenPair applied(BrokenPair pair, const MatchProposal& proposal);

// Expects that rows that are not named are those of the same surface with more knots, and that what is told
// of the move is so; returns how many rows are named.
int expectOnlyNamedRowsMoved(const NurbsSurface& before, const MatchedSurface& after);

}  // namespace knotspan::testing
