#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "model/samples/samples.h"

namespace knotspan {

namespace {

constexpr int kSpans = 5;  // of a surface, each way
constexpr int kSurfacesRound = 12;
constexpr int kSurfacesAlong = 50;
constexpr int kRound = kSurfacesRound * kSpans;     // control points round the tube
constexpr int kStations = kSurfacesAlong * kSpans;  // and along it
constexpr double kRadius = 0.72;

double angleOf(int index, int count)
{
    return 2 * std::numbers::pi * index / count;
}

// A trefoil: it winds twice round a torus of radii 2 and 1, and three times round its tube.
Vec3 trefoil(double t)
{
    const double distance = 2 + std::cos(3 * t);
    return {distance * std::cos(2 * t), distance * std::sin(2 * t), 1.15 * std::sin(3 * t)};
}

Vec3 trefoilTangent(double t)
{
    const double distance = 2 + std::cos(3 * t);
    const double change = -3 * std::sin(3 * t);
    return glm::normalize(Vec3(change * std::cos(2 * t) - 2 * distance * std::sin(2 * t),
                               change * std::sin(2 * t) + 2 * distance * std::cos(2 * t),
                               3.45 * std::cos(3 * t)));
}

// A vector across the tube that turns no more than it must from one station to the next. Wang, Juettler,
// Zheng, Liu, Computation of rotation minimizing frames (2008): two reflections.
Vec3 carried(const Vec3& across, double from, double to)
{
    const Vec3 step = trefoil(to) - trefoil(from);
    const auto reflected = [](const Vec3& x, const Vec3& mirror) {
        return x - mirror * (2 * glm::dot(mirror, x) / glm::dot(mirror, mirror));
    };
    const Vec3 turned = reflected(trefoilTangent(from), step);
    return reflected(reflected(across, step), trefoilTangent(to) - turned);
}

struct Frame {
    Vec3 across;  // unit, at right angles to the tube
    Vec3 beside;  // tangent x across
};

// One frame a station; the turn left over after one round is spread over all of them.
std::array<Frame, kStations> frames()
{
    std::array<Vec3, kStations + 1> across;
    across[0] = glm::normalize(glm::cross(trefoilTangent(0), Vec3(0, 0, 1)));
    for (int k = 0; k < kStations; ++k)
        across[static_cast<size_t>(k) + 1] =
            carried(across[static_cast<size_t>(k)], angleOf(k, kStations), angleOf(k + 1, kStations));
    const Vec3 beside = glm::cross(trefoilTangent(0), across[0]);
    const double leftOver =
        std::atan2(glm::dot(across[kStations], beside), glm::dot(across[kStations], across[0]));

    std::array<Frame, kStations> result;
    for (int k = 0; k < kStations; ++k) {
        const double turn = -leftOver * k / kStations;
        const Vec3 a = across[static_cast<size_t>(k)];
        const Vec3 b = glm::cross(trefoilTangent(angleOf(k, kStations)), a);
        const Vec3 turned = std::cos(turn) * a + std::sin(turn) * b;
        result[static_cast<size_t>(k)] = {turned, glm::cross(trefoilTangent(angleOf(k, kStations)), turned)};
    }
    return result;
}

// Bumps of up to 23 % of the radius, without a seam in either direction.
double radiusAt(double around, double along)
{
    return kRadius *
           (1 + 0.13 * std::sin(18 * along) * std::cos(3 * around) + 0.07 * std::cos(7 * along + 2 * around));
}

using Net = std::vector<Vec3>;  // point (i, j) at i * kStations + j

Net periodicNet()
{
    const auto frame = frames();
    Net net;
    net.reserve(static_cast<size_t>(kRound) * kStations);
    for (int i = 0; i < kRound; ++i)
        for (int j = 0; j < kStations; ++j) {
            const double around = angleOf(i, kRound);
            const double along = angleOf(j, kStations);
            const Frame& here = frame[static_cast<size_t>(j)];
            net.push_back(trefoil(along) + radiusAt(around, along) * (std::cos(around) * here.across +
                                                                      std::sin(around) * here.beside));
        }
    return net;
}

// The part of 5 x 5 spans that begins at control point (firstU, firstV) of the closed net. Every part uses
// the same knots, so neighbours compute their common border from equal numbers in equal steps.
NurbsSurface part(const Net& net, int firstU, int firstV)
{
    const KnotVector knots = uniformKnots(3, kSpans + 3, -3);
    const NurbsSurface unclamped = surfaceOf(knots, knots, [&](int i, int j) -> ControlPoint {
        const int row = (firstU + i) % kRound;
        const int column = (firstV + j) % kStations;
        return {net[static_cast<size_t>(row) * kStations + static_cast<size_t>(column)], 1};
    });
    return clampedPart(clampedPart(unclamped, Direction::U, 0, kSpans), Direction::V, 0, kSpans);
}

}  // namespace

Scene makeKnot()
{
    const Net net = periodicNet();
    Scene scene;
    for (int along = 0; along < kSurfacesAlong; ++along)
        for (int round = 0; round < kSurfacesRound; ++round) {
            const double hue = 205 + 45 * std::sin(angleOf(along, kSurfacesAlong)) +
                               6 * std::cos(angleOf(round, kSurfacesRound));
            scene.add(namedObject("Tube " + std::to_string(along + 1) + "." + std::to_string(round + 1),
                                  colourOf(hue, 0.5, 0.87), part(net, kSpans * round, kSpans * along)));
        }
    return scene;
}

}  // namespace knotspan
