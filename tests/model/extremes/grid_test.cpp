// The fast evaluation at the extremes: double and float, every shape of request, every instruction set.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/grid_evaluation.h"
#include "model/geometry/simd_targets.h"
#include "tests/model/extremes/exact_points.h"
#include "tests/model/extremes/figures.h"

namespace knotspan {
namespace {

using testing::ExactKSQuad;
using testing::ExactPoint;
using testing::ExtremeSurface;
using testing::FigureTable;
using testing::relativeError;

enum class Shape { scattered, grid, row, span };
constexpr Shape kShapes[] = {Shape::scattered, Shape::grid, Shape::row, Shape::span};

// What float and double are held to.
template <class Number>
struct Precision;
template <>
struct Precision<double> {
    static constexpr double kUnit = 0x1p-52;
    static constexpr double kUnitLength = 1e-15;
    static constexpr double kTold = 1e11;  // tangents nearer to parallel span no plane
    static constexpr double kSmallest = 1e-300, kLargest = 1e300;
    static const testing::ErrorBounds& of(const ExtremeSurface& row) { return row.fast; }
};
template <>
struct Precision<float> {
    static constexpr double kUnit = 0x1p-24;
    static constexpr double kUnitLength = 1e-6;
    static constexpr double kTold = 1e4;
    static constexpr double kSmallest = 1e-30, kLargest = 1e30;
    static const testing::ErrorBounds& of(const ExtremeSurface& row) { return row.fastFloat; }
};

const std::vector<std::string> kColumns{
    "position", "du", "dv", "duu", "duv", "dvv", "normal, of its sensitivity", "limit, radians"};

std::vector<ExactPoint> allPoints(const std::vector<ExactKSQuad>& ksquads)
{
    std::vector<ExactPoint> result;
    for (const ExactKSQuad& ksquad : ksquads)
        result.insert(result.end(), ksquad.points.begin(), ksquad.points.end());
    return result;
}

// Compares the sample at (row, column) with one exact point.
template <class Number>
void compare(const GridSamples<Number>& samples, int row, int column, const ExactKSQuad& ksquad,
             const ExactPoint& at, FigureTable& table)
{
    using Limits = Precision<Number>;
    const auto told = [](double scale) { return scale > Limits::kSmallest && scale < Limits::kLargest; };
    const auto add = [&](size_t figure, const Vec3& found, const testing::RealVec3& exact, double scale) {
        if (told(scale))
            table.add(figure, relativeError(found, exact, scale));
    };
    testing::RealVec3 position = at.value.position;
    for (int c = 0; c < 3; ++c)
        position[static_cast<size_t>(c)] -= testing::Real(samples.origin()[c]);
    if (told(ksquad.size))
        table.add(0, relativeError(samples.position(row, column), position, ksquad.size) / Limits::kUnit);
    add(1, samples.du(row, column), at.value.du, ksquad.du);
    add(2, samples.dv(row, column), at.value.dv, ksquad.dv);
    add(3, samples.duu(row, column), at.value.duu, ksquad.duu);
    add(4, samples.duv(row, column), at.value.duv, ksquad.duv);
    add(5, samples.dvv(row, column), at.value.dvv, ksquad.dvv);

    const Vec3 normal = samples.normal(row, column);
    EXPECT_NEAR(glm::length(normal), 1, Limits::kUnitLength);
    if (!at.normal || !told(ksquad.size) || !told(ksquad.du) || !told(ksquad.dv))
        return;
    if (at.isLimit)
        table.add(7, testing::angleBetween(normal, *at.normal));
    else if (at.normalSensitivity < Limits::kTold)
        table.add(6, testing::angleBetween(normal, *at.normal) / at.normalSensitivity);
}

template <class Number>
void compareShape(const GridEvaluator<Number>& evaluator, const std::vector<ExactKSQuad>& ksquads,
                  Shape shape, FigureTable& table)
{
    const auto parameters = [](const std::vector<ExactPoint>& points, bool ofU) {
        std::vector<SpanParameter> result;
        for (const ExactPoint& point : points)
            result.push_back(ofU ? SpanParameter{point.ksquad.u, point.tu}
                                 : SpanParameter{point.ksquad.v, point.tv});
        return result;
    };
    const std::vector<ExactPoint> all = allPoints(ksquads);
    const std::vector<SpanParameter> allU = parameters(all, true);
    const std::vector<SpanParameter> allV = parameters(all, false);
    GridSamples<Number> samples;
    if (shape == Shape::scattered)
        evaluator.evaluateScattered(allU, allV, samples);
    if (shape == Shape::grid)
        evaluator.evaluate(allU, allV, samples);
    int k = 0;  // among all points
    for (const ExactKSQuad& ksquad : ksquads) {
        if (shape == Shape::span)
            evaluator.evaluate(parameters(ksquad.points, true), parameters(ksquad.points, false), samples);
        for (size_t inside = 0; inside < ksquad.points.size(); ++inside, ++k) {
            const auto own = static_cast<int>(inside);
            if (shape == Shape::row)
                evaluator.evaluate({&allU[static_cast<size_t>(k)], 1}, allV, samples);
            const int row = shape == Shape::grid ? k : shape == Shape::span ? own : 0;
            const int column = shape == Shape::span ? own : k;
            compare(samples, row, column, ksquad, ksquad.points[inside], table);
        }
    }
}

template <class Number>
void compareRow(const ExtremeSurface& row, std::span<const Shape> shapes, FigureTable& table)
{
    SCOPED_TRACE(row.name);
    const testing::ErrorBounds& bounds = Precision<Number>::of(row);
    table.beginRow(row.name);
    const GridEvaluator<Number> evaluator(row.surface, {.derivatives = 2, .normals = true});
    for (const Shape shape : shapes)
        compareShape(evaluator, testing::exactKSQuads(row, testing::Exactly::t), shape, table);
    if (row.onlyFinite)
        return;
    EXPECT_LE(table.worst(0), bounds.position) << "position";
    for (size_t column = 1; column <= 2; ++column)
        EXPECT_LE(table.worst(column), bounds.derivative) << "first derivative";
    for (size_t column = 3; column <= 5; ++column)
        EXPECT_LE(table.worst(column), bounds.secondDerivative) << "second derivative";
    EXPECT_LE(table.worst(6), bounds.normal) << "normal";
    EXPECT_LE(table.worst(7), bounds.limit) << "limit of normals";
}

template <class Number>
class GridAtTheExtremes : public ::testing::Test {
protected:
    ~GridAtTheExtremes() override { useSimdTarget(""); }
};
struct NumberNames {
    template <class Number>
    static std::string GetName(int)
    {
        return sizeof(Number) == 4 ? "Float" : "Double";
    }
};
using Numbers = ::testing::Types<double, float>;
TYPED_TEST_SUITE(GridAtTheExtremes, Numbers, NumberNames);

TYPED_TEST(GridAtTheExtremes, KeepsItsBoundsInEveryShape)
{
    FigureTable table(kColumns);
    for (const ExtremeSurface& row : testing::extremeSurfaces())
        compareRow<TypeParam>(row, kShapes, table);
    table.report();
}

TYPED_TEST(GridAtTheExtremes, KeepsItsBoundsOnEveryInstructionSet)
{
    for (const std::string& target : simdTargets()) {
        SCOPED_TRACE(target);
        useSimdTarget(target);
        ASSERT_EQ(simdTargetInUse(), target);
        FigureTable table(kColumns);
        size_t index = 0;
        for (const ExtremeSurface& row : testing::extremeSurfaces())
            if (index++ % 3 == 0)
                compareRow<TypeParam>(row, std::span(kShapes).first(2), table);
    }
}

template <class Number>
bool sameBits(const GridSamples<Number>& a, const GridSamples<Number>& b)
{
    using Samples = GridSamples<Number>;
    for (int f = 0; f < Samples::kFieldCount; ++f)
        for (int c = 0; c < 3; ++c)
            for (int row = 0; row < a.rows(); ++row) {
                const auto field = static_cast<typename Samples::Field>(f);
                const Number* inA = a.plane(field, c).data() + static_cast<size_t>(row) * a.stride();
                const Number* inB = b.plane(field, c).data() + static_cast<size_t>(row) * b.stride();
                if (std::memcmp(inA, inB, static_cast<size_t>(a.columns()) * sizeof(Number)) != 0)
                    return false;
            }
    return true;
}

// Up to `most` parameters a direction, on all spans that fit.
std::vector<SpanParameter> dense(const KnotVector& knots, size_t most)
{
    const auto spans = static_cast<int>(knots.spans().size());
    std::vector<SpanParameter> result =
        parametersPerSpan(knots, std::max(1, static_cast<int>(most) / spans - 1));
    result.resize(std::min(result.size(), most));
    return result;
}

TYPED_TEST(GridAtTheExtremes, GivesTheSameBitsOnOneThreadAndOnAll)
{
    const std::set<std::string> names{
        "degree 9 x 7", "weights 1e8, degree 3", "spans 1e6, degree 5", "sphere", "500 x 500", "folded net"};
    size_t checked = 0;
    for (const ExtremeSurface& row : testing::extremeSurfaces()) {
        if (!names.contains(row.name))
            continue;
        ++checked;
        SCOPED_TRACE(row.name);
        const GridEvaluator<TypeParam> evaluator(row.surface, {.derivatives = 2, .normals = true});
        const auto u = dense(row.surface.knotsU(), 97);
        const auto v = dense(row.surface.knotsV(), 190);
        GridSamples<TypeParam> one;
        GridSamples<TypeParam> all;
        evaluator.evaluate(u, v, one, Threads::one);
        evaluator.evaluate(u, v, all, Threads::all);
        EXPECT_TRUE(sameBits(one, all)) << "grid";
        std::vector<SpanParameter> scatteredU;
        std::vector<SpanParameter> scatteredV;
        for (size_t k = 0; k < 5000; ++k) {
            scatteredU.push_back(u[k * 7919 % u.size()]);
            scatteredV.push_back(v[k * 104729 % v.size()]);
        }
        evaluator.evaluateScattered(scatteredU, scatteredV, one, Threads::one);
        evaluator.evaluateScattered(scatteredU, scatteredV, all, Threads::all);
        EXPECT_TRUE(sameBits(one, all)) << "scattered";
    }
    EXPECT_EQ(checked, names.size());
}

TYPED_TEST(GridAtTheExtremes, HasOnlyFiniteNumbersAndUnitNormals)
{
    using Samples = GridSamples<TypeParam>;
    for (const ExtremeSurface& row : testing::extremeSurfaces()) {
        SCOPED_TRACE(row.name);
        const GridEvaluator<TypeParam> evaluator(row.surface, {.derivatives = 2, .normals = true});
        Samples samples;
        evaluator.evaluate(dense(row.surface.knotsU(), 31), dense(row.surface.knotsV(), 37), samples);
        bool finite = true;
        bool unit = true;
        for (int i = 0; i < samples.rows(); ++i)
            for (int j = 0; j < samples.columns(); ++j) {
                for (const auto& vector : {samples.position(i, j), samples.du(i, j), samples.dv(i, j),
                                           samples.duu(i, j), samples.duv(i, j), samples.dvv(i, j)})
                    for (int c = 0; c < 3; ++c)
                        finite = finite && std::isfinite(vector[c]);
                unit = unit && std::abs(glm::length(Vec3(samples.normal(i, j))) - 1) <=
                                   Precision<TypeParam>::kUnitLength;
            }
        EXPECT_TRUE(finite);
        EXPECT_TRUE(unit);
    }
}

TEST(SpanParameters, AreTheParametersToTheLastDigit)
{
    for (const ExtremeSurface& row : testing::extremeSurfaces()) {
        SCOPED_TRACE(row.name);
        const KnotVector& knots = row.surface.knotsU();
        for (const ExactKSQuad& ksquad : testing::exactKSQuads(row, testing::Exactly::t))
            for (const ExactPoint& at : ksquad.points) {
                const double values[] = {at.u};
                const SpanParameter found = spanParameters(knots, values).at(0);
                ASSERT_EQ(found.span, knots.findSpan(at.u));
                const testing::Real start = knots[found.span];
                const testing::Real exact =
                    (testing::Real(at.u) - start) / (testing::Real(knots[found.span + 1]) - start);
                EXPECT_LE(static_cast<double>(abs(testing::Real(found.t) - exact)), 0x1p-51 * found.t);
            }
    }
}

TEST(SpanParameters, OutsideTheDomainAreTakenToItsBorder)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const ExtremeSurface& row : testing::extremeSurfaces()) {
        const KnotVector& knots = row.surface.knotsV();
        const double values[] = {-kInfinity, -1e308, std::numeric_limits<double>::quiet_NaN(), 1e308,
                                 kInfinity};
        const auto found = spanParameters(knots, values);
        for (size_t k = 0; k < 5; ++k) {
            EXPECT_EQ(found[k].span, k < 3 ? knots.spans().front() : knots.spans().back()) << row.name;
            EXPECT_EQ(found[k].t, k < 3 ? 0 : 1) << row.name;
        }
    }
}

}  // namespace
}  // namespace knotspan
