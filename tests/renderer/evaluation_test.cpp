// What the stages compute against the double reference: a unit is 2^-24 of the local size, the largest
// coordinate of the KSQuad's control points relative to the surface's origin.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/ksquad.h"
#include "model/samples/sample_list.h"
#include "tests/random_surface.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr double kUnit = 1.0 / 16777216.0;
constexpr double kMostUnits = 16.0;

double localSize(const NurbsSurface& surface, const Vec3& origin, int spanU, int spanV)
{
    double size = 0;
    for (int i = spanU - surface.degreeU(); i <= spanU; ++i)
        for (int j = spanV - surface.degreeV(); j <= spanV; ++j) {
            const Vec3 offset = surface.controlPoint(i, j).position - origin;
            size = std::max({size, std::abs(offset.x), std::abs(offset.y), std::abs(offset.z)});
        }
    return size;
}

struct Worst {
    double units = 0;   // largest error of a position
    double normal = 0;  // largest difference of a normal
    size_t points = 0;
};

void look(Worst& worst, const Renderer& renderer, const Scene& scene,
          const std::vector<CapturedVertex>& vertices)
{
    for (const CapturedVertex& vertex : vertices) {
        const NurbsSurface& surface = scene.find(vertex.object)->surface;
        const Vec3 origin = renderer.surfaceOrigin(vertex.object);
        const auto along = [](const KnotVector& knots, int span, double t) {
            return knots[span] + t * (knots[span + 1] - knots[span]);
        };
        const double u = along(surface.knotsU(), vertex.spanU, vertex.u);
        const double v = along(surface.knotsV(), vertex.spanV, vertex.v);
        const Vec3 error = evaluate(surface, u, v).position - origin - vertex.position;
        const double size = localSize(surface, origin, vertex.spanU, vertex.spanV);
        worst.units = std::max(worst.units, glm::length(error) / (kUnit * size));
        ++worst.points;
        // At a knot the reference looks at the span on the right, a stage at its own: in a crease they
        // differ.
        if (vertex.u == 0 || vertex.u == 1 || vertex.v == 0 || vertex.v == 1)
            continue;
        worst.normal =
            std::max(worst.normal, glm::length(evaluateNormal(surface, u, v).direction - vertex.normal));
    }
}

// One surface of every kind for a degree; the origin of `offset` must not be felt.
std::vector<Scene> scenesOfDegree(int degree)
{
    std::mt19937 random(static_cast<unsigned>(degree));
    std::vector<Scene> scenes;
    for (const bool rational : {false, true})
        for (const double offset : {0.0, 1e6}) {
            const int other = 1 + (degree + 3) % 9;
            scenes.push_back(sceneOf(randomSurface(random, {degree, degree, 3, rational, offset, 100.0})));
            scenes.push_back(sceneOf(randomSurface(random, {degree, other, 2, rational, offset, 1e4})));
        }
    return scenes;
}

class Evaluation : public ::testing::TestWithParam<int> {};

void expectAccurate(const Worst& worst, const char* stage, int degree)
{
    EXPECT_GT(worst.points, 100U);
    EXPECT_LE(worst.units, kMostUnits) << stage << ", degree " << degree;
    EXPECT_LE(worst.normal, 1e-3) << stage << ", degree " << degree;
    ::testing::Test::RecordProperty("units", std::to_string(worst.units));
}

TEST_P(Evaluation, OfTheMeshStageIsWithinSixteenUnitsOfTheReference)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh9x9);
    Worst worst;
    for (const Scene& scene : scenesOfDegree(GetParam())) {
        ASSERT_TRUE(renderer->sync(scene));
        const auto vertices = renderer->captureVertices(frameOf(scene, PathId::mesh9x9, 64, 48));
        ASSERT_TRUE(vertices) << vertices.error().sentence();
        EXPECT_EQ(vertices->size(), scene.ksQuadCount() * 81);
        look(worst, *renderer, scene, *vertices);
    }
    expectAccurate(worst, "mesh", GetParam());
}

TEST_P(Evaluation, OfTheEvaluationStageIsWithinSixteenUnitsOfTheReference)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    Worst worst;
    for (const Scene& scene : scenesOfDegree(GetParam())) {
        ASSERT_TRUE(renderer->sync(scene));
        Frame frame = frameOf(scene, PathId::tessellation, 64, 48);
        frame.sampling = {SamplingRule::Kind::fixed, 5};
        const auto vertices = renderer->captureVertices(frame);
        ASSERT_TRUE(vertices) << vertices.error().sentence();
        look(worst, *renderer, scene, *vertices);
    }
    expectAccurate(worst, "evaluation", GetParam());
}

TEST_P(Evaluation, OfTheComputeStageIsWithinSixteenUnitsOfTheReference)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    std::mt19937 random(7);
    // Floats, so that the device and the reference see the same parameter.
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    Worst worst;
    for (const Scene& scene : scenesOfDegree(GetParam())) {
        ASSERT_TRUE(renderer->sync(scene));
        const auto& [id, object] = *scene.objects().begin();
        std::vector<EvaluationPoint> points;
        for (const KsQuad& ksquad : ksQuads(object->surface))
            for (int k = 0; k < 40; ++k)
                points.push_back({id, ksquad.spanU, ksquad.spanV, unit(random), unit(random)});
        const auto vertices = renderer->evaluate(points);
        ASSERT_TRUE(vertices) << vertices.error().sentence();
        ASSERT_EQ(vertices->size(), points.size());
        look(worst, *renderer, scene, *vertices);
    }
    expectAccurate(worst, "compute", GetParam());
}

// Rounding must not choose the normal where a tangent vanishes, at no size of the body and nowhere in space.
TEST(PoleNormals, AreThoseOfTheSphereAtEverySizeAndPlace)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const SharedObject unitSphere = findSample("sphere")->make().objects().begin()->second;
    for (const double size : {1e-9, 1.0, 1e12})
        for (const Vec3& centre : {Vec3(0.0), Vec3(1e5, -2e5, 3e5)}) {
            std::vector<ControlPoint> points = unitSphere->surface.controlPoints();
            for (ControlPoint& point : points)
                point.position = (point.position + centre) * size;
            const Scene scene = sceneOf(
                NurbsSurface::create(unitSphere->surface.knotsU(), unitSphere->surface.knotsV(), points)
                    .value());
            ASSERT_TRUE(renderer->sync(scene));
            const auto vertices = renderer->captureVertices(frameOf(scene, renderer->bestPath(), 64, 48));
            ASSERT_TRUE(vertices);
            size_t poles = 0;
            for (const CapturedVertex& vertex : *vertices) {
                const Vec3 origin = renderer->surfaceOrigin(vertex.object);
                const Vec3 outward = (vertex.position + origin) / size - centre;
                const bool pole = std::abs(outward.z) > 0.999999;
                poles += pole ? 1 : 0;
                EXPECT_LT(glm::length(outward - vertex.normal), pole ? 2e-3 : 1e-5)
                    << size << ", pole " << pole;
            }
            EXPECT_GT(poles, 10U);
        }
}

INSTANTIATE_TEST_SUITE_P(Degree, Evaluation, ::testing::Range(1, 10));

}  // namespace
}  // namespace knotspan::testing
