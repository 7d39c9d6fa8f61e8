// Bodies among joined surfaces: which are closed, which way they are turned. Oracles: the shapes' own
// formulas, not the code that joins borders.
#include "model/analysis/shells.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "model/analysis/border_cover.h"
#include "model/geometry/evaluation.h"
#include "model/geometry/knot_insertion.h"
#include "model/geometry/primitives.h"
#include "model/samples/net.h"
#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"
#include "tests/shell_samples.h"

namespace knotspan::testing {
namespace {

using Surfaces = std::vector<PlacedSurface>;

Shells shellsOf(const Surfaces& surfaces)
{
    return Shells(surfaces, CoincidentEdges(surfaces));
}

std::vector<int> sidesOf(const Surfaces& surfaces)
{
    const Shells shells = shellsOf(surfaces);
    std::vector<int> sides;
    for (std::uint32_t surface = 0; surface < surfaces.size(); ++surface)
        sides.push_back(shells.side(surface));
    return sides;
}

// A small step from the surface's middle to the side that is told leads out, one to the other side leads in.
void expectSidesLeadOut(const Surfaces& surfaces, const Inside& isInside, const std::string& name)
{
    const std::vector<int> sides = sidesOf(surfaces);
    for (size_t k = 0; k < surfaces.size(); ++k) {
        const NurbsSurface& surface = *surfaces[k].surface;
        const double u = 0.61 * surface.knotsU().domainStart() + 0.39 * surface.knotsU().domainEnd();
        const double v = 0.43 * surface.knotsV().domainStart() + 0.57 * surface.knotsV().domainEnd();
        const SurfacePoint at = evaluate(surface, u, v);
        const Vec3 out =
            1e-2 * surface.bounds().diagonal() * glm::normalize(glm::cross(at.du, at.dv)) * double(sides[k]);
        ASSERT_NE(sides[k], 0) << name;
        EXPECT_FALSE(isInside(transformed(at.position + out, surfaces[k].transform))) << name << " " << k;
        EXPECT_TRUE(isInside(transformed(at.position - out, surfaces[k].transform))) << name << " " << k;
    }
}

TEST(Shells, OfClosedSamplesAreOneBodyWhoseNormalsPointOutwards)
{
    for (const char* name : {"sphere", "torus", "knot"}) {
        const Scene scene = findSample(name)->make();
        const Surfaces surfaces = placed(scene);
        const Shells shells = shellsOf(surfaces);
        EXPECT_EQ(shells.count(), 1U) << name;
        EXPECT_TRUE(shells.isClosed(0)) << name;
        const std::vector<int> sides = sidesOf(surfaces);
        EXPECT_EQ(std::count(sides.begin(), sides.end(), 1), static_cast<int>(surfaces.size())) << name;
        expectSidesLeadOut(surfaces, insideOf(name), name);
    }
}

TEST(Shells, OfSheetsAreOpenAndHaveNoSide)
{
    for (const char* name : {"single-100", "nine-16", "hull"}) {
        const Scene scene = findSample(name)->make();
        const Shells shells = shellsOf(placed(scene));
        EXPECT_EQ(shells.count(), 1U) << name;
        EXPECT_FALSE(shells.isClosed(0)) << name;
        EXPECT_EQ(shells.side(0), 0) << name;
        EXPECT_FALSE(shells.isOutside(0, Vec3(1e6), 0)) << name;
        EXPECT_FALSE(shells.isOutsideAlong(0, Vec3(0, 0, 1), -1e6)) << name;
    }
}

TEST(Shells, GoThroughJointsReversalsAndOtherDegrees)
{
    const Scene scene = torusWithTJoints();
    const Shells shells = shellsOf(placed(scene));
    EXPECT_EQ(shells.count(), 1U);
    EXPECT_TRUE(shells.isClosed(0));
    EXPECT_EQ(sidesOf(placed(scene)), (std::vector<int>{1, 1, 1, -1, 1, -1}));
    expectSidesLeadOut(placed(scene), insideOf("torus"), "T-joints");
}

TEST(Shells, WithoutOneOfTheirSurfacesAreOpen)
{
    const Scene scene = torusWithTJoints();
    Surfaces surfaces = placed(scene);
    surfaces.erase(surfaces.begin() + 2);
    EXPECT_FALSE(shellsOf(surfaces).isClosed(0));
    EXPECT_EQ(sidesOf(surfaces), std::vector<int>(5, 0));
}

TEST(Shells, TurnedInsideOutHaveTheirNormalsInside)
{
    for (const char* name : {"sphere", "torus"}) {
        const Scene scene = findSample(name)->make();
        const std::vector<NurbsSurface> turned = {reversedU(scene.objects().begin()->second->surface)};
        EXPECT_EQ(sidesOf(placed(turned)), std::vector<int>{-1}) << name;
    }
}

// In front of a point is in front of it in any affine coordinates, while S_u x S_v turns in a mirror.
TEST(Shells, KeepTheirSideInAMirror)
{
    const Scene scene = torusWithTJoints();
    Surfaces surfaces = placed(scene);
    for (PlacedSurface& one : surfaces)
        one.transform = glm::translate(Mat4(1), Vec3(3, -2, 1)) * glm::scale(Mat4(1), Vec3(-2, 0.5, 1));
    EXPECT_EQ(sidesOf(surfaces), (std::vector<int>{1, 1, 1, -1, 1, -1}));
    expectSidesLeadOut(
        surfaces, [](const Vec3& p) { return insideOf("torus")((p - Vec3(3, -2, 1)) / Vec3(-2, 0.5, 1)); },
        "mirrored");
}

TEST(Shells, JoinAHalfWithItsMirrorImage)
{
    const Scene scene = findSample("torus")->make();
    const NurbsSurface& whole = scene.objects().begin()->second->surface;
    for (const Direction direction : {Direction::U, Direction::V}) {
        const NurbsSurface half = clampedPart(whole, direction, 0, 4);
        const Vec3 middle =
            evaluate(half, direction == Direction::U ? 2 : 0, direction == Direction::U ? 0 : 2).position;
        // Halves round the axis lie on one side of it; halves of the circle above or below z = 0.
        const Vec3 mirror = std::abs(middle.z) > 0.5   ? Vec3(1, 1, -1)
                            : std::abs(middle.y) > 0.5 ? Vec3(1, -1, 1)
                                                       : Vec3(-1, 1, 1);
        const Surfaces surfaces = {{&half, Mat4(1)}, {&half, glm::scale(Mat4(1), mirror)}};
        EXPECT_EQ(shellsOf(surfaces).count(), 1U);
        EXPECT_EQ(sidesOf(surfaces), (std::vector<int>{1, 1}));
        expectSidesLeadOut(surfaces, insideOf("torus"), "half and mirror image");
    }
}

TEST(Shells, AreCountedApartAndToldTheirSurfaces)
{
    std::vector<NurbsSurface> faces = boxFaces({0, 0, 0}, {1, 1, 1});
    for (const NurbsSurface& face : boxFaces({3, 0, 0}, {4, 2, 1}))
        faces.push_back(face);
    std::swap(faces[2], faces[8]);
    const Shells shells = shellsOf(placed(faces));
    ASSERT_EQ(shells.count(), 2U);
    for (std::uint32_t k = 0; k < 12; ++k)
        EXPECT_EQ(shells.shellOf(k), k == 2 || (k >= 6 && k != 8) ? 1U : 0U);
    EXPECT_TRUE(shells.isClosed(0));
    EXPECT_TRUE(shells.isClosed(1));
    expectSidesLeadOut(
        placed(faces),
        [](const Vec3& p) {
            return p.y > 0 && p.z > 0 && p.z < 1 &&
                   ((p.x > 0 && p.x < 1 && p.y < 1) || (p.x > 3 && p.x < 4 && p.y < 2));
        },
        "boxes");
}

TEST(Shells, ThatMeetAlongAnEdgeAreNoBodies)
{
    std::vector<NurbsSurface> faces = boxFaces({0, 0, 0}, {1, 1, 1});
    for (const NurbsSurface& face : boxFaces({1, 1, 0}, {2, 2, 1}))
        faces.push_back(face);
    const Surfaces surfaces = placed(faces);
    const Shells shells = shellsOf(surfaces);
    EXPECT_EQ(shells.count(), 1U);
    EXPECT_FALSE(shells.isClosed(0));
    EXPECT_EQ(sidesOf(surfaces), std::vector<int>(12, 0));
    const CoincidentEdges edges(surfaces);
    std::uint32_t most = 0;
    for (std::uint32_t side = 0; side < edges.sideCount(); ++side) {
        most = std::max(most, coverOf(edges, side).most);
        EXPECT_TRUE(isClosedSide(edges, side));
    }
    EXPECT_EQ(most, 3U);
}

TEST(Shells, WithoutVolumeHaveNoSide)
{
    const std::vector<NurbsSurface> twice = {curvedSheet(), reversedU(curvedSheet())};
    const Shells shells = shellsOf(placed(twice));
    EXPECT_TRUE(shells.isClosed(0));
    EXPECT_EQ(shells.side(0), 0);
}

TEST(Shells, ThatAreTwistedHaveNoSide)
{
    const std::vector<NurbsSurface> bottle = {kleinBottle()};
    const Shells shells = shellsOf(placed(bottle));
    EXPECT_TRUE(shells.isClosed(0));
    EXPECT_EQ(shells.side(0), 0);
    EXPECT_FALSE(shells.isOutside(0, Vec3(1e6), 0));
}

// The sphere whose north pole stands at that height.
NurbsSurface dentedSphere(double height)
{
    const NurbsSurface ball = sphere(Vec3(0), 1);
    return surfaceOf(ball.knotsU(), ball.knotsV(), [&](int i, int j) {
        ControlPoint point = ball.controlPoint(i, j);
        if (j == ball.countV() - 1)
            point.position.z = height;
        return point;
    });
}

// From below one would see the inside of the sphere's skin on the spike that comes out there.
TEST(Shells, ThatGoThroughThemselvesHaveNoSide)
{
    for (const double height : {1.5, 0.0, -0.9}) {
        const std::vector<NurbsSurface> dented = {dentedSphere(height)};
        EXPECT_EQ(sidesOf(placed(dented)), std::vector<int>{1}) << height;
    }
    for (const double height : {-1.1, -1.5}) {
        const std::vector<NurbsSurface> pierced = {dentedSphere(height)};
        EXPECT_TRUE(shellsOf(placed(pierced)).isClosed(0));
        EXPECT_EQ(sidesOf(placed(pierced)), std::vector<int>{0}) << height;
    }
}

// The knot squeezed flat: hundreds of its surfaces go through each other.
TEST(Shells, ThatGoThroughThemselvesInManyPlacesHaveNoSideUntilTheyStop)
{
    const Scene scene = findSample("knot")->make();
    const Surfaces surfaces = placed(scene);
    std::vector<NurbsSurface> squeezed;
    for (const PlacedSurface& one : surfaces)
        squeezed.push_back(surfaceOf(one.surface->knotsU(), one.surface->knotsV(), [&](int i, int j) {
            ControlPoint point = one.surface->controlPoint(i, j);
            point.position.z *= 0.3;
            point.position.x += 1.4 * std::tanh(3 * point.position.z) * point.position.y;
            point.position.z = std::sin(9 * point.position.z);
            return point;
        }));
    const Surfaces crushed = placed(squeezed);
    CoincidentEdges edges(crushed);
    Shells shells(crushed, edges);
    EXPECT_TRUE(shells.isClosed(0));
    EXPECT_EQ(shells.side(0), 0);
    std::vector<CoincidentEdges::Change> back;
    for (std::uint32_t k = 0; k < surfaces.size(); ++k)
        back.push_back({k, surfaces[k]});
    edges.update(back);
    shells.update(back, edges);
    EXPECT_EQ(shells.side(0), 1);
}

// Two rows of control points of the torus exchanged: its skin loops within neighbouring KSQuads.
TEST(Shells, ThatFoldThroughThemselvesHaveNoSide)
{
    const NurbsSurface ring = torus(Vec3(0), 2, 0.75);
    const std::vector<NurbsSurface> folded = {surfaceOf(ring.knotsU(), ring.knotsV(), [&](int i, int j) {
        return ring.controlPoint(i, j == 4 ? 7 : j == 7 ? 4 : j);
    })};
    EXPECT_TRUE(shellsOf(placed(folded)).isClosed(0));
    EXPECT_EQ(sidesOf(placed(folded)), std::vector<int>{0});
}

TEST(Shells, MayBeThin)
{
    const std::vector<NurbsSurface> plate = boxFaces({0, 0, 0}, {1, 1, 1});
    Surfaces surfaces = placed(plate);
    for (PlacedSurface& one : surfaces)
        one.transform =
            glm::rotate(Mat4(1), 0.6, glm::normalize(Vec3(1, 2, 3))) * glm::scale(Mat4(1), Vec3(1, 1, 1e-4));
    const std::vector<int> sides = sidesOf(surfaces);
    EXPECT_EQ(std::count(sides.begin(), sides.end(), 0), 0);
}

TEST(Shells, GetTheirSidesBackWhenTheyStopGoingThroughThemselves)
{
    const NurbsSurface dented = dentedSphere(-0.5);
    const NurbsSurface pierced = dentedSphere(-1.5);
    CoincidentEdges edges({{&dented}});
    Shells shells({{&dented}}, edges);
    for (const auto* surface : {&pierced, &dented, &pierced, &dented}) {
        edges.update({{0, {surface}}});
        shells.update({{0, {surface}}}, edges);
        EXPECT_EQ(shells.side(0), surface == &dented ? 1 : 0);
    }
}

TEST(Shells, FollowTheirSurfaces)
{
    const Scene scene = torusWithTJoints();
    Surfaces surfaces = placed(scene);
    CoincidentEdges edges(surfaces);
    Shells shells(surfaces, edges);
    const auto move = [&](std::uint32_t surface, const Mat4& transform) {
        surfaces[surface].transform = transform;
        edges.update({{surface, surfaces[surface]}});
        shells.update({{surface, surfaces[surface]}}, edges);
    };
    move(1, glm::translate(Mat4(1), Vec3(0, 0, 0.01)));
    EXPECT_FALSE(shells.isClosed(shells.shellOf(0)));
    EXPECT_EQ(shells.side(0), 0);
    move(1, Mat4(1));
    EXPECT_EQ(shells.count(), 1U);
    EXPECT_EQ(shells.side(3), -1);
    for (std::uint32_t surface = 0; surface < surfaces.size(); ++surface)
        move(surface, glm::translate(Mat4(1), Vec3(100, 0, 0)));
    EXPECT_EQ(shells.side(3), -1);
    EXPECT_TRUE(shells.isOutside(0, Vec3(0, 0, 0), 1));
    EXPECT_FALSE(shells.isOutside(0, Vec3(102, 0, 0), 0));
}

}  // namespace
}  // namespace knotspan::testing
