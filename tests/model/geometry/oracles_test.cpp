// Surfaces evaluated by other programs and in exact arithmetic; skipped where their files are absent.
#include <algorithm>
#include <fstream>
#include <optional>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/grid_evaluation.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using nlohmann::json;

std::optional<json> oracle(const char* name)
{
    const auto folder = testing::oraclesFolder();
    if (!folder)
        return std::nullopt;
    return json::parse(std::ifstream(*folder / name));
}

// Nothing for a surface that create() refuses.
std::optional<NurbsSurface> surfaceOf(const json& value)
{
    auto knotsU = KnotVector::create(value["degree_u"], value["knots_u"]);
    auto knotsV = KnotVector::create(value["degree_v"], value["knots_v"]);
    if (!knotsU || !knotsV)
        return std::nullopt;
    std::vector<ControlPoint> points;
    for (const json& point : value["cps"])
        points.push_back({{point[0], point[1], point[2]}, point[3]});
    auto surface = NurbsSurface::create(*knotsU, *knotsV, points);
    return surface ? std::optional(*std::move(surface)) : std::nullopt;
}

double number(const json& value)
{
    return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

Vec3 vector(const json& value)
{
    return {number(value[0]), number(value[1]), number(value[2])};
}

double largest(const Vec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

TEST(Oracles, OfOtherProgramsAgree)
{
    const auto file = oracle("oracles.json");
    if (!file)
        GTEST_SKIP() << "no oracles here";
    int checked = 0;
    for (const json& value : (*file)["cases"]) {
        SCOPED_TRACE(value["name"].get<std::string>());
        const auto surface = surfaceOf(value);
        ASSERT_TRUE(surface);
        const double tolerance = value["tol"];
        const double size = std::max(
            1.0, largest(glm::max(glm::abs(surface->bounds().low), glm::abs(surface->bounds().high))));
        for (const json& point : value["evals"]) {
            const SurfacePoint found = evaluate(*surface, point["u"], point["v"]);
            EXPECT_LE(largest(found.position - vector(point["point"])), tolerance * size);
            for (const char* key : {"du", "dv"})
                if (point.contains(key)) {
                    const Vec3 exact = vector(point[key]);
                    EXPECT_LE(largest((key[1] == 'u' ? found.du : found.dv) - exact),
                              tolerance * std::max(size, largest(exact)));
                }
            ++checked;
        }
    }
    EXPECT_GE(checked, 300);
}

// What the derivative is summed from: below its rounding nothing can be asked.
double derivativeScale(const NurbsSurface& surface, const KnotVector& knots, double u)
{
    const int span = knots.findSpan(u);
    return surface.bounds().diagonal() * knots.degree() / (knots[span + 1] - knots[span]);
}

// The nearer to parallel two tangents are, the fewer digits of their directions remain in the normal.
double normalTolerance(const Vec3& du, const Vec3& dv)
{
    return std::max(1e-9, 1e-15 * glm::length(du) * glm::length(dv) / glm::length(glm::cross(du, dv)));
}

// By one of the evaluators.
struct Found {
    Vec3 position, du, dv, normal;
    bool normalExists;
};

Found byReference(const NurbsSurface& surface, double u, double v)
{
    const SurfacePoint point = evaluate(surface, u, v);
    const SurfaceNormal normal = evaluateNormal(surface, u, v);
    return {point.position, point.du, point.dv, normal.direction, normal.exists};
}

Found byGrid(const NurbsSurface& surface, double u, double v)
{
    const GridEvaluator<double> evaluator(surface, {.derivatives = 1, .normals = true});
    GridSamples<double> samples;
    evaluator.evaluate(spanParameters(surface.knotsU(), {&u, 1}), spanParameters(surface.knotsV(), {&v, 1}),
                       samples);
    return {samples.origin() + samples.position(0, 0), samples.du(0, 0), samples.dv(0, 0),
            samples.normal(0, 0), evaluateNormal(surface, u, v).exists};
}

void expectExact(const NurbsSurface& surface, const json& point, const Found& found)
{
    const double u = point["u"];
    const double v = point["v"];
    const double coordinate =
        largest(glm::max(glm::abs(surface.bounds().low), glm::abs(surface.bounds().high)));
    EXPECT_LE(largest(found.position - vector(point["point"])),
              4e-16 * coordinate + 1e-15 * surface.bounds().diagonal());
    EXPECT_LE(largest(found.du - vector(point["du"])),
              1e-13 * std::max(derivativeScale(surface, surface.knotsU(), u), largest(vector(point["du"]))));
    EXPECT_LE(largest(found.dv - vector(point["dv"])),
              1e-13 * std::max(derivativeScale(surface, surface.knotsV(), v), largest(vector(point["dv"]))));
    EXPECT_NEAR(glm::length(found.normal), 1, 1e-12);
    if (!point["normal"].is_null()) {
        EXPECT_LE(largest(found.normal - vector(point["normal"])),
                  normalTolerance(vector(point["du"]), vector(point["dv"])))
            << "normal";
    } else if (point.contains("normal_limit_towards_centre") &&
               !point["normal_limit_towards_centre"].is_null()) {
        EXPECT_TRUE(found.normalExists);
        EXPECT_LE(largest(found.normal - vector(point["normal_limit_towards_centre"])), 1e-6) << "limit";
    } else {
        EXPECT_FALSE(found.normalExists);
    }
}

TEST(Oracles, OfExactArithmeticAgreeOnExtremeSurfaces)
{
    const auto file = oracle("extreme_oracles.json");
    if (!file)
        GTEST_SKIP() << "no oracles here";
    int checked = 0;
    for (const json& value : (*file)["cases"]) {
        SCOPED_TRACE(value["name"].get<std::string>());
        const auto surface = surfaceOf(value);
        if (!surface) {
            EXPECT_EQ(value["name"], "c-1_break");
            continue;
        }
        for (const json& point : value["evals"]) {
            const double u = point["u"];
            const double v = point["v"];
            SCOPED_TRACE(std::to_string(u) + ", " + std::to_string(v));
            expectExact(*surface, point, byReference(*surface, u, v));
            SCOPED_TRACE("by the grid");
            expectExact(*surface, point, byGrid(*surface, u, v));
            ++checked;
        }
    }
    EXPECT_GE(checked, 400);
}

}  // namespace
}  // namespace knotspan
