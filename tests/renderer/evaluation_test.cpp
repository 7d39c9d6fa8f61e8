// What the stages compute against the double reference: a unit is 2^-24 of the local size, the largest
// coordinate of the KSQuad's control points relative to the surface's origin.
#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/ksquad.h"
#include "model/geometry/primitives.h"
#include "model/samples/sample_list.h"
#include "tests/model/geometry/precise_evaluation.h"
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

std::vector<CapturedVertex> asVertices(const std::vector<EvaluationPoint>& points,
                                       const Evaluations& evaluated)
{
    std::vector<CapturedVertex> vertices;
    for (size_t k = 0; k < points.size(); ++k)
        vertices.push_back({points[k].object, points[k].spanU, points[k].spanV, points[k].u, points[k].v,
                            evaluated.points[k].position, evaluated.points[k].normal});
    return vertices;
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

// Parameters that are floats, so that the device and the reference see the same.
std::vector<EvaluationPoint> pointsOn(const Scene& scene, int perKsquad)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    const auto& [id, object] = *scene.objects().begin();
    std::vector<EvaluationPoint> points;
    for (const KsQuad& ksquad : ksQuads(object->surface))
        for (int k = 0; k < perKsquad; ++k)
            points.push_back({id, ksquad.spanU, ksquad.spanV, unit(random), unit(random)});
    return points;
}

// What holds for the powers of t, which `auto` does not choose: they lose digits by the degree and by the
// weights, here of 0.2 to 5.
double mostUnits(Evaluator evaluator, int degree)
{
    return evaluator == Evaluator::power ? std::max(kMostUnits, 2.0 * std::pow(3.0, degree)) : kMostUnits;
}

TEST_P(Evaluation, OfTheComputeStageIsWithinTheBoundOfEachEvaluator)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    std::map<Evaluator, Worst> worst;
    for (const Scene& scene : scenesOfDegree(GetParam())) {
        ASSERT_TRUE(renderer->sync(scene));
        const auto points = pointsOn(scene, 16);
        for (const EvaluatorInfo& info : evaluators()) {
            const auto evaluated = renderer->evaluate(points, {info.id});
            ASSERT_TRUE(evaluated) << evaluated.error().sentence();
            ASSERT_EQ(evaluated->points.size(), points.size());
            look(worst[info.id], *renderer, scene, asVertices(points, *evaluated));
        }
    }
    // Where the degrees of u and v differ, the larger one chooses and errs most.
    const int degree = std::max(GetParam(), 1 + (GetParam() + 3) % 9);
    for (const EvaluatorInfo& info : evaluators()) {
        const Worst& found = worst[info.id];
        EXPECT_GT(found.points, 100U);
        EXPECT_LE(found.units, mostUnits(info.id, degree)) << info.name << ", degree " << GetParam();
        RecordProperty("units_" + info.name, std::to_string(found.units));
        if (info.id != Evaluator::power) {
            EXPECT_LE(found.normal, 1e-3) << info.name << ", degree " << GetParam();
        }
    }
}

// Against 50 digits: positions in units of 2^-53 of the local size, derivatives as a share of the largest
// that a net of that size and degree can have. Two evaluators, because the software driver compiles each for
// seconds.
TEST_P(Evaluation, InDoubleOfTheComputeStageIsWithinTheBoundOfTheEvaluator)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    if (const std::string reason = renderer->whyUnavailable(Precision::float64); !reason.empty())
        GTEST_SKIP() << reason;
    constexpr double kDoubleUnit = kUnit * kUnit / 32.0;
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    const NurbsSurface surface = randomSurface(random, {GetParam(), GetParam(), 2, true, 100.0, 1e4});
    const Scene scene = sceneOf(surface);
    ASSERT_TRUE(renderer->sync(scene));
    const auto points = pointsOn(scene, 8);
    const Vec3 origin = renderer->surfaceOrigin(points.front().object);
    for (const Evaluator wish : {Evaluator::automatic, Evaluator::power}) {
        const std::string& name = evaluatorInfo(wish).name;
        const auto evaluated = renderer->evaluate(points, {wish, Precision::float64});
        ASSERT_TRUE(evaluated) << evaluated.error().sentence();
        double units = 0;
        double slope = 0;
        for (size_t k = 0; k < points.size(); ++k) {
            const EvaluationPoint& point = points[k];
            const auto expected = preciseEvaluation(
                surface, point.spanU, parameterOnSpan(surface.knotsU(), point.spanU, point.u), point.spanV,
                parameterOnSpan(surface.knotsV(), point.spanV, point.v));
            const Real length = Real(surface.knotsU()[point.spanU + 1]) - surface.knotsU()[point.spanU];
            const double size = localSize(surface, origin, point.spanU, point.spanV);
            for (int c = 0; c < 3; ++c) {
                const auto at = static_cast<size_t>(c);
                const Real off = expected.position[at] - origin[c] - evaluated->points[k].position[c];
                const Real slopeOff = expected.du[at] * length - evaluated->points[k].du[c];
                units = std::max(units, std::abs(static_cast<double>(off)) / (kDoubleUnit * size));
                slope = std::max(slope, std::abs(static_cast<double>(slopeOff)) / (size * GetParam()));
            }
            EXPECT_NEAR(glm::length(evaluated->points[k].normal), 1.0, 1e-14);
        }
        EXPECT_GT(units, 0);
        EXPECT_LE(units, mostUnits(wish, GetParam())) << name << ", degree " << GetParam();
        if (wish != Evaluator::power) {
            EXPECT_LE(slope, 1e-13) << name << ", degree " << GetParam();
        }
        RecordProperty("double_units_" + name, std::to_string(units));
    }
}

TEST(EvaluationByItself, KeepsTheOrderOfAnyNumberOfPointsAndTellsEvaluatorAndTime)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = sceneOf(plane({}, {1, 0, 0}, {0, 2, 0}));
    ASSERT_TRUE(renderer->sync(scene));
    const auto& [id, object] = *scene.objects().begin();
    std::vector<EvaluationPoint> points;
    constexpr int kPoints = 300000;
    for (int k = 0; k < kPoints; ++k)
        points.push_back({id, 1, 1, static_cast<double>(k) / kPoints, 0.5});
    const auto evaluated = renderer->evaluate(points, {Evaluator::automatic, Precision::float32, 3});
    ASSERT_TRUE(evaluated) << evaluated.error().sentence();
    EXPECT_EQ(evaluated->evaluator, chosenEvaluator(Evaluator::automatic, 1, Precision::float32));
    EXPECT_GE(evaluated->gpuMs, 0);
    ASSERT_EQ(evaluated->points.size(), points.size());
    const Vec3 origin = renderer->surfaceOrigin(id);
    for (size_t k = 0; k < points.size(); ++k) {
        const EvaluatedPoint& at = evaluated->points[k];
        ASSERT_NEAR(at.position.x + origin.x, points[k].u, 1e-6) << k;
        ASSERT_NEAR(at.du.x, 1, 1e-6) << k;
        ASSERT_NEAR(at.dv.y, 2, 1e-6) << k;
        ASSERT_NEAR(at.normal.z, 1, 1e-6) << k;
    }
    const auto none = renderer->evaluate({{id, 2, 1, 0, 0}});
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().sentence().find("no such KSQuad"), std::string::npos) << none.error().sentence();
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
