#include "model/analysis/facing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/samples/sample_list.h"
#include "tests/facing_samples.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

// Of the degrees, spans, weights and offsets that surfaces may have.
NurbsSurface anyOf(std::mt19937& random, int trial)
{
    constexpr double kOffsets[] = {0, 100, 1e7};
    return randomSurface(random, {.degreeU = 1 + trial % 9,
                                  .degreeV = 1 + (trial * 4 + trial / 9) % 9,
                                  .spans = 2,
                                  .rational = trial % 2 == 0,
                                  .offset = kOffsets[trial / 3 % 3],
                                  .clamped = trial % 5 != 0,
                                  .weightRatio = trial % 7 == 0 ? 100.0 : 4.0});
}

// A KSQuad with its net relative to a control point of its own, which tests' eyes are then, too.
struct LocalKsQuad {
    LocalKsQuad(const NurbsSurface& surface, const KsQuad& ksquad)
        : quad(ksquad),
          origin(surface.controlPoint(quad.spanU - surface.degreeU() / 2, quad.spanV - surface.degreeV() / 2)
                     .position),
          net(BezierConversion(surface, origin).net(quad))
    {
    }
    [[nodiscard]] Vec4 local(const Vec4& eye) const { return {Vec3(eye) - eye.w * origin, eye.w}; }

    KsQuad quad;
    Vec3 origin;
    BezierNet net;
};

KsQuad anyQuad(std::mt19937& random, const NurbsSurface& surface)
{
    const auto quads = ksQuads(surface);
    return quads[random() % quads.size()];
}

// Bernstein polynomials of any degree, at t in (0, 1).
std::vector<double> bernstein(int degree, double t)
{
    std::vector<double> values{std::pow(1 - t, degree)};
    for (int k = 1; k <= degree; ++k)
        values.push_back(values.back() * (degree - k + 1) / k * t / (1 - t));
    return values;
}

Vec4 valueAt(const FacingNet& facing, const Vec2& t)
{
    Vec4 sum(0);
    const auto u = bernstein(facing.degreeU, t.x);
    const auto v = bernstein(facing.degreeV, t.y);
    for (size_t k = 0; k < u.size(); ++k)
        for (size_t l = 0; l < v.size(); ++l)
            sum += u[k] * v[l] * facing.points[k * v.size() + l];
    return sum;
}

TEST(Facing, CoefficientsGiveTheNormalTimesTheWayToTheEye)
{
    std::mt19937 random(51);
    for (int trial = 0; trial < 90; ++trial) {
        const NurbsSurface surface = anyOf(random, trial);
        const LocalKsQuad local(surface, anyQuad(random, surface));
        const FacingNet facing = facingNet(local.net);
        ASSERT_EQ(facing.degreeU, 3 * surface.degreeU() - 2);
        ASSERT_EQ(facing.degreeV, 3 * surface.degreeV() - 2);
        const KnotVector& knotsU = surface.knotsU();
        const KnotVector& knotsV = surface.knotsV();
        const Vec2 start(knotsU[local.quad.spanU], knotsV[local.quad.spanV]);
        const Vec2 size = Vec2(knotsU[local.quad.spanU + 1], knotsV[local.quad.spanV + 1]) - start;
        for (int k = 0; k < 10; ++k) {
            const Vec2 t(randomBetween(random, 0, 1), randomBetween(random, 0, 1));
            const SurfacePoint point = evaluate(surface, start.x + t.x * size.x, start.y + t.y * size.y);
            const double weight = std::pow(evaluate(local.net, t.x, t.y).w, 3);
            const Vec3 du = point.du * size.x;
            const Vec3 dv = point.dv * size.y;
            const Vec3 at = point.position - local.origin;
            const Vec4 eye(10.0 * randomDirection(random), k % 2);
            const Vec3 towards = Vec3(eye) - eye.w * at;
            const double expected = weight * glm::dot(glm::cross(du, dv), towards);
            const double rounding = surface.bounds().centre().x > 1e6 ? 1e-7 : 1e-10;
            EXPECT_NEAR(glm::dot(valueAt(facing, t), eye), expected,
                        rounding * weight * glm::length(du) * glm::length(dv) * glm::length(towards));
        }
    }
}

TEST(Facing, NothingThatFacesAwayShowsASample)
{
    std::mt19937 random(52);
    FacingCount count;
    for (int trial = 0; trial < soakOf(200); ++trial) {
        const NurbsSurface surface = anyOf(random, trial);
        const Box box = surface.bounds();
        const LocalKsQuad local(surface, anyQuad(random, surface));
        const FacingSamples samples(surface, local.quad, 12);
        const FacingNet facing = facingNet(local.net);
        for (int k = 0; k < 40; ++k) {
            const Vec4 eye = k % 2 == 0 ? samples.randomEye(random, box) : samples.tangentEye(random, box);
            count.add(samples.showTo(eye), facesAway(facing, local.local(eye), 1e-8));
        }
    }
    EXPECT_EQ(count.wrong, 0);
    EXPECT_GT(count.culled, count.views / 20);
    RecordProperty("culled", std::to_string(count.culled));
}

