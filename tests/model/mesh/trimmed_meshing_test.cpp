// Meshes of trimmed surfaces: what is left of them, where they are open, and how far they are off.
#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/primitives.h"
#include "model/mesh/deviation_measuring.h"
#include "model/mesh/tessellation.h"
#include "model/trimming/trim_region.h"
#include "tests/model/mesh/half_edge_mesh.h"
#include "tests/model/trimming/loop_samples.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

using testing::circle;
using testing::polyline;

Tessellation meshOf(const Scene& scene, double deviation)
{
    auto mesh = tessellate(scene, {.deviation = deviation});
    EXPECT_TRUE(mesh) << mesh.error().sentence();
    if (!mesh)
        return {};
    EXPECT_LE(mesh->bound, deviation);
    EXPECT_LE(measuredDeviation(*mesh, scene).largest, mesh->bound + 1e-12);
    EXPECT_EQ(topologyOf(mesh->mesh).degenerate, 0U);
    return *std::move(mesh);
}

double areaOf(const TriangleMesh& mesh)
{
    double area = 0;
    for (const Triangle& triangle : mesh.triangles)
        area += glm::length(glm::cross(mesh.vertices[triangle[1]] - mesh.vertices[triangle[0]],
                                       mesh.vertices[triangle[2]] - mesh.vertices[triangle[0]])) /
                2;
    return area;
}

Scene sceneOf(const NurbsSurface& surface, std::vector<TrimLoop> loops)
{
    Scene scene;
    scene.add({.name = "face", .surface = surface, .trimLoops = std::move(loops)});
    return scene;
}

TrimLoop ring(std::vector<Vec2> places, bool outer = true)
{
    places.push_back(places.front());
    return {outer, {polyline(places)}};
}

void expectClosed(const TriangleMesh& mesh, long euler)
{
    const MeshTopology topology = topologyOf(mesh);
    EXPECT_TRUE(topology.isClosedManifold())
        << topology.boundaryEdges << " open, " << topology.nonManifoldEdges << " of more than two, "
        << topology.turnedEdges << " turned";
    EXPECT_EQ(topology.euler, euler);
    EXPECT_EQ(topology.usedVertices, mesh.vertices.size());
    EXPECT_TRUE(testing::halfEdgesOf(mesh).manifold);
}

TEST(TrimmedMeshing, LeavesHolesOfPlatesOpenAndNothingElse)
{
    const std::vector<TrimLoop> loops{{true, {circle({0.9, 11.1}, 0.8)}},
                                      {false, {circle({1, 11.2}, 0.3, false)}}};
    for (const double deviation : {0.1, 1e-2, 1e-4}) {
        const Tessellation mesh = meshOf(sceneOf(testing::flatSurface(), loops), deviation);
        const double length = 2 * M_PI * (0.8 + 0.3);
        EXPECT_NEAR(areaOf(mesh.mesh), M_PI * (0.64 - 0.09), length * deviation);
        const MeshTopology topology = topologyOf(mesh.mesh);
        EXPECT_EQ(topology.boundaryEdges, mesh.chords.size());
        EXPECT_EQ(topology.euler, 0);
        ASSERT_EQ(mesh.notes.size(), 1U);
        EXPECT_NE(mesh.notes.front().find("open"), std::string::npos);
    }
}

TEST(TrimmedMeshing, OfAFlatFaceIsAsExactAsItsOutline)
{
    TrimLoop loop;
    const std::vector<Vec2> places{{-0.5, 10.2}, {2.5, 10.4}, {2, 11.9}, {0.1, 11}};
    for (size_t k = 0; k < 4; ++k)
        loop.curves.push_back(polyline({places[k], places[(k + 1) % 4]}));
    const Tessellation mesh = meshOf(sceneOf(testing::flatSurface(), {loop}), 1);
    EXPECT_NEAR(areaOf(mesh.mesh), 2.79, 1e-12);
    EXPECT_LT(mesh.bound, 1e-12);
}

