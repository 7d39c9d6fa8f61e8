// keepsTolerance(): blocks of cells are proved by their second derivatives or divided, along the borders of
// cells, until they are single cells, whose error polynomial itself is bounded.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/analysis/grid_choice.h"
#include "model/analysis/net_on_screen.h"
#include "model/core/check.h"

namespace knotspan {

namespace {

// A second derivative as the middle of the picture's part sees it: the middle of its values and how far they,
// seen from elsewhere in the disc too, are from that; and the largest.
struct SeenDerivative {
    Vec2 middle{0, 0};
    double spread = 0;
    double largest = 0;
    double largestW = 0;
};

SeenDerivative seen(const std::vector<Vec4>& values, const Disc& disc)
{
    SeenDerivative result;
    if (values.empty())
        return result;
    Vec2 low(std::numeric_limits<double>::infinity());
    Vec2 high(-low);
    for (const Vec4& value : values) {
        low = glm::min(low, disc.seen(value));
        high = glm::max(high, disc.seen(value));
    }
    result.middle = 0.5 * (low + high);
    for (const Vec4& value : values) {
        const double doubt = disc.doubt(value);
        result.spread = std::max(result.spread, glm::length(disc.seen(value) - result.middle) + doubt);
        result.largest = std::max(result.largest, glm::length(disc.seen(value)) + doubt);
        result.largestW = std::max(result.largestW, std::abs(value.w));
    }
    return result;
}

// 8 times the largest error of a cell over which the second derivatives a, b, c (times the cell's size) are
// constant. At barycentric place l_i it is half of H : sum l_i d_i d_i^T, d_i to the corners, linear in that
// matrix; the right triangles' matrices lie in the hull of 0, (1,0;0,0), (0,0;0,1), (1,1;1,1) and
// (1,1/2;1/2,1), a quarter each, with the sign of the diagonal; those of any triangle in the cell in the hull
// of (1,t;t,t^2) and (t^2,t;t,1), |t| <= 1.
double largestOfConstant(const Vec2& a, const Vec2& b, const Vec2& c, Triangles triangles)
{
    double result = std::max(glm::length(a), glm::length(c));
    const auto include = [&](const Vec2& along) {
        result = std::max({result, glm::length(a + 2.0 * along + c), glm::length(a + along + c)});
        if (triangles == Triangles::any)
            result = std::max({result, glm::length(a + along), glm::length(c + along)});
    };
    if (triangles != Triangles::fallingDiagonal)
        include(b);
    if (triangles != Triangles::risingDiagonal)
        include(-b);
    return result;
}

class Proof {
public:
    Proof(const ScreenView& view, double tolerance, Triangles triangles, const ProofEffort& effort)
        : view_(view),
          tolerance_(tolerance),
          triangles_(triangles),
          effort_(effort),
          blocksLeft_(effort.blocks)
    {
    }

    [[nodiscard]] bool ofBlock(const BezierNet& net, const Grid& cells, int divisions)
    {
        const NetOnScreen on(net, view_);
        if (!on.visible)
            return true;
        const Verdict verdict = bySecondDerivatives(net, on, cells);
        if (verdict != Verdict::open)
            return verdict == Verdict::within;
        if (cells.cells() == 1)
            return triangles_ != Triangles::any && effort_.polynomialLevels >= 0 &&
                   byErrorPolynomial(net, on);
        if (divisions == 0 || --blocksLeft_ <= 0)
            return false;
        const bool alongU = cells.u >= cells.v;
        const int all = alongU ? cells.u : cells.v;
        const int lower = all / 2;
        const auto [first, second] =
            split(net, alongU ? Direction::U : Direction::V, static_cast<double>(lower) / all);
        return ofBlock(first, alongU ? Grid{lower, cells.v} : Grid{cells.u, lower}, divisions - 1) &&
               ofBlock(second, alongU ? Grid{all - lower, cells.v} : Grid{cells.u, all - lower},
                       divisions - 1);
    }

private:
    enum class Verdict { within, beyond, open };

    // The error is |E.xy - s E.w| / w where s is the drawn point and w the surface's, E.w off the triangle's.
    [[nodiscard]] bool small(double error, double errorOfW, const NetOnScreen& on, double nearest) const
    {
        return error <= tolerance_ * (on.inFront ? nearest : on.nearest - errorOfW);
    }

