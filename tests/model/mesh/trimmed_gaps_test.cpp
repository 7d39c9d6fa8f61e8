// Meshes of trimmed surfaces whose edges do not meet, nearly touch, or are smaller than the deviation: what
// is said of how far they are off holds.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/primitives.h"
#include "model/mesh/deviation_measuring.h"
#include "model/mesh/tessellation.h"
#include "tests/model/trimming/loop_samples.h"

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
    EXPECT_LE(measuredDeviation(*mesh, scene).largest, mesh->bound + 1e-12);
    return *std::move(mesh);
}

TrimLoop ring(std::vector<Vec2> places)
{
    places.push_back(places.front());
    return {true, {polyline(places)}};
}

// A wall and two ends, the upper one `gap` above it.
Scene can(double radius, double height, double gap)
{
    Scene scene;
    const double wide = 4 * radius;
    scene.add({.name = "wall", .surface = cylinder({0, 0, 0}, radius, height)});
    scene.add({.name = "below",
               .surface = plane({-wide / 2, wide / 2, 0}, {wide, 0, 0}, {0, -wide, 0}),
               .trimLoops = {{true, {circle({0.5, 0.5}, radius / wide)}}}});
    scene.add({.name = "above",
               .surface = plane({-wide / 2, -wide / 2, height + gap}, {wide, 0, 0}, {0, wide, 0}),
               .trimLoops = {{true, {circle({0.5, 0.5}, radius / wide)}}}});
    return scene;
}

TEST(TrimmedGaps, AreClosedInTheMiddleHoweverFineTheMeshIs)
{
    constexpr double kGap = 5e-4;
    const Scene scene = can(2, 3, kGap);
    for (const double deviation : {1e-2, 1e-3, 4e-4, 1e-4, 3e-5}) {
        SCOPED_TRACE(deviation);
        const Tessellation mesh = meshOf(scene, deviation);
        EXPECT_TRUE(topologyOf(mesh.mesh).isClosedManifold());
        EXPECT_GE(measuredDeviation(mesh, scene).largest, 0.49 * kGap);
        if (deviation > kGap / 2) {
            EXPECT_LE(mesh.bound, deviation);
            EXPECT_TRUE(mesh.notes.empty()) << mesh.notes.front();
        } else {
            EXPECT_LE(mesh.bound, kGap);
            ASSERT_EQ(mesh.notes.size(), 1U);
            EXPECT_NE(mesh.notes.front().find("Joined borders are apart"), std::string::npos)
                << mesh.notes.front();
        }
    }
}

TEST(TrimmedGaps, ThatNobodyTakesForRoundingStayOpen)
{
    const Tessellation mesh = meshOf(can(2, 3, 0.05), 1e-3);
    EXPECT_GT(topologyOf(mesh.mesh).boundaryEdges, 0U);
    EXPECT_LE(mesh.bound, 1e-3);
}

TEST(TrimmedGaps, OfFacesNarrowerThanTheDeviationAreInTheBound)
{
    for (const double height : {0.3, 0.1, 1e-2, 1e-3, 1e-5})
        for (const double deviation : {3.0, 1.0, 0.1}) {
            SCOPED_TRACE(std::to_string(height) + " at " + std::to_string(deviation));
            EXPECT_LE(meshOf(can(2, height, 0), deviation).bound, deviation);
        }
    // Strips side by side, each narrower than what is joined: not all of their corners are one.
    Scene strips;
    for (int k = 0; k < 40; ++k)
        strips.add({.name = "strip",
                    .surface = plane({0.1 * k, 0, 0}, {0.1, 0, 0}, {0, 1, 0}),
                    .trimLoops = {ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}})}});
    EXPECT_LE(meshOf(strips, 1).bound, 1);
}

TEST(TrimmedGaps, BesideTinyPiecesOfACurveAreNoCrossings)
{
    // An edge that leaves its corner along the border of one face's domain; the other face has it in three
    // pieces, the last of them next to nothing.
    const double last = 1 - 1e-8;
    const auto at = [](double s, double t) {
        return (1 - s) * (1 - t) * Vec2(0.5, 1) + ((1 - s) * t + s * (1 - t)) * Vec2(0.5, 0) +
               s * t * Vec2(1, 0);
    };
    const auto beyond = [&](double s, double t) { return TrimPoint{(at(s, t) + Vec2(1)) / 3.0, 1}; };
    const TrimCurve pieces =
        TrimCurve::create(KnotVector::create(2, {0, 0, 0, 0.5, last, 1, 1, 1}).value(),
                          {beyond(0, 0), beyond(0, 0.5), beyond(0.5, last), beyond(last, 1), beyond(1, 1)})
            .value();
    const TrimCurve whole = TrimCurve::create(KnotVector::create(2, {0, 0, 0, 1, 1, 1}).value(),
                                              {{at(0, 0), 1}, {at(0, 1), 1}, {at(1, 1), 1}})
                                .value();
    Scene scene;
    scene.add({.name = "next",
               .surface = plane({-1, -1, 0}, {3, 0, 0}, {0, 3, 0}),
               .trimLoops = {{true, {pieces, polyline({beyond(1, 1).position, beyond(0, 0).position})}}}});
    scene.add({.name = "horn",
               .surface = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
               .trimLoops = {{true, {polyline({{0, 0}, {0.5, 1}}), whole, polyline({{1, 0}, {0, 0}})}}}});
    for (const double deviation : {1e-2, 1e-4, 1e-6}) {
        SCOPED_TRACE(deviation);
        const Tessellation mesh = meshOf(scene, deviation);
        EXPECT_EQ(mesh.crossing, 0U);
        EXPECT_LE(mesh.bound, deviation);
        // The line between the edge's ends has a vertex in its middle, so that it is another one.
        EXPECT_EQ(topologyOf(mesh.mesh).boundaryEdges, 4U);
        EXPECT_EQ(topologyOf(mesh.mesh).nonManifoldEdges, 0U);
    }
}

TEST(TrimmedGaps, ThatTakeMoreRoundsLeaveOtherFacesAsTheyWere)
{
    // A disc with a square hole whose corners are so near to the outline that chords cross them at first,
    // beside a dome that is done in one round.
    Scene scene;
    scene.add({.name = "dome", .surface = sphere({5, 0, 0}, 2), .trimLoops = {{true, {circle({4, 2}, 1)}}}});
    TrimLoop square{false, {}};
    std::vector<Vec2> corners;
    for (int k = 0; k <= 4; ++k)
        corners.push_back(Vec2(0.5) +
                          0.3995 * Vec2(std::cos(0.4 - k % 4 * M_PI / 2), std::sin(0.4 - k % 4 * M_PI / 2)));
    square.curves.push_back(polyline(corners));
    scene.add({.name = "disc",
               .surface = plane({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}),
               .trimLoops = {{true, {circle({0.5, 0.5}, 0.4)}}, square}});
    const Tessellation mesh = meshOf(scene, 0.02);
    EXPECT_LE(mesh.bound, 0.02);
    EXPECT_EQ(mesh.crossing, 0U);
}

}  // namespace
}  // namespace knotspan