// Random loops of all degrees on curved surfaces: the triangles' shares of the parameter plane, together, are
// what a count of random places says.
TEST(TrimmedMeshing, CoversWhatTheLoopsLeaveOfRandomSurfaces)
{
    std::mt19937 random(5);
    for (int round = 0; round < 12; ++round) {
        const NurbsSurface surface = testing::randomSurface(random, {.rational = round % 2 != 0});
        const Vec2 low(surface.knotsU().domainStart(), surface.knotsV().domainStart());
        const Vec2 size = Vec2(surface.knotsU().domainEnd(), surface.knotsV().domainEnd()) - low;
        const auto place = [&](double u, double v) { return low + Vec2(u, v) * size; };
        std::vector<TrimPoint> wave;
        for (int k = 0; k <= 12; ++k) {
            const double angle = 2 * M_PI * (k % 12) / 12;
            const double radius = 0.25 + 0.15 * (k % 12 % 3);
            wave.push_back(
                {place(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)), 1.0 + k % 12 % 2});
        }
        const TrimCurve curve =
            TrimCurve::create(KnotVector::clampedUniform(1 + round % 4, 13 - 1 - round % 4), wave).value();
        const std::vector<TrimLoop> loops{
            {true, {curve}}, ring({place(0.45, 0.45), place(0.5, 0.56), place(0.55, 0.45)}, false)};
        const Scene scene = sceneOf(surface, loops);
        const Tessellation mesh = meshOf(scene, 2e-3 * scene.bounds().diagonal());
        double covered = 0;
        for (size_t p = 0; p < mesh.patches.size(); ++p) {
            const KsQuad& quad = mesh.patches[p].quad;
            const double area = (surface.knotsU()[quad.spanU + 1] - surface.knotsU()[quad.spanU]) *
                                (surface.knotsV()[quad.spanV + 1] - surface.knotsV()[quad.spanV]);
            for (size_t k = mesh.patches[p].firstTriangle; k < mesh.endOf(p); ++k) {
                const auto& [a, b, c] = mesh.parameters[k];
                const double signedArea = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
                covered += std::abs(signedArea) / 2 * area;
            }
        }
        const TrimRegion region(loops, surface);
        ASSERT_TRUE(region.isTrimmed());
        int inside = 0;
        constexpr int kSteps = 150;
        for (int i = 0; i < kSteps; ++i)
            for (int j = 0; j < kSteps; ++j) {
                const Vec2 at = place((i + 0.5) / kSteps, (j + 0.5) / kSteps);
                inside += region.contains(at.x, at.y) ? 1 : 0;
            }
        EXPECT_NEAR(covered / (size.x * size.y), inside / double(kSteps * kSteps), 0.02) << round;
        EXPECT_EQ(topologyOf(mesh.mesh).boundaryEdges, mesh.chords.size()) << round;
    }
}

// A can: a cylinder that nobody trimmed between two planes with circles in them, one of two arcs that begin
// elsewhere, one of a single curve.
Scene can(double radius, double height, double turnedBy)
{
    Scene scene;
    scene.add({.name = "wall", .surface = cylinder({0, 0, 0}, radius, height)});
    const NurbsSurface below = plane({-5, 5, 0}, {10, 0, 0}, {0, -10, 0});
    const NurbsSurface above = plane({-5, -5, height}, {10, 0, 0}, {0, 10, 0});
    const double share = radius / 10;
    std::vector<TrimPoint> points;
    const double half = std::sqrt(0.5);
    for (int k = 0; k <= 8; ++k) {
        const double angle = turnedBy + k * M_PI / 4;
        const double reach = k % 2 == 0 ? 1 : std::sqrt(2.0);
        points.push_back(
            {Vec2(0.5) + share * reach * Vec2(std::cos(angle), std::sin(angle)), k % 2 == 0 ? 1 : half});
    }
    points.back().position = points.front().position;
    std::vector<TrimCurve> arcs;
    for (const size_t first : {size_t{0}, size_t{4}})
        arcs.push_back(TrimCurve::create(KnotVector::create(2, {0, 0, 0, 1, 1, 2, 2, 2}).value(),
                                         {points.begin() + static_cast<std::ptrdiff_t>(first),
                                          points.begin() + static_cast<std::ptrdiff_t>(first) + 5})
                           .value());
    scene.add({.name = "below", .surface = below, .trimLoops = {{true, {circle({0.5, 0.5}, share)}}}});
    scene.add({.name = "above", .surface = above, .trimLoops = {{true, arcs}}});
    return scene;
}

