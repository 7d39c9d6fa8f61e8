#include "model/matching/moving_side.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "model/geometry/degree_elevation.h"
#include "model/geometry/evaluation.h"
#include "model/matching/edge_first.h"
#include "model/matching/row_fit.h"

namespace knotspan {

MovingSide::MovingSide(NurbsSurface surface, const Mat4& transform)
    : own_(std::move(surface)),
      transform_(transform),
      before_(placed(own_, transform)),
      now_(before_)
{
}

void MovingSide::restart(NurbsSurface surface)
{
    *this = MovingSide(std::move(surface), transform_);
}

void MovingSide::raiseAcross(int degree)
{
    restart(withDegree(own_, Direction::U, degree));
}

void MovingSide::raiseAlong(int degree)
{
    restart(withDegree(own_, Direction::V, degree));
}

void MovingSide::insertAlong(const std::vector<double>& knots)
{
    restart(withKnotsInserted(own_, Direction::V, knots));
}

void MovingSide::moveRow(int row, const std::vector<ControlPoint>& points)
{
    now_ = withRow(now_, row, points);
    firstRow_ = lastRow_ < firstRow_ ? row : std::min(firstRow_, row);
    lastRow_ = std::max(lastRow_, row);
}

NurbsSurface MovingSide::result() const
{
    const bool inPlace = transform_ == Mat4(1.0);
    const Mat4 back = inPlace ? Mat4(1.0) : glm::inverse(transform_);
    NurbsSurface result = own_;
    for (int row = firstRow_; row <= lastRow_; ++row) {
        std::vector<ControlPoint> points = rowOf(now_, row);
        const std::vector<ControlPoint> old = rowOf(before_, row);
        const std::vector<ControlPoint> own = rowOf(own_, row);
        for (size_t k = 0; k < points.size(); ++k) {
            if (points[k] == old[k])
                points[k] = own[k];
            else if (!inPlace)
                points[k].position = transformed(points[k].position, back);
        }
        result = withRow(result, row, points);
    }
    return result;
}

double MovingSide::measuredMove() const
{
    double moved = 0;
    const KnotVector& across = now_.knotsU();
    const double reach = across[std::min(lastRow_ + across.degree() + 1, across.controlPointCount())];
    for (const double u : sampleParameters(across, 6)) {
        if (u > reach)
            break;
        for (const double v : sampleParameters(now_.knotsV(), 6))
            moved = std::max(moved,
                             glm::length(evaluate(now_, u, v).position - evaluate(before_, u, v).position));
    }
    return moved;
}

// With points p, weights w before and p', w' after, S' - S is the mean by w' of p' - p + (p - S)(w' - w) /
// w'.
double MovingSide::boundedMove() const
{
    const double size = before_.bounds().diagonal();
    double most = 0;
    double lightest = std::numeric_limits<double>::infinity();
    double weightChange = 0;
    for (size_t k = 0; k < now_.controlPoints().size(); ++k) {
        const ControlPoint& after = now_.controlPoints()[k];
        const ControlPoint& old = before_.controlPoints()[k];
        most = std::max(most, glm::length(after.position - old.position));
        lightest = std::min(lightest, after.weight);
        weightChange = std::max(weightChange, std::abs(after.weight - old.weight));
    }
    return most + size * weightChange / lightest;
}

}  // namespace knotspan
