#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/samples/sample_list.h"

namespace knotspan {
namespace {

constexpr int kRound = 12;
constexpr int kAlong = 50;

class Knot : public ::testing::Test {
protected:
    // Surfaces in their order: round the tube first, then along it; both ways wrap.
    [[nodiscard]] const NurbsSurface& surface(int round, int along) const
    {
        return scene_.find(ObjectId{static_cast<std::uint32_t>((along % kAlong) * kRound + round % kRound)})
            ->surface;
    }

    Scene scene_ = findSample("knot")->make();
};

TEST_F(Knot, IsMadeOfBicubicSurfacesOfFiveByFiveKsQuads)
{
    for (const auto& [id, object] : scene_.objects()) {
        EXPECT_EQ(object->surface.degreeU(), 3);
        EXPECT_EQ(object->surface.degreeV(), 3);
        EXPECT_EQ(object->surface.knotsU().spans().size(), 5u);
        EXPECT_EQ(object->surface.knotsV().spans().size(), 5u);
        EXPECT_FALSE(object->surface.isRational());
    }
}

TEST_F(Knot, NeighboursShareTheirBordersControlPointsToTheBit)
{
    for (int along = 0; along < kAlong; ++along)
        for (int round = 0; round < kRound; ++round)
            for (int k = 0; k < 8; ++k) {
                const NurbsSurface& here = surface(round, along);
                ASSERT_EQ(here.controlPoint(7, k), surface(round + 1, along).controlPoint(0, k))
                    << "round " << round << ", along " << along;
                ASSERT_EQ(here.controlPoint(k, 7), surface(round, along + 1).controlPoint(k, 0))
                    << "round " << round << ", along " << along;
            }
}

TEST_F(Knot, NeighboursShareTangentsAndCurvature)
{
    for (int along = 0; along < kAlong; ++along)
        for (int round = 0; round < kRound; ++round)
            for (const double t : {0.0, 1.3, 4.9}) {
                const SurfacePoint a = evaluate(surface(round, along), 5, t);
                const SurfacePoint b = evaluate(surface(round + 1, along), 0, t);
                EXPECT_LE(glm::length(a.du - b.du), 1e-13);
                EXPECT_LE(glm::length(a.duu - b.duu), 1e-12);
                const SurfacePoint c = evaluate(surface(round, along), t, 5);
                const SurfacePoint d = evaluate(surface(round, along + 1), t, 0);
                EXPECT_LE(glm::length(c.dv - d.dv), 1e-13);
                EXPECT_LE(glm::length(c.dvv - d.dvv), 1e-12);
            }
}

// Between points of stations that are far apart along the tube.
TEST_F(Knot, DoesNotTouchItself)
{
    std::vector<std::vector<Vec3>> rings(kAlong * 2);
    std::vector<Vec3> middles(kAlong * 2);
    for (int station = 0; station < kAlong * 2; ++station) {
        auto& ring = rings[static_cast<size_t>(station)];
        for (int round = 0; round < kRound; ++round)
            for (const double u : {0.0, 2.5})
                ring.push_back(evaluate(surface(round, station / 2), u, station % 2 == 0 ? 0 : 2.5).position);
        for (const Vec3& point : ring)
            middles[static_cast<size_t>(station)] += point / static_cast<double>(ring.size());
    }
    // A point of the tube is nearer to its own middle line than to a part of it elsewhere.
    for (size_t a = 0; a < rings.size(); ++a)
        for (const Vec3& point : rings[a])
            for (size_t b = 0; b < rings.size(); ++b) {
                const size_t apart = std::min(a > b ? a - b : b - a, rings.size() - (a > b ? a - b : b - a));
                const double own = glm::length(point - middles[a]);
                if (apart > 12) {
                    EXPECT_GT(glm::length(point - middles[b]), own + 0.02);
                }
            }
}

}  // namespace
}  // namespace knotspan
