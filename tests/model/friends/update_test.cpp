// Friends kept up to date are those made anew, to the bit.
#include <gtest/gtest.h>

#include "model/friends/friends.h"
#include "model/samples/net.h"
#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

void expectSame(const Friends& kept, const Friends& anew)
{
    ASSERT_EQ(kept.edges().size(), anew.edges().size());
    for (size_t k = 0; k < kept.edges().size(); ++k) {
        const FriendEdge& x = kept.edges()[k];
        const FriendEdge& y = anew.edges()[k];
        EXPECT_TRUE(x == y) << k << ": " << x.a.surface << ", " << x.b.surface;
    }
    EXPECT_EQ(kept.nakedEdges(), anew.nakedEdges());
}

NurbsSurface withMoved(const NurbsSurface& surface, int i, int j, const Vec3& by)
{
    return surfaceOf(surface.knotsU(), surface.knotsV(), [&](int a, int b) {
        ControlPoint point = surface.controlPoint(a, b);
        if (a == i && b == j)
            point.position += by;
        return point;
    });
}

// Moves control points here and there, and back at times.
void editAtRandom(std::vector<NurbsSurface> surfaces, std::vector<Mat4> transforms, unsigned seed, int edits)
{
    std::mt19937 random(seed);
    const std::vector<NurbsSurface> original = surfaces;
    const auto placedNow = [&] {
        std::vector<PlacedSurface> result;
        for (size_t k = 0; k < surfaces.size(); ++k)
            result.push_back({&surfaces[k], transforms[k]});
        return result;
    };
    Friends kept(placedNow());
    for (int edit = 0; edit < edits; ++edit) {
        std::vector<Friends::Change> changes;
        for (unsigned changed = 0; changed < 1 + random() % 3; ++changed) {
            const auto index = static_cast<std::uint32_t>(random() % surfaces.size());
            NurbsSurface& surface = surfaces[index];
            const double size =
                0.2 * surface.bounds().diagonal() * std::pow(0.01, randomBetween(random, 0, 2));
            const Vec3 by = size * Vec3(randomBetween(random, -1, 1), randomBetween(random, -1, 1),
                                        randomBetween(random, -1, 1));
            const auto pick = [&](int count) {
                return static_cast<int>(random() % static_cast<unsigned>(count));
            };
            if (random() % 4 == 0)
                surface = original[index];
            else if (random() % 8 == 0)
                transforms[index][3] += Vec4(0.01 * by, 0);
            else
                surface = withMoved(surface, pick(surface.countU()), pick(surface.countV()), by);
            changes.push_back({index, {&surface, transforms[index]}});
        }
        kept.update(changes);
        expectSame(kept, Friends(placedNow()));
        if (::testing::Test::HasFailure())
            return;
    }
}

std::vector<NurbsSurface> surfacesOf(const Scene& scene)
{
    std::vector<NurbsSurface> result;
    for (const auto& [id, object] : scene.objects())
        result.push_back(object->surface);
    return result;
}

}  // namespace

TEST(FriendsUpdate, IsAsMadeAnewAfterRandomEdits)
{
    std::mt19937 random(81);
    for (unsigned seed = 0; seed < 4; ++seed) {
        const std::vector<NurbsSurface> rows = randomRows(random).surfaces;
        editAtRandom(rows, std::vector<Mat4>(rows.size(), Mat4(1.0)), seed, 40);
    }
    const std::vector<NurbsSurface> parts = surfacesOf(torusWithTJoints());
    editAtRandom(parts, std::vector<Mat4>(parts.size(), Mat4(1.0)), 5, 40);
    const std::vector<NurbsSurface> knot = surfacesOf(findSample("knot")->make());
    editAtRandom(knot, std::vector<Mat4>(knot.size(), Mat4(1.0)), 6, 8);
}

TEST(FriendsUpdate, OfWhatDidNotMoveChangesNothing)
{
    const NurbsSurface ring = surfacesOf(findSample("torus")->make())[0];
    Friends kept({{&ring}});
    const NurbsSurface inside = withMoved(ring, 4, 4, Vec3(0, 0, 0.3));
    kept.update({{0, {&inside}}});
    expectSame(kept, Friends({{&inside}}));
}

}  // namespace knotspan::testing