TEST(TrimmedMeshing, ClosesBodiesOfTrimmedAndUntrimmedFaces)
{
    for (const double turnedBy : {0.0, 0.3, 2.0})
        for (const double deviation : {1.0, 0.1, 0.01, 1e-3}) {
            SCOPED_TRACE(std::to_string(turnedBy) + " at " + std::to_string(deviation));
            const Tessellation mesh = meshOf(can(2, 3, turnedBy), deviation);
            expectClosed(mesh.mesh, 2);
            EXPECT_TRUE(mesh.notes.empty()) << mesh.notes.front();
            const double volume = M_PI * 4 * 3;
            EXPECT_LT(volumeOf(mesh.mesh), volume);
            EXPECT_GT(volumeOf(mesh.mesh), volume - deviation * (4 * M_PI * 3));
        }
}

TEST(TrimmedMeshing, KeepsWhatIsFarFromTrimmedFacesAsItIs)
{
    Scene scene = can(2, 3, 0.3);
    Mat4 away(1.0);
    away[3] = Vec4(100, 0, 0, 1);
    const ObjectId ball = scene.add({.name = "ball", .transform = away, .surface = sphere({0, 0, 0}, 2)});
    const Tessellation mesh = meshOf(scene, 0.01);
    expectClosed(mesh.mesh, 4);
    const Tessellation alone = meshOf(testing::sceneOf(sphere({0, 0, 0}, 2)), 0.01);
    size_t ofBall = 0;
    for (size_t p = 0; p < mesh.patches.size(); ++p)
        ofBall += mesh.patches[p].object == ball ? mesh.endOf(p) - mesh.patches[p].firstTriangle : 0;
    EXPECT_EQ(ofBall, alone.mesh.triangles.size());
}

TEST(TrimmedMeshing, JoinsFacesAlongATrimCurveInTheMiddle)
{
    // A ball of two faces: what is on either side of a wave around it.
    std::vector<TrimPoint> wave;
    for (int k = 0; k <= 16; ++k)
        wave.push_back({{k / 2.0, 2 + (k % 16 % 2 == 0 ? 0.4 : -0.4)}, 1});
    const auto knots = KnotVector::clampedUniform(3, 14);
    const TrimCurve there = TrimCurve::create(knots, wave).value();
    const TrimCurve back = TrimCurve::create(knots, {wave.rbegin(), wave.rend()}).value();
    Scene scene;
    scene.add({.name = "north", .surface = sphere({0, 0, 0}, 2), .trimLoops = {{true, {there}}}});
    scene.add({.name = "south", .surface = sphere({0, 0, 0}, 2), .trimLoops = {{true, {back}}}});
    for (const double deviation : {0.3, 0.03, 0.003}) {
        SCOPED_TRACE(deviation);
        const Tessellation mesh = meshOf(scene, deviation);
        expectClosed(mesh.mesh, 2);
        EXPECT_NEAR(volumeOf(mesh.mesh), 4.0 / 3 * M_PI * 8, deviation * 16 * M_PI);
    }
}

TEST(TrimmedMeshing, CutsWindowsAcrossSeamsAndAroundPoles)
{
    // Across the seam of a closed surface.
    const Tessellation window = meshOf(
        sceneOf(cylinder({0, 0, 0}, 1, 2), {ring({{-1, 0.3}, {-1, 0.7}, {1, 0.7}, {1, 0.3}}, false)}), 1e-3);
    EXPECT_NEAR(areaOf(window.mesh), 2 * M_PI * 2 - 2 * M_PI / 4 * 0.8, 0.02);
    EXPECT_EQ(topologyOf(window.mesh).euler, -1);
    // Around a pole: all that is north of a parallel is gone.
    const TrimCurve parallel = polyline({{0, 3}, {8, 3}});
    const Tessellation bowl =
        meshOf(sceneOf(sphere({0, 0, 0}, 1), {{true, {polyline({{8, 3}, {0, 3}})}}}), 1e-3);
    const double height = 1 + std::sin(M_PI / 4);
    EXPECT_NEAR(areaOf(bowl.mesh), 2 * M_PI * height, 0.01);
    EXPECT_EQ(topologyOf(bowl.mesh).euler, 1);
    const Tessellation cap = meshOf(sceneOf(sphere({0, 0, 0}, 1), {{true, {parallel}}}), 1e-3);
    EXPECT_NEAR(areaOf(cap.mesh), 4 * M_PI - 2 * M_PI * height, 0.01);
}

