// What the device makes of the extreme surfaces, in the compute stage: positions within sixteen units of
// 2^-24 of the local size in float and of 2^-53 in double, and nothing that is no number.
#include <cmath>

#include <glm/geometric.hpp>

#include "tests/model/extremes/exact_points.h"
#include "tests/model/extremes/figures.h"
#include "tests/random_surface.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

// Which surfaces a number type can hold: their size, and what is left of a control point of the least weight.
struct Held {
    Precision precision;
    double unit;
    double smallest;
    double largest;
};
constexpr Held kFloat{Precision::float32, 0x1p-24, 1e-25, 1e25};
constexpr Held kDouble{Precision::float64, 0x1p-53, 1e-280, 1e280};

bool isFinite(const Vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::vector<EvaluationPoint> requests(ObjectId object, const std::vector<ExactKSQuad>& ksquads)
{
    std::vector<EvaluationPoint> points;
    for (const ExactKSQuad& ksquad : ksquads)
        for (const ExactPoint& at : ksquad.points)
            points.push_back({object, at.ksquad.u, at.ksquad.v, at.tu, at.tv});
    return points;
}

// The worst position of a row, in units.
void compare(const Evaluations& found, const std::vector<ExactKSQuad>& ksquads, const Vec3& origin,
             const Held& held, FigureTable& table)
{
    size_t k = 0;
    for (const ExactKSQuad& ksquad : ksquads)
        for (const ExactPoint& at : ksquad.points) {
            const EvaluatedPoint& point = found.points[k++];
            EXPECT_TRUE(isFinite(point.position) && isFinite(point.du) && isFinite(point.dv));
            EXPECT_NEAR(glm::length(point.normal), 1, 1e-5);
            RealVec3 position = at.value.position;
            for (int c = 0; c < 3; ++c)
                position[static_cast<size_t>(c)] -= Real(origin[c]);
            if (ksquad.size > held.smallest && ksquad.size < held.largest)
                table.add(0, relativeError(point.position, position, ksquad.size) / held.unit);
        }
}

void expectHeld(const Held& held)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    if (const std::string reason = renderer->whyUnavailable(held.precision); !reason.empty())
        GTEST_SKIP() << reason;
    FigureTable table({"position"});
    for (const ExtremeSurface& row : extremeSurfaces()) {
        SCOPED_TRACE(row.name);
        const Scene scene = sceneOf(row.surface);
        ASSERT_TRUE(renderer->sync(scene));
        const ObjectId object = scene.objects().begin()->first;
        const auto& ksquads = exactKSQuads(row, Exactly::t);
        const auto found =
            renderer->evaluate(requests(object, ksquads), {Evaluator::automatic, held.precision});
        ASSERT_TRUE(found) << found.error().sentence();
        table.beginRow(row.name);
        compare(*found, ksquads, renderer->surfaceOrigin(object), held, table);
        if (!row.onlyFinite) {
            EXPECT_LE(table.worst(0), 16);
        }
    }
    table.report();
}

TEST(DeviceAtTheExtremes, IsWithinSixteenUnitsInFloat)
{
    expectHeld(kFloat);
}

TEST(DeviceAtTheExtremes, IsWithinSixteenUnitsInDouble)
{
    expectHeld(kDouble);
}

}  // namespace
}  // namespace knotspan::testing
