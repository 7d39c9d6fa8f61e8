#include <algorithm>
#include <cmath>

#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "model/samples/samples.h"

namespace knotspan {

namespace {

constexpr int kSpansAlong = 15;
constexpr int kSpansUp = 6;
constexpr int kCuts[] = {0, 5, 10, 15};

double squared(double x)
{
    return x * x;
}

// Where the starboard half stands: s from the transom (0) to the stem (1), t from the keel (0) to the deck
// (1). Metres; x forward, y to port, z up.
Vec3 starboardAt(double s, double t)
{
    const double fore = std::max(0.0, s - 0.62) / 0.38;
    const double aft = std::max(0.0, 0.4 - s) / 0.4;
    const double keel = 1.5 * squared(fore) + 0.5 * squared(aft);
    const double deck = 3.1 + 0.3 * squared(aft) + 1.9 * std::pow(s, 2.5);
    const double halfBeam = 3.3 * (1 - 0.16 * squared(aft) - std::pow(std::max(0.0, s - 0.35) / 0.65, 2.4));

    // Round bilges amidships, straight V and flare at the bow.
    const double bow = s * s * (3 - 2 * s);
    const double round = 1 - std::pow(1 - t, 2.6 - 1.5 * bow);
    const double flare = std::pow(t, 1.7);
    const double y = halfBeam * ((1 - 0.45 * bow) * round + 0.45 * bow * flare);
    const double rise = 0.55 * t + 0.45 * t * t;
    const double x = 26.8 * s + 3.2 * t * std::pow(s, 5) - 0.5 * t * std::pow(1 - s, 4);
    return {x, std::max(0.0, y) == 0.0 ? 0.0 : -y, keel + (deck - keel) * rise};
}

// The other side of the ship, turned round along u so that the normals point outwards again.
NurbsSurface mirrored(const NurbsSurface& side)
{
    std::vector<double> knots = side.knotsU().values();
    std::reverse(knots.begin(), knots.end());
    for (double& knot : knots)
        knot = kSpansAlong - knot;
    auto knotsU = KnotVector::create(side.degreeU(), std::move(knots));
    check(knotsU.has_value(), "mirrored knots are valid");
    return surfaceOf(*knotsU, side.knotsV(), [&](int i, int j) {
        ControlPoint point = side.controlPoint(side.countU() - 1 - i, j);
        point.position.y = point.position.y == 0.0 ? 0.0 : -point.position.y;
        return point;
    });
}

}  // namespace

Scene makeHull()
{
    const KnotVector along = clampedIntegerKnots(3, kSpansAlong);
    const KnotVector up = clampedIntegerKnots(3, kSpansUp);
    const NurbsSurface starboard = surfaceOf(along, up, [&](int i, int j) -> ControlPoint {
        return {starboardAt(grevilleAbscissa(along, i) / kSpansAlong, grevilleAbscissa(up, j) / kSpansUp), 1};
    });

    Scene scene;
    scene.setUnits("m");
    const char* const names[] = {"aft", "midships", "fore"};
    for (int part = 0; part < 3; ++part) {
        const NurbsSurface piece = clampedPart(starboard, Direction::U, kCuts[part], kCuts[part + 1]);
        const std::string name = names[part];
        scene.add(namedObject("Starboard " + name, colourOf(140 + 10 * part, 0.35, 0.72), piece));
        scene.add(namedObject("Port " + name, colourOf(8 + 8 * part, 0.45, 0.8), mirrored(piece)));
    }
    return scene;
}

}  // namespace knotspan
