// Shapes against the formulas that define them, in random places.
#include "model/making/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "tests/model/making/making_samples.h"

namespace knotspan::testing {

namespace {

// A point seen from the placement, found without its matrix.
struct Seen {
    double along;   // the axis
    double radius;  // from it
    Vec3 out;       // away from it, of that length
    Vec3 axis;      // unit
    Vec3 from;      // the origin
};

Seen seenFrom(const Placement& placement, const Vec3& point)
{
    const Vec3 axis = glm::normalize(placement.axis);
    const Vec3 from = point - placement.origin;
    const Vec3 out = from - glm::dot(from, axis) * axis;
    return {glm::dot(from, axis), glm::length(out), out, axis, from};
}

// How far off a point is, and the way outwards there.
struct Judged {
    double error;
    Vec3 outwards;
};

using Judge = std::function<Judged(const Seen&)>;

// At many places: the error at most 1e-13 of `size`, the normal outwards.
void expectShape(std::mt19937& random, const Result<NurbsSurface>& surface, const Placement& placement,
                 double size, const Judge& judge)
{
    ASSERT_TRUE(surface) << surface.error().sentence();
    for (int k = 0; k < 200; ++k) {
        const double u = randomIn(random, surface->knotsU());
        const double v = randomIn(random, surface->knotsV());
        const Judged judged = judge(seenFrom(placement, evaluate(*surface, u, v).position));
        EXPECT_LE(std::abs(judged.error), 1e-13 * size) << u << ' ' << v;
        EXPECT_GT(glm::dot(evaluateNormal(*surface, u, v).direction, glm::normalize(judged.outwards)),
                  1 - 1e-9)
            << u << ' ' << v;
    }
}

double anySize(std::mt19937& random)
{
    return std::pow(10, randomBetween(random, -3, 3));
}

constexpr int kRounds = 40;

}  // namespace

TEST(Shapes, PlanesLieAcrossTheirAxisAndUAlongTheDirection)
{
    std::mt19937 random(81);
    for (int round = 0; round < kRounds; ++round) {
        const double a = anySize(random);
        const double b = anySize(random);
        const double size = std::hypot(a, b);
        const Placement placement = randomPlacement(random, size);
        const auto surface = planeShape(placement, a, b);
        expectShape(random, surface, placement, size, [&](const Seen& seen) {
            return Judged{seen.along, seen.axis};
        });
        const SurfacePoint middle = evaluate(*surface, 0.5, 0.5);
        EXPECT_LE(glm::distance(middle.position, placement.origin), 1e-13 * size);
        EXPECT_NEAR(glm::length(middle.du), a, 1e-13 * size);
        EXPECT_NEAR(glm::length(middle.dv), b, 1e-13 * size);
        const Vec3 across = glm::cross(glm::normalize(placement.axis), glm::normalize(placement.direction));
        EXPECT_LE(std::abs(glm::dot(middle.du, across)), 1e-13 * size * glm::length(across));
        EXPECT_GT(glm::dot(middle.du, placement.direction), 0);
    }
}

TEST(Shapes, CylindersKeepTheirDistanceFromTheAxis)
{
    std::mt19937 random(82);
    for (int round = 0; round < kRounds; ++round) {
        const double radius = anySize(random);
        const double height = anySize(random);
        const double size = radius + height;
        const Placement placement = randomPlacement(random, size);
        const auto surface = cylinderShape(placement, radius, height);
        expectShape(random, surface, placement, size, [&](const Seen& seen) {
            return Judged{seen.radius - radius, seen.out};
        });
        EXPECT_TRUE(surface->isClosedU());
        for (const double u : {0.0, 2.5, 8.0}) {
            EXPECT_NEAR(seenFrom(placement, evaluate(*surface, u, 0).position).along, 0, 1e-13 * size);
            EXPECT_NEAR(seenFrom(placement, evaluate(*surface, u, 1).position).along, height, 1e-13 * size);
        }
    }
}

TEST(Shapes, ConesHaveTheRadiusOfTheirHeight)
{
    std::mt19937 random(83);
    for (int round = 0; round < kRounds; ++round) {
        const double below = round % 4 == 1 ? 0 : anySize(random);
        const double above = round % 4 == 2 ? 0 : anySize(random);
        const double height = below + above;  // so that angles are not too flat to judge a normal
        const double size = below + above + height;
        const Placement placement = randomPlacement(random, size);
        expectShape(random, coneShape(placement, below, above, height), placement, size,
                    [&](const Seen& seen) {
                        const double radius = below + (above - below) * seen.along / height;
                        return Judged{seen.radius - radius,
                                      seen.out / seen.radius * height + seen.axis * (below - above)};
                    });
    }
}

TEST(Shapes, AConesPoleIsOnePointToTheBit)
{
    std::mt19937 random(84);
    const auto cone = coneShape(randomPlacement(random, 5), 2, 0, 3);
    const NurbsCurve pole = isoCurve(*cone, Direction::V, 1).value();
    for (const ControlPoint& point : pole.controlPoints())
        EXPECT_EQ(point.position, pole.controlPoints().front().position);
}

TEST(Shapes, FlatConesAreDiscsAndRings)
{
    std::mt19937 random(85);
    const Placement placement = randomPlacement(random, 2);
    const auto flat = [](const Seen& seen) { return Judged{seen.along, seen.axis}; };
    expectShape(random, coneShape(placement, 2, 0, 0), placement, 2, flat);
    expectShape(random, coneShape(placement, 2, 1, 0), placement, 2, flat);
    expectShape(random, coneShape(placement, 0, 2, 0), placement, 2, [](const Seen& seen) {
        return Judged{seen.along, -seen.axis};
    });
}

TEST(Shapes, SpheresKeepTheirDistanceFromTheCentre)
{
    std::mt19937 random(86);
    for (int round = 0; round < kRounds; ++round) {
        const double radius = anySize(random);
        const Placement placement = randomPlacement(random, radius);
        expectShape(random, sphereShape(placement, radius), placement, radius, [&](const Seen& seen) {
            return Judged{glm::length(seen.from) - radius, seen.from};
        });
    }
}

TEST(Shapes, ToriKeepTheirDistanceFromTheRing)
{
    std::mt19937 random(87);
    for (int round = 0; round < kRounds; ++round) {
        const double major = anySize(random);
        const double minor = major * randomBetween(random, 0.01, 0.99);
        const Placement placement = randomPlacement(random, major);
        expectShape(random, torusShape(placement, major, minor), placement, major, [&](const Seen& seen) {
            const Vec3 fromRing = seen.from - seen.out / seen.radius * major;
            return Judged{glm::length(fromRing) - minor, fromRing};
        });
    }
}

TEST(Shapes, StandAtTheirOwnOriginWithoutAnyRounding)
{
    const auto surface = cylinderShape({}, 2, 5);
    EXPECT_EQ(evaluate(*surface, 0, 0).position, Vec3(2, 0, 0));
    EXPECT_EQ(evaluate(*surface, 2, 1).position, Vec3(0, 2, 5));
    EXPECT_EQ(planeShape({}, 2, 4)->controlPoint(0, 0).position, Vec3(-1, -2, 0));
}

TEST(Shapes, RefuseSizesThatAreNone)
{
    const Placement here;
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double size : {0.0, -1.0, std::nan(""), infinite, 1e300, 1e-300}) {
        EXPECT_FALSE(planeShape(here, 1, size));
        EXPECT_FALSE(cylinderShape(here, size, 1));
        EXPECT_FALSE(cylinderShape(here, 1, size));
        EXPECT_FALSE(sphereShape(here, size));
        EXPECT_FALSE(torusShape(here, size, 1));
        EXPECT_FALSE(torusShape(here, 1, size));
    }
    for (const double size : {-1.0, std::nan(""), infinite, 1e300}) {
        EXPECT_FALSE(coneShape(here, size, 1, 1));
        EXPECT_FALSE(coneShape(here, 1, size, 1));
        EXPECT_FALSE(coneShape(here, 1, 2, size));
    }
    EXPECT_FALSE(coneShape(here, 0, 0, 1));
    EXPECT_FALSE(coneShape(here, 1, 1, 0));
    EXPECT_FALSE(torusShape(here, 1, 1));
    EXPECT_EQ(sphereShape(here, -2).error().sentence(),
              "The radius is not above zero. Give a number above zero.");
}

TEST(Shapes, RefusePlacesThatAreNone)
{
    const double nan = std::nan("");
    EXPECT_FALSE(sphereShape({{0, nan, 0}}, 1));
    EXPECT_FALSE(sphereShape({Vec3(0), Vec3(0)}, 1));
    EXPECT_FALSE(sphereShape({Vec3(0), {0, 0, nan}}, 1));
    EXPECT_FALSE(sphereShape({Vec3(0), {0, 0, 1}, Vec3(0)}, 1));
    EXPECT_FALSE(sphereShape({{1e20, 0, 0}}, 1));
    EXPECT_EQ(sphereShape({Vec3(0), {0, 0, 1}, {0, 0, -3}}, 1).error().sentence(),
              "The direction runs along the axis. Give a direction across the axis.");
}

}  // namespace knotspan::testing
