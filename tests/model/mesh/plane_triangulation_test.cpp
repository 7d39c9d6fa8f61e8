// Triangulations of random places and edges, by what has to hold of every one of them.
#include "model/mesh/plane_triangulation.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace knotspan {
namespace {

using Places = std::vector<GridPlace>;

std::int64_t doubleArea(const PlaneTriangulation& plain, const PlaneTriangulation::Corners& triangle)
{
    const GridPlace& a = plain.places()[triangle.vertices[0]];
    const GridPlace& b = plain.places()[triangle.vertices[1]];
    const GridPlace& c = plain.places()[triangle.vertices[2]];
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// All triangles turn left, neighbours know each other, and together they cover the square once.
void expectWhole(const PlaneTriangulation& plain)
{
    std::int64_t area = 0;
    for (std::uint32_t k = 0; k < plain.triangles().size(); ++k) {
        const auto& triangle = plain.triangles()[k];
        ASSERT_GT(doubleArea(plain, triangle), 0);
        area += doubleArea(plain, triangle);
        for (size_t i = 0; i < 3; ++i) {
            const std::uint32_t other = triangle.neighbours[i];
            if (other == PlaneTriangulation::kNone)
                continue;
            const auto& next = plain.triangles()[other];
            const auto back = std::find(next.neighbours.begin(), next.neighbours.end(), k);
            ASSERT_NE(back, next.neighbours.end());
            const auto j = static_cast<size_t>(back - next.neighbours.begin());
            EXPECT_EQ(next.fixed[j], triangle.fixed[i]);
            EXPECT_EQ(next.vertices[(j + 1) % 3], triangle.vertices[(i + 2) % 3]);
        }
    }
    const std::int64_t side = PlaneTriangulation::kMost + PlaneTriangulation::kMost / 2;
    EXPECT_EQ(area, 2 * side * side);
    EXPECT_EQ(plain.triangles().size(), 2 * plain.places().size() - 6);
}

__extension__ using Wide = __int128;

// No vertex of a neighbour lies within a triangle's circle, but across edges that must be there.
size_t edgesThatAreNotDelaunay(const PlaneTriangulation& plain)
{
    size_t count = 0;
    for (const auto& triangle : plain.triangles())
        for (size_t i = 0; i < 3; ++i) {
            if (triangle.fixed[i] || triangle.neighbours[i] == PlaneTriangulation::kNone)
                continue;
            for (const std::uint32_t vertex : plain.triangles()[triangle.neighbours[i]].vertices) {
                const GridPlace d = plain.places()[vertex];
                std::array<std::array<Wide, 3>, 3> m{};
                for (size_t row = 0; row < 3; ++row) {
                    const GridPlace& p = plain.places()[triangle.vertices[row]];
                    const Wide x = p.x - d.x;
                    const Wide y = p.y - d.y;
                    m[row] = {x, y, x * x + y * y};
                }
                const Wide inside = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                                    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                                    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
                count += inside > 0 ? 1 : 0;
            }
        }
    return count;
}

GridPlace randomPlace(std::mt19937& random, std::int64_t most)
{
    std::uniform_int_distribution<std::int64_t> number(0, most);
    return {number(random), number(random)};
}

TEST(PlaneTriangulation, OfRandomPlacesIsDelaunay)
{
    std::mt19937 random(1);
    // On few places many lie on lines and circles of others.
    for (const std::int64_t most : {std::int64_t{6}, std::int64_t{40}, PlaneTriangulation::kMost}) {
        PlaneTriangulation plain;
        std::set<std::pair<std::int64_t, std::int64_t>> known;
        for (int k = 0; k < 600; ++k) {
            const GridPlace place = randomPlace(random, most);
            const std::uint32_t vertex = plain.add(place);
            EXPECT_EQ(plain.places()[vertex], place);
            known.insert({place.x, place.y});
        }
        EXPECT_EQ(plain.places().size(), known.size() + PlaneTriangulation::kCorners);
        expectWhole(plain);
        EXPECT_EQ(edgesThatAreNotDelaunay(plain), 0U);
    }
}

TEST(PlaneTriangulation, HasEveryEdgeThatItTook)
{
    std::mt19937 random(2);
    int refused = 0;
    int taken = 0;
    for (int round = 0; round < 60; ++round) {
        const std::int64_t most = round % 2 == 0 ? 30 : PlaneTriangulation::kMost;
        PlaneTriangulation plain;
        std::vector<std::uint32_t> vertices;
        for (int k = 0; k < 120; ++k)
            vertices.push_back(plain.add(randomPlace(random, most)));
        std::vector<std::array<std::uint32_t, 2>> edges;
        for (int k = 0; k < 40; ++k) {
            const std::uint32_t from = vertices[random() % vertices.size()];
            const std::uint32_t to = vertices[random() % vertices.size()];
            if (from == to)
                continue;
            if (const auto obstacle = plain.connect(from, to)) {
                ++refused;
                // What is in the way is: a vertex on the way, or an edge that was taken and crosses.
                EXPECT_TRUE(obstacle->from == obstacle->to ||
                            plain.find(obstacle->from, obstacle->to).triangle != PlaneTriangulation::kNone);
                continue;
            }
            ++taken;
            edges.push_back({from, to});
        }
        expectWhole(plain);
        EXPECT_EQ(edgesThatAreNotDelaunay(plain), 0U);
        for (const auto& [from, to] : edges) {
            const auto edge = plain.find(from, to);
            ASSERT_NE(edge.triangle, PlaneTriangulation::kNone);
            EXPECT_TRUE(plain.triangles()[edge.triangle].fixed[static_cast<size_t>(edge.corner)]);
        }
    }
    EXPECT_GT(refused, 100);
    EXPECT_GT(taken, 500);
}

TEST(PlaneTriangulation, KnowsInsideByCrossings)
{
    PlaneTriangulation plain;
    std::set<std::pair<std::uint32_t, std::uint32_t>> border;
    const auto addLoop = [&](const Places& places) {
        std::vector<std::uint32_t> loop;
        for (const GridPlace& place : places)
            loop.push_back(plain.add(place));
        for (size_t k = 0; k < loop.size(); ++k) {
            const std::uint32_t next = loop[(k + 1) % loop.size()];
            ASSERT_FALSE(plain.connect(loop[k], next));
            border.insert(std::minmax(loop[k], next));
        }
    };
    addLoop({{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}});
    addLoop({{300, 300}, {300, 600}, {600, 600}, {600, 300}});
    plain.markInside(
        [&](std::uint32_t from, std::uint32_t to) { return border.count(std::minmax(from, to)) != 0; });
    const auto areaInside = [&] {
        std::int64_t area = 0;
        for (const auto& triangle : plain.triangles())
            area += triangle.inside ? doubleArea(plain, triangle) : 0;
        return area;
    };
    EXPECT_EQ(areaInside(), 2 * (1000 * 1000 - 300 * 300));
    EXPECT_FALSE(plain.addInside({450, 450}));
    EXPECT_FALSE(plain.addInside({2000, 450}));
    EXPECT_FALSE(plain.addInside({300, 450}));
    EXPECT_TRUE(plain.addInside({150, 450}));
    EXPECT_EQ(areaInside(), 2 * (1000 * 1000 - 300 * 300));
    expectWhole(plain);
}

}  // namespace
}  // namespace knotspan
