// Trim curves as edges: against the surface's own points, the surface beyond the curve, and known angles.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "model/friends/edge_profile.h"
#include "model/friends/scene_friends.h"
#include "model/friends/trim_pieces.h"
#include "model/geometry/evaluation.h"
#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

using Places = std::vector<Vec2>;

TrimCurve curveOf(const KnotVector& knots, const Places& places, const std::vector<double>& weights)
{
    std::vector<TrimPoint> points;
    for (size_t k = 0; k < places.size(); ++k)
        points.push_back({places[k], weights[k]});
    return TrimCurve::create(knots, std::move(points)).value();
}
TrimCurve line(const Vec2& from, const Vec2& to)
{
    return curveOf(KnotVector::clampedUniform(1, 1), {from, to}, {1, 1});
}
TrimCurve turned(const TrimCurve& curve)
{
    std::vector<double> knots;
    for (const double knot : curve.knots().values())
        knots.insert(knots.begin(), curve.knots().domainStart() + curve.knots().domainEnd() - knot);
    std::vector<TrimPoint> points(curve.points().rbegin(), curve.points().rend());
    return TrimCurve::create(KnotVector::create(curve.knots().degree(), knots).value(), points).value();
}

// A smooth surface over [0, 4] x [0, 4] with interior knots at whole numbers.
NurbsSurface smoothSurface(std::mt19937& random, int degree, bool rational)
{
    const KnotVector knots = clampedIntegerKnots(degree, 4);
    return surfaceOf(knots, knots, [&](int i, int j) {
        return ControlPoint{
            {grevilleAbscissa(knots, i), grevilleAbscissa(knots, j), randomBetween(random, -0.5, 0.5)},
            rational ? randomBetween(random, 0.5, 2) : 1};
    });
}

// Upwards across [0, 4] x [0, 4], from v = 0 to v = 4, across several knot lines.
TrimCurve crossing(std::mt19937& random, bool rational)
{
    const KnotVector knots = clampedIntegerKnots(3, 2);
    Places places;
    std::vector<double> weights;
    for (int k = 0; k < knots.controlPointCount(); ++k) {
        places.emplace_back(randomBetween(random, 0.6, 3.4), 4.0 * k / (knots.controlPointCount() - 1));
        weights.push_back(rational ? randomBetween(random, 0.5, 2) : 1);
    }
    return curveOf(knots, places, weights);
}

// What lies to the left of a curve across, and to its right.
SceneObject leftOf(const TrimCurve& curve, NurbsSurface surface)
{
    SceneObject object{"left", {}, Mat4(1), true, std::move(surface), {}};
    const Vec2 low = curve.points().front().position;
    const Vec2 high = curve.points().back().position;
    object.trimLoops = {{true, {curve, line(high, {0, 4}), line({0, 4}, {0, 0}), line({0, 0}, low)}}};
    return object;
}
SceneObject rightOf(const TrimCurve& curve, NurbsSurface surface)
{
    SceneObject object{"right", {}, Mat4(1), true, std::move(surface), {}};
    const Vec2 low = curve.points().front().position;
    const Vec2 high = curve.points().back().position;
    object.trimLoops = {{true, {line(low, {4, 0}), line({4, 0}, {4, 4}), line({4, 4}, high), turned(curve)}}};
    return object;
}

Friends friendsOf(const std::vector<SceneObject>& objects, const FriendTolerances& tolerances = {})
{
    std::vector<PlacedSurface> surfaces;
    for (const SceneObject& object : objects)
        surfaces.push_back(placed(object));
    return Friends(surfaces, tolerances);
}

}  // namespace

