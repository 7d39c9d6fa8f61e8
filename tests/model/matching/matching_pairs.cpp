#include "tests/model/matching/matching_pairs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/degree_elevation.h"
#include "model/geometry/evaluation.h"
#include "model/geometry/orientation.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

double greville(const KnotVector& knots, int i)
{
    double sum = 0;
    for (int k = 1; k <= knots.degree(); ++k)
        sum += knots[i + k];
    return sum / knots.degree();
}

// Knots that rise by 0.7 to 1.4 and stand there once.
KnotVector simpleKnots(std::mt19937& random, int degree, int spans)
{
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0);
    for (int k = 0; k < spans; ++k)
        knots.push_back(knots.back() + randomBetween(random, 0.7, 1.4));
    knots.insert(knots.end(), static_cast<size_t>(degree), knots.back());
    return KnotVector::create(degree, knots).value();
}

struct Sheet {
    double phase;
    double lift;   // of b
    double slope;  // of b, from the edge on

    [[nodiscard]] Vec3 at(double x, double y) const
    {
        const double beyond = std::max(0.0, x);
        return {x + 0.3 * std::sin(0.5 * y + phase), y,
                0.6 * std::sin(0.6 * x + 0.5 * y + phase) + 0.05 * x * x + (x >= 0 ? lift : 0) +
                    slope * beyond};
    }
};

// u from x = x0 to x1, v from y = 0 to 10.
NurbsSurface piece(std::mt19937& random, const Sheet& sheet, double x0, double x1, int degreeU, int degreeV,
                   int spans, bool rational)
{
    const KnotVector u = simpleKnots(random, degreeU, 3);
    const KnotVector v = simpleKnots(random, degreeV, spans);
    std::vector<ControlPoint> points;
    for (int i = 0; i < u.controlPointCount(); ++i)
        for (int j = 0; j < v.controlPointCount(); ++j) {
            const double x = x0 + (x1 - x0) * greville(u, i) / u.domainEnd();
            const double y = 10 * greville(v, j) / v.domainEnd();
            points.push_back({sheet.at(x == 0 && x1 > x0 && x0 == 0 ? 0.0 : x, y),
                              rational ? randomBetween(random, 0.8, 1.25) : 1.0});
        }
    return NurbsSurface::create(u, v, points).value();
}

// The surface's edge u = start or end (`atEnd`) comes to lie at `side`.
NurbsSurface withEdgeAt(NurbsSurface surface, bool atEnd, Side side)
{
    if (atEnd != (side == Side::endU || side == Side::endV))
        surface = reversed(surface, Direction::U);
    return side == Side::startV || side == Side::endV ? swapped(surface) : surface;
}

EdgePart wholeEdge(const NurbsSurface& surface, std::uint32_t index, Side side)
{
    const KnotVector& along =
        side == Side::startU || side == Side::endU ? surface.knotsV() : surface.knotsU();
    return {index, side, along.domainStart(), along.domainEnd()};
}

struct Place {
    SurfacePoint point;
    Vec3 normal{};
    Vec3 inward{};
    Vec3 inwardSecond{};
    Vec3 along{};
    double skew = 0;
};

Place placeOn(const NurbsSurface& surface, Side side, double t)
{
    const double u = side == Side::startU ? surface.knotsU().domainStart()
                     : side == Side::endU ? surface.knotsU().domainEnd()
                                          : t;
    const double v = side == Side::startV ? surface.knotsV().domainStart()
                     : side == Side::endV ? surface.knotsV().domainEnd()
                                          : t;
    Place place{evaluate(surface, u, v), evaluateNormal(surface, u, v).direction, {}, {}, {}, 0};
    const bool alongV = side == Side::startU || side == Side::endU;
    const double sign = side == Side::startU || side == Side::startV ? 1 : -1;
    place.inward = sign * (alongV ? place.point.du : place.point.dv);
    place.along = alongV ? place.point.dv : place.point.du;
    return place;
}

// The normal curvature at right angles to the edge, by the two fundamental forms; signed by `normal`.
double curvatureAcross(const SurfacePoint& at, const Vec3& along, const Vec3& normal)
{
    const Vec3 direction = glm::normalize(glm::cross(along, normal));
    const double e = glm::dot(at.du, at.du);
    const double f = glm::dot(at.du, at.dv);
    const double g = glm::dot(at.dv, at.dv);
    const double determinant = e * g - f * f;
    const double a = (g * glm::dot(direction, at.du) - f * glm::dot(direction, at.dv)) / determinant;
    const double b = (e * glm::dot(direction, at.dv) - f * glm::dot(direction, at.du)) / determinant;
    return a * a * glm::dot(at.duu, normal) + 2 * a * b * glm::dot(at.duv, normal) +
           b * b * glm::dot(at.dvv, normal);
}

}  // namespace

MatchRequest BrokenPair::request(Continuity wanted, MatchSides move) const
{
    MatchRequest request;
    request.a.surface = &a;
    request.b.surface = &b;
    request.edgeA = edgeA;
    request.edgeB = edgeB;
    request.reversed = reversed;
    request.wanted = wanted;
    request.move = move;
    return request;
}

