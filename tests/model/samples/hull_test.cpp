#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/samples/sample_list.h"

namespace knotspan {
namespace {

// Ids: starboard aft, port aft, starboard midships, port midships, starboard fore, port fore. u runs forward
// on starboard and aft on port, v from keel to deck.
class Hull : public ::testing::Test {
protected:
    [[nodiscard]] const NurbsSurface& starboard(int part) const { return surface(2 * part); }
    [[nodiscard]] const NurbsSurface& port(int part) const { return surface(2 * part + 1); }

    [[nodiscard]] static Vec3 normal(const NurbsSurface& surface, double alongPart, double v)
    {
        const KnotVector& u = surface.knotsU();
        return evaluateNormal(surface, u.domainStart() + alongPart * (u.domainEnd() - u.domainStart()), v)
            .direction;
    }

    static double degreesBetween(const Vec3& a, const Vec3& b)
    {
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::acos(-1.0);
    }

private:
    [[nodiscard]] const NurbsSurface& surface(int index) const
    {
        return scene_.find(ObjectId{static_cast<std::uint32_t>(index)})->surface;
    }

    Scene scene_ = findSample("hull")->make();
};

TEST_F(Hull, PartsOfASideShareBorderTangentAndCurvature)
{
    for (int part = 0; part < 2; ++part)
        for (double v = 0; v <= 6; v += 0.25) {
            const NurbsSurface& aft = starboard(part);
            const NurbsSurface& fore = starboard(part + 1);
            const double cut = fore.knotsU().domainStart();
            const SurfacePoint a = evaluate(aft, cut, v);
            const SurfacePoint b = evaluate(fore, cut, v);
            EXPECT_LE(glm::length(a.position - b.position), 1e-13);
            EXPECT_LE(glm::length(a.du - b.du), 1e-12);
            EXPECT_LE(glm::length(a.duu - b.duu), 1e-11);
            EXPECT_LE(degreesBetween(normal(port(part), 0, v), normal(port(part + 1), 1, v)), 1e-9);
        }
}

TEST_F(Hull, PartsOfASideShareTheirCutsControlPointsToTheBit)
{
    for (int part = 0; part < 2; ++part)
        for (int j = 0; j < starboard(0).countV(); ++j) {
            EXPECT_EQ(starboard(part).controlPoint(starboard(part).countU() - 1, j),
                      starboard(part + 1).controlPoint(0, j));
            EXPECT_EQ(port(part).controlPoint(0, j),
                      port(part + 1).controlPoint(port(part + 1).countU() - 1, j));
        }
}

TEST_F(Hull, PortAndStarboardMeetAtKeelAndStemToTheBit)
{
    for (int part = 0; part < 3; ++part)
        for (int i = 0; i < starboard(part).countU(); ++i)
            EXPECT_EQ(starboard(part).controlPoint(i, 0),
                      port(part).controlPoint(port(part).countU() - 1 - i, 0));
    for (int j = 0; j < starboard(2).countV(); ++j)
        EXPECT_EQ(starboard(2).controlPoint(starboard(2).countU() - 1, j), port(2).controlPoint(0, j));
}

TEST_F(Hull, IsCreasedAlongAllOfKeelAndStem)
{
    for (int part = 0; part < 3; ++part)
        for (double along = 0; along <= 1; along += 0.0625)
            EXPECT_GE(degreesBetween(normal(starboard(part), along, 0), normal(port(part), 1 - along, 0)), 20)
                << part << " at " << along;
    for (double v = 0; v <= 6; v += 0.25)
        EXPECT_GE(degreesBetween(normal(starboard(2), 1, v), normal(port(2), 0, v)), 20);
}

TEST_F(Hull, IsNowhereElseNearlyCreased)
{
    // Normals a hundredth of the length or the girth apart turn by a few degrees at most.
    for (int part = 0; part < 3; ++part)
        for (int i = 0; i < 33; ++i)
            for (int j = 0; j < 100; ++j) {
                const Vec3 here = normal(starboard(part), i / 33.0, j * 0.06);
                EXPECT_LE(degreesBetween(here, normal(starboard(part), (i + 1) / 33.0, j * 0.06)), 6);
                EXPECT_LE(degreesBetween(here, normal(starboard(part), i / 33.0, (j + 1) * 0.06)), 6);
            }
}

TEST_F(Hull, PointsOutwardsAndDown)
{
    for (int part = 0; part < 3; ++part)
        for (double along = 0.05; along < 1; along += 0.1) {
            EXPECT_LT(normal(starboard(part), along, 3).y, 0);
            EXPECT_GT(normal(port(part), along, 3).y, 0);
            EXPECT_LT(normal(starboard(part), along, 0.5).z, 0);
        }
}

}  // namespace
}  // namespace knotspan