TEST(TrimPieces, LieWithinTheirDeviationAndTheirKsQuad)
{
    std::mt19937 random(81);
    size_t pieces = 0;
    for (int round = 0; round < 60; ++round) {
        const int degree = 1 + round % 4;
        const NurbsSurface surface = smoothSurface(random, degree, false);
        const TrimCurve curve = crossing(random, round % 2 == 1);
        const int most = 1 + round % 3;
        const double asked = std::pow(10.0, randomBetween(random, most == 1 ? -3 : -6, -2));
        // No point of these surfaces moves more than this by a whole KSQuad.
        const auto speeds = [](int, int) { return Vec2(20); };
        const auto found = trimPieces(curve, surface.knotsU(), surface.knotsV(), {asked, most, speeds});
        double end = curve.knots().domainStart();
        for (const TrimPiece& piece : found) {
            EXPECT_EQ(piece.from, end);
            end = piece.to;
            EXPECT_LE(piece.deviation, asked);
            EXPECT_LE(std::max(piece.u.size(), piece.v.size()), 1U + static_cast<size_t>(most));
            for (const double t : {0.0, 0.13, 0.5, 0.77, 1.0}) {
                const auto value = [t](const Scalars& bernstein) {
                    Scalars points = bernstein;
                    for (size_t level = points.size() - 1; level > 0; --level)
                        for (size_t k = 0; k < level; ++k)
                            points[k] += t * (points[k + 1] - points[k]);
                    return points[0];
                };
                const Vec2 local(value(piece.u), value(piece.v));
                EXPECT_TRUE(local.x > -1e-6 && local.x < 1 + 1e-6 && local.y > -1e-6 && local.y < 1 + 1e-6);
                const Vec2 at(surface.knotsU()[piece.spanU] + local.x,
                              surface.knotsV()[piece.spanV] + local.y);
                const Vec2 wanted = curve.evaluate(piece.from + t * (piece.to - piece.from));
                const Vec3 way =
                    evaluate(surface, at.x, at.y).position - evaluate(surface, wanted.x, wanted.y).position;
                EXPECT_LE(glm::length(way), piece.deviation + 1e-13);
            }
        }
        EXPECT_EQ(end, curve.knots().domainEnd());
        pieces += found.size();
    }
    EXPECT_LT(pieces, 60 * 200U);
}

TEST(Trimmed, BothSidesOfACurveAcrossASmoothSurfaceAreG2Friends)
{
    std::mt19937 random(82);
    for (int round = 0; round < 24; ++round) {
        const NurbsSurface surface = smoothSurface(random, 3 + round % 2, round % 3 == 1);
        const TrimCurve curve = crossing(random, round % 4 >= 2);
        const Friends friends = friendsOf({leftOf(curve, surface), rightOf(curve, surface)});
        ASSERT_EQ(friends.edges().size(), 1U) << round;
        const FriendEdge& edge = friends.edges()[0];
        EXPECT_EQ(edge.a.trim, (TrimPlace{0, 0}));
        EXPECT_EQ(edge.b.trim, (TrimPlace{0, 3}));
        EXPECT_TRUE(edge.reversed);
        EXPECT_EQ(edge.a.from, curve.knots().domainStart());
        EXPECT_EQ(edge.a.to, curve.knots().domainEnd());
        EXPECT_STREQ(continuityName(edge.continuity), "G2") << round;
        EXPECT_LE(edge.gapMax, 3e-6);
        EXPECT_LE(edge.angleBoundDeg, 0.01);
        EXPECT_EQ(friends.nakedEdges().size(), 6U);
    }
}

TEST(Trimmed, ACurveMeetsAWholeSideOfAnotherSurface)
{
    std::mt19937 random(83);
    const NurbsSurface surface = smoothSurface(random, 3, true);
    SceneObject right = rightOf(line({2.5, 0}, {2.5, 4}), surface);
    right.trimLoops.clear();
    right.surface = clampedPart(surface, Direction::U, 2.5, 4);
    const Friends friends = friendsOf({leftOf(line({2.5, 0}, {2.5, 4}), surface), right});
    ASSERT_EQ(friends.edges().size(), 1U);
    EXPECT_EQ(friends.edges()[0].a.trim, (TrimPlace{0, 0}));
    EXPECT_FALSE(friends.edges()[0].b.trim);
    EXPECT_EQ(friends.edges()[0].b.side, Side::startU);
    EXPECT_STREQ(continuityName(friends.edges()[0].continuity), "G2");
    EXPECT_EQ(friends.nakedEdges().size(), 6U);
}