    [[nodiscard]] Verdict bySecondDerivatives(const BezierNet& net, const NetOnScreen& on,
                                              const Grid& cells) const
    {
        const double hu = 1.0 / cells.u;
        const double hv = 1.0 / cells.v;
        const SeenDerivative a = seen(secondDerivatives(net, 2, 0), on.disc);
        const SeenDerivative b = seen(secondDerivatives(net, 1, 1), on.disc);
        const SeenDerivative c = seen(secondDerivatives(net, 0, 2), on.disc);
        const auto sum = [&](double SeenDerivative::*part) {
            return a.*part * hu * hu + 2 * (b.*part) * hu * hv + c.*part * hv * hv;
        };
        const double constant =
            largestOfConstant(a.middle * (hu * hu), b.middle * (hu * hv), c.middle * (hv * hv), triangles_);
        const double error = std::min(sum(&SeenDerivative::largest), constant + sum(&SeenDerivative::spread));
        if (small(error / 8, sum(&SeenDerivative::largestW) / 8, on, on.nearest))
            return Verdict::within;
        // The same from below.
        const double least = constant - sum(&SeenDerivative::spread);
        return on.whole && least / 8 > tolerance_ * on.farthest ? Verdict::beyond : Verdict::open;
    }

    // Over a cell the surface less its bilinear interpolant is the polynomial with control points P; the two
    // triangles differ from that interpolant by at most a quarter of its twist D, all to one side:
    // (0,0)-(1,1) by -t D, the other diagonal by t D, 0 <= t <= 1/4.
    [[nodiscard]] bool byErrorPolynomial(const BezierNet& net, const NetOnScreen& on)
    {
        const int p = net.degreeU;
        const int q = net.degreeV;
        BezierNet error = net;
        for (int i = 0; i <= p; ++i)
            for (int j = 0; j <= q; ++j) {
                const double s = static_cast<double>(i) / p;
                const double t = static_cast<double>(j) / q;
                error.at(i, j) -= (1 - s) * ((1 - t) * net.at(0, 0) + t * net.at(0, q)) +
                                  s * ((1 - t) * net.at(p, 0) + t * net.at(p, q));
            }
        const Vec4 quarterTwist = 0.25 * ((net.at(0, 0) + net.at(p, q)) - (net.at(p, 0) + net.at(0, q)));
        return polynomialIsSmall(error, net, quarterTwist, on, 0);
    }

    [[nodiscard]] bool polynomialIsSmall(const BezierNet& error, const BezierNet& net, const Vec4& twist,
                                         const NetOnScreen& on, int level)
    {
        double largest = 0;
        double largestW = 0;
        const auto include = [&](const Vec4& value) {
            largest = std::max(largest, on.disc.largestSeen(value));
            largestW = std::max(largestW, std::abs(value.w));
        };
        double nearest = std::numeric_limits<double>::infinity();
        for (size_t k = 0; k < error.points.size(); ++k) {
            nearest = std::min(nearest, net.points[k].w);
            include(error.points[k]);
            if (triangles_ != Triangles::fallingDiagonal)
                include(error.points[k] - twist);
            if (triangles_ != Triangles::risingDiagonal)
                include(error.points[k] + twist);
        }
        if (small(largest, largestW, on, nearest))
            return true;
        if (level >= effort_.polynomialLevels || --blocksLeft_ <= 0)
            return false;
        const auto errors = quarters(error);
        const auto nets = quarters(net);
        for (size_t k = 0; k < errors.size(); ++k)
            if (!polynomialIsSmall(errors[k], nets[k], twist, on, level + 1))
                return false;
        return true;
    }

    static std::array<BezierNet, 4> quarters(const BezierNet& net)
    {
        auto [lower, upper] = split(net, Direction::U);
        auto [a, b] = split(lower, Direction::V);
        auto [c, d] = split(upper, Direction::V);
        return {std::move(a), std::move(b), std::move(c), std::move(d)};
    }

    const ScreenView& view_;
    double tolerance_;
    Triangles triangles_;
    ProofEffort effort_;
    int blocksLeft_;
};

}  // namespace

bool keepsTolerance(const BezierNet& pixels, const ScreenView& view, const Grid& grid, double tolerance,
                    Triangles triangles, const ProofEffort& effort)
{
    check(pixels.degreeU > 0 && pixels.degreeV > 0, "a KSQuad has a degree in both directions");
    return Proof(view, tolerance, triangles, effort).ofBlock(pixels, grid, effort.divisions);
}

}  // namespace knotspan
