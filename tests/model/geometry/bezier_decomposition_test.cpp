#include "model/geometry/bezier_decomposition.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/geometry/bezier_conversion.h"
#include "model/geometry/simd_targets.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

std::vector<glm::vec4> decomposed(const NurbsSurface& surface)
{
    std::vector<Vec4> points;
    for (const ControlPoint& point : surface.controlPoints())
        points.push_back(point.homogeneous());
    const BezierDecomposition decomposition(std::make_shared<const SpanMatrices>(surface.knotsU()),
                                            std::make_shared<const SpanMatrices>(surface.knotsV()));
    std::vector<glm::vec4> nets(decomposition.pointCount());
    decomposition.decompose(points, nets);
    return nets;
}

// The largest difference from single nets in double, as a share of the net's own size.
double worstDifference(const NurbsSurface& surface, const std::vector<glm::vec4>& nets)
{
    const BezierConversion conversion(surface);
    double worst = 0;
    size_t next = 0;
    for (const KsQuad& quad : ksQuads(surface)) {
        const BezierNet net = conversion.net(quad);
        double size = 0;
        for (const Vec4& point : net.points)
            size = std::max({size, std::abs(point.x), std::abs(point.y), std::abs(point.z), point.w});
        for (const Vec4& point : net.points) {
            const Vec4 difference = Vec4(nets[next++]) - point;
            for (int c = 0; c < 4; ++c)
                worst = std::max(worst, std::abs(difference[c]) / size);
        }
    }
    EXPECT_EQ(next, nets.size());
    return worst;
}

TEST(BezierDecomposition, GivesTheNetsOfEveryKsQuadRoundedToFloatOnEveryInstructionSet)
{
    for (const std::string& target : simdTargets()) {
        useSimdTarget(target);
        std::mt19937 random(5);
        for (int degree = kMinDegree; degree <= kMaxDegree; ++degree)
            for (const bool clamped : {true, false}) {
                const NurbsSurface surface = randomSurface(random, {.degreeU = degree,
                                                                    .degreeV = 1 + (degree + 2) % 7,
                                                                    .spans = 4,
                                                                    .rational = degree % 2 == 1,
                                                                    .spanRatio = 100,
                                                                    .clamped = clamped});
                EXPECT_LE(worstDifference(surface, decomposed(surface)), std::ldexp(1.0, -24) * 1.001)
                    << target << ", degree " << degree << (clamped ? "" : ", unclamped");
            }
    }
    useSimdTarget("");
}

}  // namespace
}  // namespace knotspan::testing
