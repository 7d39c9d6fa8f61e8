// Whether eyes are told apart that are outside of bodies: never wrongly, and nearly always where it matters.
#include "model/analysis/shell_mesh.h"

#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/analysis/shells.h"
#include "model/analysis/solid_angles.h"
#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"
#include "tests/random_surface.h"
#include "tests/shell_samples.h"

namespace knotspan::testing {
namespace {

struct Body {
    std::string name;
    std::string formula;
    Scene scene;
    int eyes;
};

std::vector<Body> bodies()
{
    std::vector<Body> all = {{"torus with T-joints", "torus", torusWithTJoints(), 4000}};
    for (const char* name : {"sphere", "torus"})
        all.push_back({name, name, findSample(name)->make(), 4000});
    all.push_back({"knot", "knot", findSample("knot")->make(), 300});
    return all;
}

Vec3 randomIn(std::mt19937& random, const Box& box, double wider)
{
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const double extra = wider * box.size()[axis];
        point[axis] = randomBetween(random, box.low[axis] - extra, box.high[axis] + extra);
    }
    return point;
}

TEST(ShellMesh, NeverTakesAnEyeInsideForOneOutsideAndSeldomTheOtherWayRound)
{
    std::mt19937 random(5);
    for (const Body& body : bodies()) {
        const auto surfaces = placed(body.scene);
        const Shells shells(surfaces, CoincidentEdges(surfaces));
        const Inside isInside = insideOf(body.formula);
        const Box box = body.scene.bounds();
        const double clear = 0.03 * box.diagonal();
        int inside = 0;
        int clearOutside = 0;
        int shown = 0;
        for (int k = 0; k < body.eyes; ++k) {
            const Vec3 eye = randomIn(random, box, 0.02);
            const double radius = k % 2 == 0 ? 0 : randomBetween(random, 0, 0.01) * box.diagonal();
            const bool isOutside = shells.isOutside(0, eye, radius);
            const double distance = distanceTo(body.formula, eye);
            if (isInside(eye)) {
                ++inside;
                EXPECT_FALSE(isOutside) << body.name << " " << k;
            } else if (distance > clear) {
                ++clearOutside;
                shown += isOutside ? 1 : 0;
            }
            if (body.formula != "knot" && distance < radius) {
                EXPECT_FALSE(isOutside) << body.name << " " << k << ", the ball cuts the surface";
            }
        }
        EXPECT_GT(inside, body.eyes / 20) << body.name;
        EXPECT_GE(shown, 0.95 * clearOutside) << body.name;
    }
}

// Where hulls are thick beside the gap the pieces of KSQuads and the triangles between them decide.
TEST(ShellMesh, TellsEyesApartThatAreCloseToTheSurface)
{
    std::mt19937 random(6);
    for (const Body& body : bodies()) {
        if (body.formula == "knot")
            continue;
        const auto surfaces = placed(body.scene);
        const Shells shells(surfaces, CoincidentEdges(surfaces));
        const Inside isInside = insideOf(body.formula);
        int outside = 0;
        int shown = 0;
        for (int k = 0; k < 3000; ++k) {
            Vec3 eye = randomIn(random, body.scene.bounds(), 0);
            const Vec3 ring = body.formula == "sphere" ? Vec3(0) : 2.0 * Vec3(glm::normalize(Vec2(eye)), 0);
            const double radius = body.formula == "sphere" ? 1 : 0.75;
            eye = ring + glm::normalize(eye - ring) * radius * (1 + randomBetween(random, -0.02, 0.02));
            const bool isOutside = shells.isOutside(0, eye, 0);
            if (isInside(eye)) {
                EXPECT_FALSE(isOutside) << body.name << " " << k;
                continue;
            }
            ++outside;
            shown += isOutside ? 1 : 0;
        }
        // Two percent of the radius and nearer.
        EXPECT_GE(shown, (body.name == body.formula ? 0.8 : 0.7) * outside) << body.name;
    }
}

TEST(ShellMesh, SeesTheHoleOfATorusAsOutside)
{
    for (const Scene& scene : {findSample("torus")->make(), torusWithTJoints()}) {
        const auto surfaces = placed(scene);
        const Shells shells(surfaces, CoincidentEdges(surfaces));
        EXPECT_TRUE(shells.isOutside(0, Vec3(0, 0, 0), 0.5));
        EXPECT_FALSE(shells.isOutside(0, Vec3(0, 0, 0), 1.26));
        EXPECT_FALSE(shells.isOutside(0, Vec3(2, 0, 0), 0));
        EXPECT_FALSE(shells.isOutside(0, Vec3(std::nan("")), 0));
    }
}

TEST(ShellMesh, WorksFarFromTheOriginAndInAMirror)
{
    const Scene scene = torusWithTJoints();
    auto surfaces = placed(scene);
    const Vec3 place(1e7, -2e7, 3e6);
    for (PlacedSurface& one : surfaces)
        one.transform = glm::translate(Mat4(1), place) * glm::scale(Mat4(1), Vec3(-1, 1, 2));
    const Shells shells(surfaces, CoincidentEdges(surfaces));
    ASSERT_EQ(shells.side(0), 1);
    EXPECT_TRUE(shells.isOutside(0, place, 0.3));
    EXPECT_FALSE(shells.isOutside(0, place + Vec3(2, 0, 0), 0.3));
}

TEST(ShellMesh, IsSeenFromOutsideByEyesAtInfinityUnlessTheNearPlaneCutsIt)
{
    const Scene scene = findSample("sphere")->make();
    const auto surfaces = placed(scene);
    const Shells shells(surfaces, CoincidentEdges(surfaces));
    EXPECT_TRUE(shells.isOutsideAlong(0, Vec3(0, 0, -1), -2));
    EXPECT_FALSE(shells.isOutsideAlong(0, Vec3(0, 0, -1), -0.5));
    EXPECT_FALSE(shells.isOutsideAlong(0, Vec3(0, 0, -1), 0.9));
    EXPECT_TRUE(shells.isOutsideAlong(0, Vec3(0, 0, -1), 2));
}

TEST(SolidAngles, OfAMeshThatWindsTwiceAreTwoTurns)
{
    const Vec3 corners[] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    SolidAngles angles(Vec3(0.1, 0.2, -0.1));
    for (int times = 0; times < 2; ++times)
        for (int left = 0; left < 4; ++left) {
            const Vec3& a = corners[(left + 1) % 4];
            const Vec3& b = corners[(left + (left % 2 == 0 ? 2 : 3)) % 4];
            const Vec3& c = corners[(left + (left % 2 == 0 ? 3 : 2)) % 4];
            angles.addTriangle(a, b, c);
        }
    ASSERT_TRUE(angles.windings());
    EXPECT_EQ(std::abs(*angles.windings()), 2);
}

TEST(SolidAngles, OfAnOpenMeshAreNoNumberOfTurns)
{
    SolidAngles angles(Vec3(0));
    angles.addTriangle({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    EXPECT_FALSE(angles.windings());
}

}  // namespace
}  // namespace knotspan::testing