// Planes cut along a slanted line, and turned around it or moved.
TEST(Trimmed, TolerancesOfAngleAndGapAreKept)
{
    const FriendTolerances tolerances;
    const KnotVector knots = clampedIntegerKnots(1, 4);
    const NurbsSurface plane = surfaceOf(knots, knots, [](int i, int j) {
        return ControlPoint{{static_cast<double>(i), static_cast<double>(j), 0}, 1};
    });
    const TrimCurve cut = line({1.3, 0}, {2.9, 4});
    const Vec3 start(1.3, 0, 0);
    const Vec3 axis = glm::normalize(Vec3(2.9, 4, 0) - start);
    for (const double share : {0.99, 1.01}) {
        SceneObject turnedSide = rightOf(cut, plane);
        turnedSide.transform = glm::translate(Mat4(1), start) *
                               glm::rotate(Mat4(1), glm::radians(share * tolerances.angleDeg), axis) *
                               glm::translate(Mat4(1), -start);
        const Friends kinked = friendsOf({leftOf(cut, plane), turnedSide});
        ASSERT_EQ(kinked.edges().size(), 1U);
        const FriendEdge& edge = kinked.edges()[0];
        EXPECT_STREQ(continuityName(edge.continuity), share < 1 ? "G2" : "G0");
        EXPECT_NEAR(edge.angleMaxDeg, share * tolerances.angleDeg, 1e-6);
        EXPECT_LE(edge.angleMaxDeg, edge.angleBoundDeg);

        SceneObject moved = rightOf(cut, plane);
        moved.transform = glm::translate(Mat4(1), Vec3(0, 0, share * tolerances.gap));
        const Friends apart = friendsOf({leftOf(cut, plane), moved});
        ASSERT_EQ(apart.edges().size(), 1U);
        EXPECT_STREQ(continuityName(apart.edges()[0].continuity), share < 1 ? "G2" : "none");
        EXPECT_NEAR(apart.edges()[0].gapMax, share * tolerances.gap, 1e-9);
    }
    // Folded back onto itself.
    const Friends folded = friendsOf({leftOf(cut, plane), leftOf(cut, plane)});
    ASSERT_EQ(folded.edges().size(), 4U);
    for (const FriendEdge& edge : folded.edges()) {
        EXPECT_STREQ(continuityName(edge.continuity), "G0");
        EXPECT_NEAR(edge.angleMaxDeg, 180, 1e-6);
    }
}

TEST(Trimmed, AnUpdateIsAsIfAllWereMadeAnew)
{
    std::mt19937 random(84);
    std::vector<SceneObject> objects;
    const NurbsSurface surface = smoothSurface(random, 3, true);
    const TrimCurve curve = crossing(random, true);
    objects.push_back(leftOf(curve, surface));
    objects.push_back(rightOf(curve, surface));
    Friends friends = friendsOf(objects);
    for (int round = 0; round < 20; ++round) {
        const auto which = static_cast<std::uint32_t>(round % 2);
        const int i = static_cast<int>(randomBetween(random, 0, 6.99));
        const int j = static_cast<int>(randomBetween(random, 0, 6.99));
        auto points = objects[which].surface.controlPoints();
        points[static_cast<size_t>(i * objects[which].surface.countV() + j)].position.z += 0.01;
        objects[which].surface =
            NurbsSurface::create(surface.knotsU(), surface.knotsV(), std::move(points)).value();
        friends.update({{which, placed(objects[which])}});
        const Friends anew = friendsOf(objects);
        EXPECT_EQ(friends.edges(), anew.edges());
        EXPECT_EQ(friends.nakedEdges(), anew.nakedEdges());
    }
    EXPECT_FALSE(friends.edges().empty());
}

// What the graph draws, against the angle and gap that the planes have.
TEST(Trimmed, ProfilesFollowTheCurve)
{
    const KnotVector knots = clampedIntegerKnots(1, 4);
    const NurbsSurface plane = surfaceOf(knots, knots, [](int i, int j) {
        return ControlPoint{{static_cast<double>(i), static_cast<double>(j), 0}, 1};
    });
    const TrimCurve cut = line({1.3, 0}, {2.9, 4});
    const Vec3 start(1.3, 0, 0);
    SceneObject right = rightOf(cut, plane);
    right.transform = glm::translate(Mat4(1), start + Vec3(0, 0, 5e-4)) *
                      glm::rotate(Mat4(1), glm::radians(20.0), glm::normalize(Vec3(1.6, 4, 0))) *
                      glm::translate(Mat4(1), -start);
    const SceneObject left = leftOf(cut, plane);
    const Friends friends = friendsOf({left, right});
    ASSERT_EQ(friends.edges().size(), 1U);
    const FriendEdge& edge = friends.edges()[0];
    const auto profile = edgeProfile(left, right, edge, 9);
    ASSERT_GE(profile.size(), 9U);
    for (const EdgeSample& sample : profile) {
        ASSERT_TRUE(sample.angleDeg);
        EXPECT_NEAR(*sample.angleDeg, 20, 1e-6);
        EXPECT_NEAR(sample.gap, 5e-4, 1e-9);
    }
    EXPECT_NEAR(std::abs(glm::normalize(normalOn(left, edge.a, 0.5)).z), 1, 1e-12);
    const Vec3 middle = pointOn(left, edge.a, 0.5);
    EXPECT_LE(glm::distance(middle, Vec3(2.1, 2, 0)), 1e-12);
}

}  // namespace knotspan::testing
