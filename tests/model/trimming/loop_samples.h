// Surfaces and loops for tests of trimming, and their comparison with polygons of the loops' own points.
#pragma once

#include <string>

#include "model/trimming/trim_index.h"

namespace knotspan::testing {

// Flat, degree 1: parameters are coordinates, and knots lie at these places.
[[nodiscard]] NurbsSurface flatSurface(const std::vector<double>& placesU,
                                       const std::vector<double>& placesV);
// Of 4 x 3 KSQuads over [-1, 3] x [10, 12].
[[nodiscard]] NurbsSurface flatSurface();
// A cylinder around z, u from 0 to 1 around it; closed in u.
[[nodiscard]] NurbsSurface roundSurface();
[[nodiscard]] TrimCurve polyline(const std::vector<Vec2>& places);
[[nodiscard]] TrimCurve circle(const Vec2& centre, double radius, bool anticlockwise = true);

struct Counts {
    int asked = 0;
    int inside = 0;
    int wrongRegion = 0;
    int wrongIndex = 0;  // further from the curves than float tells
    int wrongClass = 0;
    int wrongBox = 0;  // places that are not what the index said of a box around them
    int unsureBox = 0;
    int cutBox = 0;  // the curves run through it
};

// At random points of the domain, each further than `near` from the loops for the polygons.
[[nodiscard]] Counts compare(const std::vector<TrimLoop>& loops, const NurbsSurface& surface, double near,
                             int points = 3000, int samplesPerSpan = 200, bool startsInside = false);
void expectRight(const Counts& counts, const std::string& what);

}  // namespace knotspan::testing