BrokenPair brokenPair(std::mt19937& random, const PairShape& shape)
{
    Sheet sheet{randomBetween(random, 0, 6), 0, 0};
    NurbsSurface a = piece(random, sheet, -6, 0, shape.acrossA, shape.degreeA, shape.spansA, shape.rationalA);
    sheet.lift = shape.gap;
    sheet.slope = std::tan(shape.breakDeg * std::numbers::pi / 180);
    NurbsSurface b = piece(random, sheet, 0, 6, shape.acrossB, shape.degreeB, shape.spansB, shape.rationalB);
    if (shape.reversed)
        b = reversed(b, Direction::V);
    a = withEdgeAt(a, true, shape.sideA);
    b = withEdgeAt(b, false, shape.sideB);
    return {a, b, wholeEdge(a, 0, shape.sideA), wholeEdge(b, 1, shape.sideB), shape.reversed};
}

PairShape randomShape(std::mt19937& random)
{
    const auto whole = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(random);
    };
    PairShape shape;
    shape.degreeA = whole(2, 5);
    shape.degreeB = whole(2, 5);
    shape.acrossA = whole(2, 4);
    shape.acrossB = whole(2, 5);
    shape.spansA = whole(2, 6);
    shape.spansB = whole(2, 6);
    shape.rationalA = whole(0, 2) == 0;
    shape.rationalB = whole(0, 2) == 0;
    shape.breakDeg = whole(0, 1) == 0 ? 5 : -5;
    shape.gap = whole(0, 1) == 0 ? 0 : 0.03;
    shape.sideA = static_cast<Side>(whole(0, 3));
    shape.sideB = static_cast<Side>(whole(0, 3));
    shape.reversed = whole(0, 1) == 0;
    return shape;
}

MeasuredFit measuredFit(const BrokenPair& pair, int count)
{
    MeasuredFit fit;
    for (int k = 0; k <= count; ++k) {
        const double part = (k + 1e-7) / (count + 2e-7);
        const double tB = std::lerp(pair.edgeB.from, pair.edgeB.to, part);
        const double tA = std::lerp(pair.edgeA.from, pair.edgeA.to, pair.reversed ? 1 - part : part);
        const Place onA = placeOn(pair.a, pair.edgeA.side, tA);
        const Place onB = placeOn(pair.b, pair.edgeB.side, tB);
        fit.gap = std::max(fit.gap, glm::length(onA.point.position - onB.point.position));
        const double sine = glm::length(glm::cross(onA.normal, onB.normal));
        fit.angleDeg = std::max(fit.angleDeg, std::atan2(sine, std::abs(glm::dot(onA.normal, onB.normal))) *
                                                  180 / std::numbers::pi);
        const Vec3 beside = glm::cross(onA.normal, onA.along);
        fit.runsOn = fit.runsOn && glm::dot(beside, onA.inward) * glm::dot(beside, onB.inward) < 0;
        const double curvatureA = curvatureAcross(onA.point, onA.along, onA.normal);
        const double curvatureB = curvatureAcross(onB.point, onB.along, onA.normal);
        fit.curvature =
            std::max(fit.curvature, std::abs(curvatureA - curvatureB) /
                                        std::max({std::abs(curvatureA), std::abs(curvatureB), 0.02}));
    }
    return fit;
}

BrokenPair applied(BrokenPair pair, const MatchProposal& proposal)
{
    if (proposal.a)
        pair.a = proposal.a->surface;
    if (proposal.b)
        pair.b = proposal.b->surface;
    return pair;
}

namespace {

NurbsSurface refinedLike(NurbsSurface surface, const NurbsSurface& pattern)
{
    for (const Direction direction : {Direction::U, Direction::V}) {
        const auto knots = [direction](const NurbsSurface& of) -> const KnotVector& {
            return direction == Direction::U ? of.knotsU() : of.knotsV();
        };
        surface = withDegree(surface, direction, knots(pattern).degree());
        std::vector<double> missing;
        std::set_difference(knots(pattern).values().begin(), knots(pattern).values().end(),
                            knots(surface).values().begin(), knots(surface).values().end(),
                            std::back_inserter(missing));
        surface = withKnotsInserted(surface, direction, missing);
    }
    return surface;
}

}  // namespace

int expectOnlyNamedRowsMoved(const NurbsSurface& before, const MatchedSurface& after)
{
    const NurbsSurface refined = refinedLike(before, after.surface);
    EXPECT_EQ(refined.knotsU(), after.surface.knotsU());
    EXPECT_EQ(refined.knotsV(), after.surface.knotsV());
    double largest = 0;
    for (int i = 0; i < refined.countU(); ++i)
        for (int j = 0; j < refined.countV(); ++j) {
            const int row = after.across == Direction::U ? i : j;
            const ControlPoint& x = refined.controlPoint(i, j);
            const ControlPoint& y = after.surface.controlPoint(i, j);
            const double move = glm::length(x.position - y.position);
            if (row >= after.firstRow && row <= after.lastRow)
                largest = std::max(largest, move);
            else {
                EXPECT_LE(move, 1e-12);
                EXPECT_NEAR(x.weight, y.weight, 1e-12);
            }
        }
    EXPECT_LE(largest, after.movedMost + 1e-12);
    EXPECT_LE(after.moved, after.movedMost + 1e-12);
    return after.lastRow - after.firstRow + 1;
}

}  // namespace knotspan::testing
