#include "model/mesh/space_error.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/analysis/net_on_screen.h"
#include "model/mesh/rational_derivatives.h"

namespace knotspan {

namespace {

constexpr int kMostForProducts = 16;  // of p q: beyond, products of three nets cost too much

// Each entry (i, j) of (degreeU + 1) x (degreeV + 1) is stored at i * (degreeV + 1) + j.
struct Coefficients {
    int degreeU = 0;
    int degreeV = 0;
    std::vector<Vec4> values;
};

// Row k: the coefficients of prod ((1 - t_i) + t_i x) over k times `end` and degree - k times `start`: what
// each control point counts in point k of the part [start, end] (the blossom there).
std::vector<double> partMatrix(int degree, double start, double end)
{
    const size_t order = static_cast<size_t>(degree) + 1;
    std::vector<double> matrix(order * order, 0.0);
    for (size_t k = 0; k < order; ++k) {
        double* const row = matrix.data() + k * order;
        row[0] = 1;
        for (size_t factor = 0; factor + 1 < order; ++factor) {
            const double t = factor < k ? end : start;
            for (size_t i = factor + 1; i > 0; --i)
                row[i] = row[i] * (1 - t) + row[i - 1] * t;
            row[0] *= 1 - t;
        }
    }
    return matrix;
}

// The part along u of what is given; all along v.
void takeAlongU(const Coefficients& given, const std::vector<double>& matrix, std::vector<Vec4>& result)
{
    const size_t rows = static_cast<size_t>(given.degreeU) + 1;
    const size_t row = static_cast<size_t>(given.degreeV) + 1;
    result.assign(rows * row, Vec4(0));
    for (size_t k = 0; k < rows; ++k)
        for (size_t i = 0; i < rows; ++i)
            for (size_t j = 0; j < row; ++j)
                result[k * row + j] += matrix[k * rows + i] * given.values[i * row + j];
}

// The part along v of `column`.
void takeAlongV(const Coefficients& shape, const std::vector<Vec4>& column, const std::vector<double>& matrix,
                std::vector<Vec4>& result)
{
    const size_t rows = static_cast<size_t>(shape.degreeU) + 1;
    const size_t row = static_cast<size_t>(shape.degreeV) + 1;
    result.resize(rows * row);
    for (size_t i = 0; i < rows; ++i)
        for (size_t k = 0; k < row; ++k) {
            Vec4 sum(0);
            for (size_t j = 0; j < row; ++j)
                sum += matrix[k * row + j] * column[i * row + j];
            result[i * row + k] = sum;
        }
}

// Where points are: no further than `radius` from `middle`.
struct Ball {
    Vec3 middle{0};
    double radius = 0;
};

Ball ballAround(const std::vector<Vec4>& points)
{
    Box box;
    for (const Vec4& point : points)
        box.add(Vec3(point) / point.w);
    Ball ball{box.centre(), 0};
    for (const Vec4& point : points)
        ball.radius = std::max(ball.radius, glm::distance(Vec3(point) / point.w, ball.middle));
    return ball;
}

void seeFrom(const Ball& ball, bool rational, const std::vector<Vec4>& values, Vec3& middle, double& spread,
             double& largest)
{
    middle = Vec3(0);
    spread = 0;
    largest = 0;
    if (values.empty())
        return;
    Vec3 low(INFINITY);
    Vec3 high(-INFINITY);
    for (const Vec4& value : values) {
        const Vec3 seen = rational ? Vec3(value) - ball.middle * value.w : Vec3(value);
        low = glm::min(low, seen);
        high = glm::max(high, seen);
    }
    middle = 0.5 * low + 0.5 * high;
    if (!rational) {
        for (const Vec4& value : values) {
            const Vec3 off = Vec3(value) - middle;
            spread = std::max(spread, glm::dot(off, off));
            largest = std::max(largest, glm::dot(Vec3(value), Vec3(value)));
        }
        spread = std::sqrt(spread);
        largest = std::sqrt(largest);
        return;
    }
    for (const Vec4& value : values) {
        const Vec3 seen = Vec3(value) - ball.middle * value.w;
        const double doubt = ball.radius * std::abs(value.w);
        spread = std::max(spread, glm::distance(seen, middle) + doubt);
        largest = std::max(largest, glm::length(seen) + doubt);
    }
}

using Parts = std::array<std::vector<Vec4>, 7>;  // points; secondDerivatives(); secondDerivativesOfSurface()

SpaceFigures figuresOfSurface(const std::vector<Vec4>* numerators, double leastWeight)
{
    SpaceFigures own;
    own.divisor = leastWeight * leastWeight * leastWeight;
    seeFrom({}, false, numerators[0], own.a, own.spread.x, own.largest.x);
    seeFrom({}, false, numerators[1], own.b, own.spread.y, own.largest.y);
    seeFrom({}, false, numerators[2], own.c, own.spread.z, own.largest.z);
    return own;
}

SpaceWindow windowOf(const Parts& parts, bool rational)
{
    SpaceWindow window;
    SpaceFigures& figures = window.homogeneous;
    const std::vector<Vec4>& points = parts[0];
    figures.divisor = points.front().w;
    for (const Vec4& point : points)
        figures.divisor = std::min(figures.divisor, point.w);
    const Ball ball = rational ? ballAround(points) : Ball{};
    seeFrom(ball, rational, parts[1], figures.a, figures.spread.x, figures.largest.x);
    seeFrom(ball, rational, parts[2], figures.b, figures.spread.y, figures.largest.y);
    seeFrom(ball, rational, parts[3], figures.c, figures.spread.z, figures.largest.z);
    if (!parts[4].empty())
        window.ofSurface = figuresOfSurface(parts.data() + 4, figures.divisor);
    return window;
}

double sum(const Vec3& figures, const Vec3& cell)
{
    return figures.x * cell.x + 2 * figures.y * cell.y + figures.z * cell.z;
}

// Whether the homogeneous figures are far above what the surface's own derivatives seem to be, by its
// projected net.
bool slides(const BezierNet& net, const SpaceFigures& homogeneous)
{
    BezierNet projected = net;
    for (Vec4& point : projected.points)
        point = Vec4(Vec3(point) / point.w, 1);
    const SpaceWindow about = windowOf({projected.points,
                                        secondDerivatives(projected, 2, 0),
                                        secondDerivatives(projected, 1, 1),
                                        secondDerivatives(projected, 0, 2),
                                        {},
                                        {},
                                        {}},
                                       false);
    return sum(homogeneous.largest, Vec3(1)) / homogeneous.divisor >
           4 * sum(about.homogeneous.largest, Vec3(1));
}

// Part `number` of `count`: each stretch of 1 / least lies in one of them.
std::array<double, 2> stretch(int number, int count, int least)
{
    if (count == 1)
        return {0, 1};
    const double size = (1 + (1 + 1e-9) * (count - 1) / least) / count;
    const double start = (1 - size) * number / (count - 1);
    return {start, std::min(start + size, 1.0)};
}

}  // namespace

namespace {

Vec3 sizeOfCell(const Grid& grid)
{
    return {1.0 / grid.u / grid.u, 1.0 / grid.u / grid.v, 1.0 / grid.v / grid.v};
}

// The largest square of what the middles alone make, over any triangle.
double squareOfMiddles(const SpaceFigures& figures, const Vec3& cell)
{
    // As largestOfConstant() in grid_proof.cpp, for any triangle.
    const Vec3 alongU = figures.a * cell.x;
    const Vec3 mixed = figures.b * cell.y;
    const Vec3 alongV = figures.c * cell.z;
    double squared = std::max(glm::dot(alongU, alongU), glm::dot(alongV, alongV));
    for (const Vec3& twist : {mixed, -mixed})
        for (const Vec3& value :
             {alongU + 2.0 * twist + alongV, alongU + twist + alongV, alongU + twist, alongV + twist})
            squared = std::max(squared, glm::dot(value, value));
    return squared;
}

}  // namespace

double SpaceFigures::errorBound(const Grid& grid) const
{
    return errorBound(Vec2(1.0 / grid.u, 1.0 / grid.v));
}

double SpaceFigures::errorBound(const Vec2& size) const
{
    const Vec3 cell(size.x * size.x, size.x * size.y, size.y * size.y);
    return std::min(std::sqrt(squareOfMiddles(*this, cell)) + sum(spread, cell), sum(largest, cell)) /
           (8 * divisor);
}

bool SpaceFigures::isWithin(double tolerance, const Grid& grid) const
{
    const Vec3 cell = sizeOfCell(grid);
    const double allowed = 8 * divisor * tolerance * (1 - 1e-14);  // roundings of errorBound()
    if (sum(largest, cell) <= allowed)
        return true;
    const double left = allowed - sum(spread, cell);
    return left >= 0 && squareOfMiddles(*this, cell) <= left * left;
}

double SpaceWindow::errorBound(const Grid& grid) const
{
    return errorBound(Vec2(1.0 / grid.u, 1.0 / grid.v));
}

double SpaceWindow::errorBound(const Vec2& size) const
{
    const double bound = homogeneous.errorBound(size);
    return ofSurface ? std::min(bound, ofSurface->errorBound(size)) : bound;
}

bool SpaceWindow::isWithin(double tolerance, const Grid& grid) const
{
    return homogeneous.isWithin(tolerance, grid) || (ofSurface && ofSurface->isWithin(tolerance, grid));
}

const SpaceFigures& SpaceWindow::better() const
{
    const auto all = [](const SpaceFigures& figures) {
        return sum(figures.largest, Vec3(1)) / figures.divisor;
    };
    return ofSurface && all(*ofSurface) < all(homogeneous) ? *ofSurface : homogeneous;
}

SpaceError::SpaceError(const BezierNet& net)
    : net_(net),
      rational_(std::any_of(net.points.begin(), net.points.end(),
                            [&](const Vec4& point) { return point.w != net.points.front().w; })),
      along_{secondDerivatives(net, 2, 0), secondDerivatives(net, 1, 1), secondDerivatives(net, 0, 2)},
      whole_(windowOf({net.points, along_[0], along_[1], along_[2], {}, {}, {}}, rational_))
{
}

void SpaceError::considerSurface()
{
    if (whole_.ofSurface)
        return;
    const auto [least, most] = std::minmax_element(net_.points.begin(), net_.points.end(),
                                                   [](const Vec4& a, const Vec4& b) { return a.w < b.w; });
    // Where weights differ by more, products of three would be rounding.
    if (!rational_ || net_.degreeU * net_.degreeV > kMostForProducts || most->w >= 1000 * least->w ||
        !slides(net_, whole_.homogeneous))
        return;
    BezierNet nearby = net_;
    const Ball ball = ballAround(net_.points);
    for (Vec4& point : nearby.points)
        point -= Vec4(ball.middle * point.w, 0);
    auto derivatives = secondDerivativesOfSurface(nearby);
    std::move(derivatives.begin(), derivatives.end(), ofSurface_);
    whole_.ofSurface = figuresOfSurface(ofSurface_, whole_.homogeneous.divisor);
}

std::vector<SpaceWindow> SpaceError::windows(const Grid& least, int countU, int countV) const
{
    // Polynomials of each degree: points and the derivatives that are there.
    const int p = net_.degreeU;
    const int q = net_.degreeV;
    const std::vector<Vec4> one(net_.points.begin(), net_.points.begin() + 1);
    const std::array<Coefficients, 7> whole{rational_ ? Coefficients{p, q, net_.points}
                                                      : Coefficients{0, 0, one},
                                            Coefficients{p - 2, q, along_[0]},
                                            Coefficients{p - 1, q - 1, along_[1]},
                                            Coefficients{p, q - 2, along_[2]},
                                            Coefficients{3 * p - 2, 3 * q, ofSurface_[0]},
                                            Coefficients{3 * p - 1, 3 * q - 1, ofSurface_[1]},
                                            Coefficients{3 * p, 3 * q - 2, ofSurface_[2]}};
    std::array<std::vector<std::vector<double>>, 7> alongV;  // by polynomial and window
    for (size_t k = 0; k < whole.size(); ++k)
        for (int j = 0; j < countV && !whole[k].values.empty(); ++j) {
            const auto v = stretch(j, countV, least.v);
            alongV[k].push_back(partMatrix(whole[k].degreeV, v[0], v[1]));
        }
    std::vector<SpaceWindow> result;
    result.reserve(static_cast<size_t>(countU) * static_cast<size_t>(countV));
    Parts cell;
    for (int i = 0; i < countU; ++i) {
        const auto u = stretch(i, countU, least.u);
        Parts column;
        for (size_t k = 0; k < whole.size(); ++k)
            if (!whole[k].values.empty())
                takeAlongU(whole[k], partMatrix(whole[k].degreeU, u[0], u[1]), column[k]);
        for (size_t j = 0; j < static_cast<size_t>(countV); ++j) {
            for (size_t k = 0; k < whole.size(); ++k)
                if (!column[k].empty())
                    takeAlongV(whole[k], column[k], alongV[k][j], cell[k]);
            result.push_back(windowOf(cell, rational_));
        }
    }
    return result;
}

}  // namespace knotspan
