// The tables of common borders through edits.
#include "renderer/scene/shared_edges.h"

#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "model/samples/samples.h"
#include "tests/joined_surfaces.h"

namespace knotspan::testing {
namespace {

template <class T>
bool haveSameBits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool haveSameBits(const BorderTables& a, const BorderTables& b)
{
    return haveSameBits(a.sides, b.sides) && haveSameBits(a.corners, b.corners) &&
           haveSameBits(a.pieces, b.pieces) && haveSameBits(a.uses, b.uses);
}

// The surface with some control points pulled, or as it was first.
NurbsSurface edited(const NurbsSurface& now, const NurbsSurface& first, std::mt19937& random)
{
    std::vector<ControlPoint> points = now.controlPoints();
    const size_t chosen = random() % points.size();
    switch (random() % 4) {
    case 0:
        return first;
    case 1:
        points[chosen].weight *= 1.5;
        break;
    case 2:
        points[chosen] = first.controlPoints()[chosen];
        break;
    default:
        points[chosen].position += Vec3(0.05, -0.02, 0.1);
    }
    return NurbsSurface::create(now.knotsU(), now.knotsV(), std::move(points)).value();
}

TEST(SharedEdges, TablesAfterEditsEqualThoseMadeAnewToTheBit)
{
    std::mt19937 random(4);
    for (int trial = 0; trial < 30; ++trial) {
        const Joined joined = randomRows(random);
        std::vector<NurbsSurface> surfaces = joined.surfaces;
        std::vector<PlacedSurface> now = placed(surfaces);
        SharedEdges edges(now);
        for (int edit = 0; edit < 20; ++edit) {
            std::vector<CoincidentEdges::Change> changes;
            for (std::uint32_t k = 0; k < surfaces.size(); ++k) {
                if (random() % 6 != 0)
                    continue;
                surfaces[k] = edited(surfaces[k], joined.surfaces[k], random);
                if (random() % 4 == 0)
                    now[k].transform[3].z = now[k].transform[3].z == 0.0 ? 0.25 : 0.0;
                changes.push_back({k, now[k]});
            }
            edges.update(changes);
            ASSERT_TRUE(haveSameBits(edges.tables(), SharedEdges(now).tables()))
                << trial << ", edit " << edit;
        }
    }
}

TEST(SharedEdges, EditsInsideASurfaceTouchNoTable)
{
    const Scene knot = makeKnot();
    std::vector<PlacedSurface> surfaces = placed(knot);
    SharedEdges edges(surfaces);
    std::vector<ControlPoint> points = surfaces[5].surface->controlPoints();
    points[27].position += Vec3(0.01, 0.02, 0.03);
    const NurbsSurface moved =
        NurbsSurface::create(surfaces[5].surface->knotsU(), surfaces[5].surface->knotsV(), points).value();
    EXPECT_FALSE(edges.update({{5, {&moved, Mat4(1.0)}}}).has_value());
}

}  // namespace
}  // namespace knotspan::testing
