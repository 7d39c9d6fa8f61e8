#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/ksquad.h"
#include "model/samples/sample_list.h"

namespace knotspan {
namespace {

TEST(Samples, AreListedOnceEachWithADescription)
{
    std::map<std::string, int> names;
    for (const Sample& sample : samples()) {
        EXPECT_EQ(++names[sample.name], 1);
        EXPECT_FALSE(sample.description.empty());
        EXPECT_EQ(findSample(sample.name), &sample);
    }
    EXPECT_EQ(findSample("no such sample"), nullptr);
}

TEST(Samples, HaveTheCountsThatTheirDescriptionsPromise)
{
    struct Counts {
        size_t objects, ksQuads, controlPoints;
    };
    const std::map<std::string, Counts> expected{
        {"single-100", {1, 49, 100}}, {"nine-16", {9, 9, 144}}, {"sphere", {1, 32, 153}},
        {"torus", {1, 64, 289}},      {"hull", {6, 180, 432}},  {"knot", {600, 15000, 38400}},
        {"extremes", {3, 179, 544}},
    };
    ASSERT_EQ(samples().size(), expected.size());
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        EXPECT_EQ(scene.objects().size(), expected.at(sample.name).objects) << sample.name;
        EXPECT_EQ(scene.ksQuadCount(), expected.at(sample.name).ksQuads) << sample.name;
        EXPECT_EQ(scene.controlPointCount(), expected.at(sample.name).controlPoints) << sample.name;
    }
}

TEST(Samples, AreTheSameEachTime)
{
    for (const Sample& sample : samples())
        EXPECT_TRUE(sample.make() == sample.make()) << sample.name;
}

const double kGauss[] = {0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)};

// The volume, by the divergence theorem seen from the middle; positive where normals point outwards.
double signedVolume(const Scene& scene)
{
    double volume = 0;
    const Vec3 middle = scene.bounds().centre();
    for (const auto& [id, object] : scene.objects()) {
        const KnotVector& u = object->surface.knotsU();
        const KnotVector& v = object->surface.knotsV();
        for (const KsQuad& quad : ksQuads(object->surface))
            for (const double s : kGauss)
                for (const double t : kGauss) {
                    const double du = u[quad.spanU + 1] - u[quad.spanU];
                    const double dv = v[quad.spanV + 1] - v[quad.spanV];
                    const SurfacePoint at =
                        evaluate(object->surface, u[quad.spanU] + s * du, v[quad.spanV] + t * dv);
                    volume += glm::dot(at.position - middle, glm::cross(at.du, at.dv)) * du * dv / 4;
                }
    }
    return volume / 3;
}

TEST(Samples, ThatAreClosedPointOutwards)
{
    const double pi = std::acos(-1.0);
    EXPECT_NEAR(signedVolume(findSample("sphere")->make()), 4 * pi / 3, 0.01);
    EXPECT_NEAR(signedVolume(findSample("torus")->make()), 2 * pi * pi * 2 * 0.75 * 0.75, 0.1);
    EXPECT_GT(signedVolume(findSample("knot")->make()), 10);
}

TEST(Samples, HaveANormalEverywhere)
{
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        for (const auto& [id, object] : scene.objects()) {
            const KnotVector& u = object->surface.knotsU();
            const KnotVector& v = object->surface.knotsV();
            for (const double s : {0.0, 0.37, 1.0})
                for (const double t : {0.0, 0.58, 1.0})
                    EXPECT_TRUE(evaluateNormal(object->surface,
                                               u.domainStart() + s * (u.domainEnd() - u.domainStart()),
                                               v.domainStart() + t * (v.domainEnd() - v.domainStart()))
                                    .exists)
                        << sample.name << " " << object->name;
        }
    }
}

// The 17 x 17 points of a KSQuad; those with even indices are its grid of 9 x 9.
std::vector<Vec3> doubledGrid(const NurbsSurface& surface, const KsQuad& quad)
{
    const KnotVector& u = surface.knotsU();
    const KnotVector& v = surface.knotsV();
    std::vector<Vec3> points;
    for (int i = 0; i <= 16; ++i)
        for (int j = 0; j <= 16; ++j)
            points.push_back(evaluate(surface, u[quad.spanU] + i / 16.0 * (u[quad.spanU + 1] - u[quad.spanU]),
                                      v[quad.spanV] + j / 16.0 * (v[quad.spanV + 1] - v[quad.spanV]))
                                 .position);
    return points;
}

// How far the middles of a 9 x 9 grid's cells lie from their triangles' common edge, across the cell.
double flatteningError(const NurbsSurface& surface, const KsQuad& quad)
{
    const std::vector<Vec3> points = doubledGrid(surface, quad);
    const auto at = [&](int i, int j) { return points[static_cast<size_t>(17 * i + j)]; };
    double error = 0;
    for (int i = 0; i < 16; i += 2)
        for (int j = 0; j < 16; j += 2) {
            const Vec3 normal = glm::cross(at(i + 2, j + 2) - at(i, j), at(i, j + 2) - at(i + 2, j));
            if (const double area = glm::length(normal); area > 0) {
                const Vec3 middle = (at(i, j) + at(i + 2, j + 2)) * 0.5;
                error = std::max(error, std::abs(glm::dot(at(i + 1, j + 1) - middle, normal)) / area);
            }
        }
    return error;
}

// In pixels of a picture 480 pixels high; of large samples every 40th object.
double flatteningError(const Scene& scene)
{
    const std::uint32_t step = scene.objects().size() > 100 ? 40 : 1;
    double error = 0;
    for (const auto& [id, object] : scene.objects())
        if (static_cast<std::uint32_t>(id) % step == 0) {
            for (const KsQuad& quad : ksQuads(object->surface))
                error = std::max(error, flatteningError(object->surface, quad));
        }
    return error * 480 / scene.bounds().diagonal();
}

TEST(Samples, LookSmoothWithNineByNinePointsAKsQuad)
{
    for (const Sample& sample : samples())
        if (sample.name != "single-100" && sample.name != "nine-16") {
            const double error = flatteningError(sample.make());
            RecordProperty(sample.name, std::to_string(error));
            EXPECT_LE(error, 1) << sample.name;
        }
}

TEST(Extremes, IsAsExtremeAsItSays)
{
    const Scene scene = findSample("extremes")->make();
    const NurbsSurface& surface = scene.find(ObjectId{0})->surface;
    EXPECT_EQ(surface.degreeU(), 9);
    EXPECT_EQ(surface.degreeV(), 9);
    const KnotVector& knots = surface.knotsU();
    const auto length = [&](int span) { return knots[span + 1] - knots[span]; };
    EXPECT_GE(length(knots.spans().back()) / length(knots.spans().front()), 1e6);
    double least = 1;
    double most = 1;
    for (const ControlPoint& point : surface.controlPoints()) {
        least = std::min(least, point.weight);
        most = std::max(most, point.weight);
    }
    EXPECT_GE(most / least, 1e8);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(scene.bounds().centre()[axis], 1e6, 100);
}

}  // namespace
}  // namespace knotspan