TEST(TrimmedMeshing, TakesLoopsThatTouchEachOtherTheBorderOrThemselves)
{
    const NurbsSurface flat = testing::flatSurface({0, 10}, {0, 10});
    const auto area = [&](const std::vector<TrimLoop>& loops) {
        const Tessellation mesh = meshOf(sceneOf(flat, loops), 1e-4);
        EXPECT_EQ(mesh.crossing, 0U) << loops.size() << " " << loops.back().curves.front().points().size();
        return areaOf(mesh.mesh);
    };
    // Two squares that share a corner, as two loops and as one.
    EXPECT_NEAR(area({ring({{1, 1}, {4, 1}, {4, 4}, {1, 4}}), ring({{4, 4}, {6, 4}, {6, 6}, {4, 6}})}), 9 + 4,
                1e-7);
    EXPECT_NEAR(area({ring({{1, 1}, {4, 1}, {4, 4}, {6, 4}, {6, 6}, {4, 6}, {4, 4}, {1, 4}})}), 9 + 4, 1e-7);
    // A hole that touches the outline from inside, in a point and along a line.
    EXPECT_NEAR(area({ring({{1, 1}, {9, 1}, {9, 9}, {1, 9}}), ring({{1, 5}, {3, 4}, {3, 6}}, false)}), 64 - 2,
                1e-7);
    EXPECT_NEAR(area({ring({{1, 1}, {9, 1}, {9, 9}, {1, 9}}), ring({{1, 4}, {3, 4}, {3, 6}, {1, 6}}, false)}),
                64 - 4, 1e-7);
    // Along the border, partly beyond it, and a sliver.
    EXPECT_NEAR(area({ring({{0, 0}, {10, 0}, {10, 4}, {0, 5}})}), 45, 1e-7);
    EXPECT_NEAR(area({ring({{-3, 2}, {5, 2}, {5, 5}, {-3, 5}})}), 15, 1e-7);
    EXPECT_NEAR(area({ring({{1, 1}, {9, 1}, {9, 1.001}, {1, 1.001}})}), 8e-3, 1e-7);
    // Circles that touch from outside.
    EXPECT_NEAR(area({{true, {circle({3, 5}, 1)}}, {true, {circle({5, 5}, 1)}}}), 2 * M_PI, 4 * M_PI * 1e-4);
}

TEST(TrimmedMeshing, SaysWhichFacesAreOpenAndWhy)
{
    Scene scene = can(2, 3, 0.3);
    scene.exchange(scene.objects().begin()->first, nullptr);
    const Tessellation mesh = meshOf(scene, 0.01);
    ASSERT_EQ(mesh.notes.size(), 1U);
    EXPECT_NE(mesh.notes.front().find("2 faces are where the mesh is open"), std::string::npos)
        << mesh.notes.front();
    EXPECT_NE(mesh.notes.front().find("(below, above)"), std::string::npos) << mesh.notes.front();
    // Two squares across each other, as two loops: inside is even-odd all the same, but chords cross.
    const Scene across =
        sceneOf(testing::flatSurface({0, 10}, {0, 10}),
                {ring({{1, 1}, {5, 1}, {5, 5}, {1, 5}}), ring({{3.1, 2.9}, {7, 3}, {7.2, 7}, {3, 6.7}})});
    const auto crossed = tessellate(across, {.deviation = 0.01});
    ASSERT_TRUE(crossed);
    EXPECT_EQ(crossed->crossing, 1U);
    EXPECT_GE(crossed->bound, measuredDeviation(*crossed, across).largest);
    EXPECT_NE(crossed->notes.front().find("crosses itself"), std::string::npos);
    const auto nothing = tessellate(sceneOf(testing::flatSurface(), {{true, {}}}), {.deviation = 0.1});
    ASSERT_FALSE(nothing);
    EXPECT_NE(nothing.error().sentence().find("Nothing is left"), std::string::npos);
}

}  // namespace
}  // namespace knotspan