double shareOf(const std::string& name, const std::vector<const NurbsSurface*>& surfaces)
{
    std::mt19937 random(53);
    Box box;
    size_t quadCount = 0;
    for (const NurbsSurface* surface : surfaces) {
        box.add(surface->bounds());
        quadCount += ksQuadCount(*surface);
    }
    const size_t step = 1 + quadCount / 80;
    FacingCount count;
    for (const NurbsSurface* surface : surfaces) {
        const auto quads = ksQuads(*surface);
        for (size_t k = random() % step; k < quads.size(); k += step) {
            const LocalKsQuad local(*surface, quads[k]);
            // Coarse samples miss what shows beside a pole.
            const FacingSamples samples(*surface, quads[k], 50);
            const FacingNet facing = facingNet(local.net);
            for (int view = 0; view < 40; ++view) {
                const Vec4 eye = samples.randomEye(random, box);
                count.add(samples.showTo(eye), facesAway(facing, local.local(eye)));
            }
        }
    }
    EXPECT_EQ(count.wrong, 0) << name;
    ::testing::Test::RecordProperty("share_" + name, std::to_string(count.share()));
    return count.share();
}

TEST(Facing, TellsNearlyAllKsQuadsThatFaceAway)
{
    for (const char* name : {"torus", "sphere", "knot", "hull", "single-100"}) {
        const Scene scene = findSample(name)->make();
        std::vector<const NurbsSurface*> surfaces;
        for (const auto& [id, object] : scene.objects())
            if (surfaces.size() < 4)
                surfaces.push_back(&object->surface);
        EXPECT_GE(shareOf(name, surfaces), 0.985) << name;
    }
    std::mt19937 random(54);
    const NurbsSurface coarse = bumpyBall(random, 12, 0.1, false);
    const NurbsSurface fine = bumpyBall(random, 32, 0.03, true);
    EXPECT_GE(shareOf("bumps", {&coarse}), 0.97);
    EXPECT_GE(shareOf("fine_bumps", {&fine}), 0.98);
}

BezierNet dome(double weight)
{
    BezierNet net{2, 2, {}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            net.points.push_back(weight * Vec4(i - 1, j - 1, i == 1 && j == 1 ? 0.5 : 0, 1));
    return net;
}

TEST(Facing, IsTheSideThatTheNormalPointsTo)
{
    const FacingNet facing = facingNet(dome(2));  // S_u x S_v points up
    EXPECT_TRUE(facesAway(facing, {0.2, 0.1, -3, 1}));
    EXPECT_FALSE(facesAway(facing, {0.2, 0.1, 3, 1}));
    EXPECT_FALSE(facesAway(facing, {3, 0, 0, 1}));
    EXPECT_TRUE(facesAway(facing, {0, 0, -1, 0}));
    EXPECT_FALSE(facesAway(facing, {0, 0, 1, 0}));
}

TEST(Facing, MarginIsTheSineOfTheAngleThatIsLeft)
{
    BezierNet flat = dome(1);
    flat.at(1, 1).z = 0;
    const FacingNet facing = facingNet(flat);
    const auto below = [](double sine) { return Vec4(std::sqrt(1 - sine * sine), 0, -sine, 0); };
    EXPECT_TRUE(facesAway(facing, below(0.101), 0.1));
    EXPECT_FALSE(facesAway(facing, below(0.099), 0.1));
    EXPECT_FALSE(facesAway(facing, {1, 0, 0, 0}));
}

TEST(Facing, ThePointsOfAPoleTellNothingAndAreLeftOut)
{
    BezierNet net = dome(1);
    for (int j = 0; j < 3; ++j)  // u = 0: one point, but for rounding
        net.at(0, j) = Vec4(-1, 1e-9 * j * (j - 1), 1e-9 * (1 - j), 1);
    EXPECT_FALSE(facesAway(facingNet(net), {0, 0, -3, 1}));
    const FacingNet facing = facingNet(net, 1e-8);
    EXPECT_EQ(std::count(facing.points.begin(), facing.points.end(), Vec4(0)), 5);
    EXPECT_TRUE(facesAway(facing, {0, 0, -3, 1}));
}

TEST(Facing, WhatIsAPointOrALineFacesNowhere)
{
    BezierNet line{2, 2, {}};
    for (int i = 0; i < 9; ++i)
        line.points.emplace_back(i, 2 * i, 0, 1);
    const BezierNet point{2, 2, std::vector<Vec4>(9, Vec4(1, 2, 3, 1))};
    for (const BezierNet& net : {line, point})
        for (const Vec4& eye : {Vec4(0, 0, 5, 1), Vec4(0, 0, -5, 1), Vec4(1, 0, 0, 0), Vec4(-1, 0, 0, 0)})
            EXPECT_FALSE(facesAway(facingNet(net), eye));
}

}  // namespace
}  // namespace knotspan::testing
