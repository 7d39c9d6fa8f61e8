// Which of an edge's points bring their owner's normal along, held against normals of each KSQuad's own
// Bezier net and against the knots.
#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/bezier_conversion.h"
#include "model/samples/samples.h"
#include "shaders/shared/ring.glsl"
#include "tests/joined_surfaces.h"
#include "tests/random_surface.h"
#include "tests/shaders/border_model.h"

namespace knotspan::testing {
namespace {

// A net without its first or its last row.
BezierNet withoutRow(const BezierNet& net, bool alongU, bool last)
{
    BezierNet part{net.degreeU - (alongU ? 1 : 0), net.degreeV - (alongU ? 0 : 1), {}};
    const int skip = last ? 0 : 1;
    for (int i = 0; i <= part.degreeU; ++i)
        for (int j = 0; j <= part.degreeV; ++j)
            part.points.push_back(net.at(i + (alongU ? skip : 0), j + (alongU ? 0 : skip)));
    return part;
}

Vec3 tangent(const BezierNet& net, bool alongU, const Vec2& t)
{
    const Vec4 point = evaluate(net, t.x, t.y);
    const Vec4 change = evaluate(withoutRow(net, alongU, false), t.x, t.y) -
                        evaluate(withoutRow(net, alongU, true), t.x, t.y);
    return Vec3(change) * point.w - Vec3(point) * change.w;
}

struct Shading {
    Vec3 normal{};    // unit
    double sine = 0;  // between the tangents; 0 where one vanishes
    double weight = 0;
};

Shading shadingAt(const Model& model, std::uint32_t ksquad, const gpu::vec2& t)
{
    const NurbsSurface& surface = model.surfaceOf(ksquad);
    const auto local = ksquad - model.source.surfaces[model.source.ksquads[ksquad].surface].firstKsquad;
    const BezierNet net = BezierConversion(surface).net(ksQuads(surface)[local]);
    const Vec3 du = tangent(net, true, t);
    const Vec3 dv = tangent(net, false, t);
    const double size = surface.bounds().diagonal();
    Shading shading{{}, 0, evaluate(net, t.x, t.y).w};
    if (std::min(glm::length(du), glm::length(dv)) < 1e-9 * size)
        return shading;
    const Vec3 n = glm::cross(glm::normalize(du), glm::normalize(dv));
    shading.sine = glm::length(n);
    shading.normal = n / std::max(shading.sine, 1e-300);
    return shading;
}

// Whether a KSQuad shares across the line it starts with, by the knots themselves.
bool isSmoothStart(const KnotVector& knots, std::uint32_t spanNumber)
{
    if (spanNumber == 0)
        return false;
    const int span = knots.spans()[spanNumber];
    const int before = knots.spans()[spanNumber - 1];
    const auto times = std::count(knots.values().begin(), knots.values().end(), knots[span]);
    return times < knots.degree() && 2 * (knots[before + 1] - knots[before]) >= knots[span + 1] - knots[span];
}

struct Shared {
    std::uint32_t edges = 0;  // points within KSQuads' sides
    std::uint32_t corners = 0;
};

void lookAtSide(const Model& model, std::uint32_t ksquad, const gpu::DrawnGrid& grid, std::uint32_t side,
                Shared& shared)
{
    const auto place = gpu::placeOf(model.source, ksquad);
    const NurbsSurface& surface = model.surfaceOf(ksquad);
    const bool smoothU = isSmoothStart(surface.knotsU(), place.a);
    const bool smoothV = isSmoothStart(surface.knotsV(), place.b);
    for (std::uint32_t k = 0; k <= grid.edges[side]; ++k) {
        const auto vertex = gpu::edgeVertex(model.source, place, ksquad, side, k, grid.edges[side]);
        const bool isCorner = k == 0 || k == grid.edges[side];
        if (vertex.source == ksquad && vertex.sourceT == vertex.t) {
            ASSERT_TRUE(vertex.sharesNormal);
            continue;
        }
        if (!isCorner) {
            const bool inner = gpu::innerNeighbour(place, ksquad, side) != NO_SIDE;
            ASSERT_EQ(vertex.sharesNormal, inner && (side == SIDE_START_U ? smoothU : smoothV));
        }
        if (!vertex.sharesNormal)
            continue;
        ++(isCorner ? shared.corners : shared.edges);
        ASSERT_EQ(model.source.ksquads[vertex.source].surface, model.source.ksquads[ksquad].surface);
        const Shading own = shadingAt(model, ksquad, vertex.t);
        const Shading there = shadingAt(model, vertex.source, vertex.sourceT);
        ASSERT_NEAR(there.weight, own.weight, 1e-12 * own.weight);
        // Tangents vanish on both sides or on none; what float's rounding leaves is like.
        ASSERT_EQ(there.sine == 0, own.sine == 0);
        ASSERT_LT(glm::distance(there.normal, own.normal), 1e-9);
    }
}

Shared lookAtAll(Model& model, std::mt19937& random)
{
    ask(model, random, true, 6);
    Shared shared;
    for (std::uint32_t ksquad = 0; ksquad < model.source.ksquads.size(); ++ksquad) {
        SCOPED_TRACE("KSQuad " + std::to_string(ksquad));
        const auto grid = gpu::drawnGrid(model.source, ksquad, SNAP_RING);
        Shared here;
        for (std::uint32_t side = 0; side < 4; ++side) {
            lookAtSide(model, ksquad, grid, side, here);
            if (::testing::Test::HasFatalFailure())
                return shared;
        }
        EXPECT_EQ(here.corners % 2, 0U);  // each seen along two sides
        EXPECT_EQ(gpu::sharedNormals(model.source, ksquad, grid), here.edges + here.corners / 2);
        shared.edges += here.edges;
        shared.corners += here.corners / 2;
    }
    return shared;
}

TEST(SharedNormals, AreTheKsQuadsOwnWhereTheSurfaceIsSmooth)
{
    std::mt19937 random(11);
    for (auto make : {makeSingle100, makeKnot, makeHull}) {
        const Scene scene = make();
        Model model(placed(scene));
        const Shared shared = lookAtAll(model, random);
        ASSERT_FALSE(HasFatalFailure());
        EXPECT_GT(shared.edges, 0U);
        EXPECT_GT(shared.corners, 0U);
    }
}

// Circles of quarters, which meet at knots that stand degree times: smooth by their control points, of which
// the rule asks nothing.
TEST(SharedNormals, AreNoneAlongKnotsOfFullMultiplicity)
{
    std::mt19937 random(12);
    for (auto make : {makeTorus, makeSphere}) {
        const Scene scene = make();
        Model model(placed(scene));
        EXPECT_GT(model.source.surfaces[0].spansU * model.source.surfaces[0].spansV, 1U);
        EXPECT_EQ(lookAtAll(model, random).edges, 0U);
        ASSERT_FALSE(HasFatalFailure());
    }
}

// Random knots, many of them several times, and spans of all lengths; creases where they stand degree times.
TEST(SharedNormals, FollowTheKnotsOfAnySurface)
{
    std::mt19937 random(13);
    std::uint32_t edges = 0;
    bool creased = false;
    for (int trial = 0; trial < 60; ++trial) {
        RandomSurfaceShape shape;
        shape.degreeU = 1 + trial % 5;
        shape.degreeV = 1 + trial / 5 % 4;
        shape.spans = 5;
        shape.rational = trial % 2 == 0;
        shape.clamped = trial % 3 != 0;
        const NurbsSurface surface = randomSurface(random, shape);
        Model model({{&surface}});
        SCOPED_TRACE(trial);
        const Shared shared = lookAtAll(model, random);
        ASSERT_FALSE(HasFatalFailure());
        edges += shared.edges;
        for (const int span : surface.knotsU().spans()) {
            const auto& values = surface.knotsU().values();
            const auto times = std::count(values.begin(), values.end(), surface.knotsU()[span]);
            creased = creased || (times == surface.degreeU() && span > surface.degreeU());
        }
    }
    EXPECT_GT(edges, 0U);
    EXPECT_TRUE(creased) << "some surface has a crease";
}

// A knot that stands degree times, and control points that make a crease there.
TEST(SharedNormals, AreNoneAlongACrease)
{
    std::mt19937 random(14);
    const NurbsSurface whole = curvedSheet();
    for (const int times : {2, 3}) {
        NurbsSurface sheet = withKnotInserted(whole, Direction::U, 1.0, times - 1);
        std::vector<ControlPoint> points = sheet.controlPoints();
        for (size_t k = 0; k < points.size(); ++k)
            points[k].position.z += 0.3 * static_cast<double>(random() % 8);
        sheet = NurbsSurface::create(sheet.knotsU(), sheet.knotsV(), std::move(points)).value();
        Model model({{&sheet}});
        (void)lookAtAll(model, random);
        ASSERT_FALSE(HasFatalFailure());
        const std::uint32_t spansV = model.source.surfaces[0].spansV;
        const auto place = gpu::placeOf(model.source, spansV);
        const auto vertex = gpu::edgeVertex(model.source, place, spansV, SIDE_START_U, 1, 2);
        EXPECT_EQ(vertex.source, 0U);
        EXPECT_EQ(vertex.sharesNormal, times == 2);
        const double apart = glm::distance(shadingAt(model, spansV, vertex.t).normal,
                                           shadingAt(model, vertex.source, vertex.sourceT).normal);
        EXPECT_EQ(apart > 0.01, times == 3) << apart;
    }
}

// Culling counts on normals as good as the KSQuad's own: tangents of a span a thousand times shorter are not.
TEST(SharedNormals, AreNotTakenFromAMuchShorterSpan)
{
    const NurbsSurface sheet = withKnotInserted(curvedSheet(), Direction::U, 0.999);
    EXPECT_FALSE(startsSmoothly(sheet.knotsU(), sheet.knotsU().spans()[2]));
    EXPECT_TRUE(startsSmoothly(sheet.knotsU(), sheet.knotsU().spans()[1]));
    EXPECT_TRUE(startsSmoothly(sheet.knotsU(), sheet.knotsU().spans()[3]));
}

}  // namespace
}  // namespace knotspan::testing
