#include "model/analysis/screen_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/analysis/net_on_screen.h"
#include "model/core/check.h"

namespace knotspan {

ScreenView screenView(const Mat4& toClip, double widthPixels, double heightPixels)
{
    Mat4 viewport(1.0);
    viewport[0][0] = 0.5 * widthPixels;
    viewport[1][1] = 0.5 * heightPixels;
    viewport[3] = Vec4(0.5 * widthPixels, 0.5 * heightPixels, 0, 1);
    return {viewport * toClip, Vec2(0), Vec2(widthPixels, heightPixels)};
}

double ErrorFigures::errorBound(const Grid& grid) const
{
    return (a / grid.u / grid.u + 2 * b / grid.u / grid.v + c / grid.v / grid.v) / 8;
}

namespace {

// The net's parts after midpoint subdivision.
std::vector<BezierNet> partsOf(const BezierNet& net, int subdivisions)
{
    std::vector<BezierNet> parts{net};
    for (int k = 0; k < subdivisions; ++k) {
        std::vector<BezierNet> smaller;
        for (const BezierNet& part : parts) {
            const auto [lower, upper] = split(part, Direction::U);
            for (const BezierNet* half : {&lower, &upper}) {
                auto [first, second] = split(*half, Direction::V);
                smaller.push_back(std::move(first));
                smaller.push_back(std::move(second));
            }
        }
        parts = std::move(smaller);
    }
    return parts;
}

// The largest |d.xy - s d.w| of the differences d, s over all projected points.
double largest(const std::vector<Vec4>& differences, const std::vector<Vec2>& projected)
{
    double squared = 0;
    for (const Vec4& d : differences)
        for (const Vec2& s : projected) {
            const Vec2 seen = Vec2(d) - s * d.w;
            squared = std::max(squared, glm::dot(seen, seen));
        }
    return std::sqrt(squared);
}

double largest(const std::vector<Vec4>& differences, const Disc& disc)
{
    double result = 0;
    for (const Vec4& d : differences)
        result = std::max(result, disc.largestSeen(d));
    return result;
}

}  // namespace

std::optional<ErrorFigures> errorFigures(const BezierNet& pixels, int subdivisions, FigureForm form)
{
    for (const Vec4& point : pixels.points)
        if (!(point.w > 0))
            return std::nullopt;
    // A triangle may lie over several parts, its derivatives from one and its point in another: only the
    // derivatives and the smallest w are taken from the parts, s from the whole.
    std::vector<Vec2> projected;
    for (const Vec4& point : pixels.points)
        projected.push_back(Vec2(point) / point.w);
    const Disc disc = Disc::around(projected);
    ErrorFigures result;
    double nearest = std::numeric_limits<double>::infinity();
    for (const BezierNet& part : partsOf(pixels, subdivisions)) {
        for (const Vec4& point : part.points)
            nearest = std::min(nearest, point.w);
        const auto figure = [&](int orderU, int orderV) {
            const std::vector<Vec4> differences = secondDerivatives(part, orderU, orderV);
            return form == FigureForm::tight ? largest(differences, projected) : largest(differences, disc);
        };
        result.a = std::max(result.a, figure(2, 0));
        result.b = std::max(result.b, figure(1, 1));
        result.c = std::max(result.c, figure(0, 2));
    }
    const double scale = std::ldexp(1.0, 2 * subdivisions) / nearest;
    result = {scale * result.a, scale * result.b, scale * result.c};
    if (!std::isfinite(result.a + result.b + result.c))
        return std::nullopt;
    return result;
}

std::optional<Grid> smallestGrid(const ErrorFigures& figures, double tolerance, int largest)
{
    check(tolerance > 0, "a tolerance is above zero");
    // No n_u makes n_v smaller than this.
    const double fewestV = std::max(1.0, std::ceil(std::sqrt(figures.c / (8 * tolerance))));
    // And no n_v a smaller n_u.
    const double fewestU = std::max(1.0, std::floor(std::sqrt(figures.a / (8 * tolerance))));
    if (!(fewestU <= largest))
        return std::nullopt;
    std::optional<Grid> best;
    for (int u = static_cast<int>(fewestU);
         u <= largest && (!best || u * fewestV < static_cast<double>(best->cells())); ++u) {
        const double left = 8 * tolerance - figures.a / u / u;
        if (!(left > 0))
            continue;
        const double mixed = 2 * figures.b / u;
        const double v = std::ceil((mixed + std::sqrt(mixed * mixed + 4 * left * figures.c)) / (2 * left));
        if (!(v <= largest))
            continue;
        Grid grid{u, std::max(1, static_cast<int>(v))};
        if (figures.errorBound(grid) > tolerance)  // by a rounding
            ++grid.v;
        if (!best || grid.cells() < best->cells())
            best = grid;
    }
    return best;
}

namespace {

// Read in the direction in which its points come first in lexicographic order; the ends decide, but where the
// curve is closed.
BezierNet inCanonicalDirection(BezierNet curve)
{
    const auto before = [](const Vec4& x, const Vec4& y) {
        for (int axis = 0; axis < 4; ++axis)
            if (x[axis] != y[axis])
                return x[axis] < y[axis];
        return false;
    };
    if (std::lexicographical_compare(curve.points.rbegin(), curve.points.rend(), curve.points.begin(),
                                     curve.points.end(), before))
        std::reverse(curve.points.begin(), curve.points.end());
    return curve;
}

}  // namespace

int edgeFactor(const BezierNet& curve, const ScreenView& view, double tolerance, int largest)
{
    check(tolerance > 0, "a tolerance is above zero");
    check(curve.degreeV == 0, "an edge is a curve");
    const BezierNet canonical = inCanonicalDirection(curve);
    const NetOnScreen seen(canonical, view);
    if (!seen.visible)
        return 1;
    double a = 0;
    double inW = 0;
    const auto [lower, upper] = split(canonical, Direction::U);
    for (const BezierNet* half : {&lower, &upper}) {
        const auto [first, second] = split(*half, Direction::U);
        for (const BezierNet* quarter : {&first, &second})
            for (const Vec4& d : secondDerivatives(*quarter, 2, 0)) {
                a = std::max(a, 16 * seen.disc.largestSeen(d));
                inW = std::max(inW, 16 * std::abs(d.w));
            }
    }
    double squared = a / (8 * tolerance * seen.nearest);
    if (!seen.inFront)  // half of the near plane's w is kept for the error of w itself
        squared = std::max(2 * squared, inW / (4 * seen.nearest));
    const double cells = std::max(1.0, std::ceil(std::sqrt(squared)));
    return cells <= largest ? static_cast<int>(cells) : largest;
}

}  // namespace knotspan
