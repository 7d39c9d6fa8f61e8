// What finding friends takes: printed, and held against limits ten times what is asked of a quiet machine, so
// that only a blunder fails.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>

#include "model/friends/friends.h"
#include "model/samples/net.h"
#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"

namespace knotspan::testing {

namespace {

template <class Work>
double millisecondsOf(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// A field of count x count bicubic surfaces of 2 x 2 spans; each told its own way, rational every third.
std::vector<NurbsSurface> field(int count)
{
    std::vector<NurbsSurface> surfaces;
    const KnotVector knots = clampedIntegerKnots(3, 2);
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b) {
            const bool rational = (a + b) % 3 == 0;
            NurbsSurface surface = surfaceOf(knots, knots, [&](int i, int j) -> ControlPoint {
                const double x = a + grevilleAbscissa(knots, i) / 2;
                const double y = b + grevilleAbscissa(knots, j) / 2;
                const bool inner = i > 0 && i < 4 && j > 0 && j < 4;
                return {{x, y, std::sin(x) * std::cos(1.3 * y)}, rational && inner ? 1.2 : 1.0};
            });
            if ((a + 2 * b) % 4 == 1)
                surface = reversedU(surface);
            if ((a + 2 * b) % 4 == 2)
                surface = exchanged(surface);
            surfaces.push_back(std::move(surface));
        }
    return surfaces;
}

}  // namespace

TEST(FriendsTiming, OfTenThousandEdges)
{
    const std::vector<NurbsSurface> surfaces = field(50);
    size_t found = 0;
    const double ms = millisecondsOf([&] { found = Friends(placed(surfaces)).edges().size(); });
    std::cout << 4 * surfaces.size() << " edges, " << found << " meetings: " << ms << " ms\n";
    EXPECT_EQ(found, 2U * 50 * 49);
    EXPECT_LT(ms, 20000);
}

TEST(FriendsTiming, OfKnotWholeAndAfterOnePointMoved)
{
    const Scene scene = findSample("knot")->make();
    const std::vector<PlacedSurface> surfaces = placed(scene);
    Friends friends;
    const double whole = millisecondsOf([&] { friends = Friends(surfaces); });
    const NurbsSurface& surface = *surfaces[100].surface;
    std::vector<ControlPoint> points = surface.controlPoints();
    points[0].position += Vec3(0.05, 0.02, 0.03);
    const NurbsSurface moved = NurbsSurface::create(surface.knotsU(), surface.knotsV(), points).value();
    double fastest = 1e9;
    for (int k = 0; k < 10; ++k)
        fastest =
            std::min(fastest, millisecondsOf([&] {
                         friends.update({{100, {k % 2 == 0 ? &moved : &surface, surfaces[100].transform}}});
                     }));
    std::cout << "knot: " << whole << " ms; after one point moved: " << fastest << " ms\n";
    EXPECT_LT(whole, 10000);
    EXPECT_LT(fastest, 50);
}

}  // namespace knotspan::testing
