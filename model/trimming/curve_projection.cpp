#include "model/trimming/curve_projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/trimming/projected_sheet.h"

namespace knotspan {

namespace {

constexpr int kMostHalvings = 16;
constexpr double kFarthest = 0.5;  // of the domain: further, and it is another sheet

struct Knot {
    double t = 0;
    Vec2 at;
    Vec2 change;  // by t
};

// A cubic from one to the other.
std::array<Vec2, 4> cubic(const Knot& a, const Knot& b)
{
    const double third = (b.t - a.t) / 3;
    return {a.at, a.at + third * a.change, b.at - third * b.change, b.at};
}

Vec2 pointOf(std::array<Vec2, 4> points, double s)
{
    for (size_t count = 3; count > 0; --count)
        for (size_t k = 0; k < count; ++k)
            points[k] = glm::mix(points[k], points[k + 1], s);
    return points[0];
}

class Following {
public:
    Following(const ProjectedSheet& sheet, const PlanePiece& piece, double tolerance)
        : sheet_(sheet),
          piece_(piece),
          tolerance_(tolerance)
    {
    }

    // From the place at t = 0 on; false where it cannot be followed.
    bool run(const Vec2& start)
    {
        const auto first = knotAt(0, start);
        if (!first)
            return false;
        knots_ = {*first};
        std::vector<double> ends = piece_.breaks;
        ends.push_back(1);
        return std::all_of(ends.begin(), ends.end(), [&](double end) { return reach(end, 0); });
    }
    [[nodiscard]] const std::vector<Knot>& knots() const { return knots_; }
    [[nodiscard]] double error() const { return error_; }

private:
    [[nodiscard]] std::optional<Knot> knotAt(double t, const Vec2& near) const
    {
        const auto at = sheet_.placeOf(piece_.at(t), near);
        const auto picture = at ? sheet_.picture(*at) : std::nullopt;
        if (!picture || picture->isEdgeOn() || picture->turn() * turn_ < 0)
            return std::nullopt;
        return Knot{t, *at, picture->solve(piece_.change(t))};
    }

    // The largest distance at some places; nothing where one of them cannot be found.
    [[nodiscard]] std::optional<double> errorOf(const Knot& a, const Knot& b) const
    {
        constexpr int kParts = 10;
        const std::array<Vec2, 4> points = cubic(a, b);
        double error = 0;
        for (int k = 1; k < kParts; ++k) {
            const double s = static_cast<double>(k) / kParts;
            const Vec2 found = pointOf(points, s);
            const auto exact = sheet_.placeOf(piece_.at(std::lerp(a.t, b.t, s)), found);
            if (!exact)
                return std::nullopt;
            error = std::max(error, glm::length(sheet_.position(found) - sheet_.position(*exact)));
        }
        return error;
    }

    bool reach(double end, int halvings)
    {
        const Knot from = knots_.back();
        if (const auto picture = sheet_.picture(from.at); picture && turn_ == 0)
            turn_ = picture->turn();
        const auto to = knotAt(end, from.at + (end - from.t) * from.change);
        const bool isNear =
            to && glm::all(glm::lessThan(glm::abs(to->at - from.at), kFarthest * sheet_.size()));
        const auto error = isNear ? errorOf(from, *to) : std::nullopt;
        if (error && *error <= tolerance_) {
            knots_.push_back(*to);
            error_ = std::max(error_, *error);
            return true;
        }
        if (halvings == kMostHalvings)
            return false;
        return reach((from.t + end) / 2, halvings + 1) && reach(end, halvings + 1);
    }

    const ProjectedSheet& sheet_;
    const PlanePiece& piece_;
    double tolerance_;
    double turn_ = 0;  // which side of the sheet is seen
    std::vector<Knot> knots_;
    double error_ = 0;
};

// Cubics that follow each other smoothly need no control points at their joints.
TrimCurve curveThrough(const std::vector<Knot>& knots)
{
    std::vector<double> values(4, knots.front().t);
    std::vector<TrimPoint> points{{knots.front().at, 1}};
    for (size_t k = 0; k + 1 < knots.size(); ++k) {
        const std::array<Vec2, 4> cubicPoints = cubic(knots[k], knots[k + 1]);
        points.push_back({cubicPoints[1], 1});
        points.push_back({cubicPoints[2], 1});
        values.insert(values.end(), k + 2 < knots.size() ? 2 : 4, knots[k + 1].t);
    }
    points.push_back({knots.back().at, 1});
    auto vector = KnotVector::create(3, std::move(values));
    check(vector.has_value(), "knots of a followed curve increase");
    auto curve = TrimCurve::create(*std::move(vector), std::move(points));
    check(curve.has_value(), "a followed curve is finite");
    return *std::move(curve);
}

}  // namespace

PlaneCurve closedPolygon(const std::vector<Vec2>& corners)
{
    PlaneCurve curve;
    for (size_t k = 0; k < corners.size(); ++k) {
        const Vec2 from = corners[k];
        const Vec2 to = corners[(k + 1) % corners.size()];
        curve.push_back(
            {[=](double t) { return glm::mix(from, to, t); }, [=](double) { return to - from; }, {}});
    }
    return curve;
}

PlaneCurve closedSpline(const std::vector<Vec2>& points)
{
    struct Spline {
        std::vector<double> ends;    // of the parts, of 0 to 1; first 0
        std::vector<Vec2> points;    // the first one again at the end, likewise:
        std::vector<Vec2> tangents;  // by t
    };
    const size_t count = points.size();
    auto spline = std::make_shared<Spline>();
    spline->points = points;
    spline->points.push_back(points.front());
    spline->ends = {0};
    for (size_t k = 0; k < count; ++k)
        spline->ends.push_back(spline->ends.back() + glm::length(spline->points[k + 1] - spline->points[k]));
    for (double& end : spline->ends)
        end /= spline->ends.back();
    spline->ends.back() = 1;
    const auto length = [&](size_t k) { return spline->ends[k % count + 1] - spline->ends[k % count]; };
    const auto slope = [&](size_t k) {
        return (spline->points[k % count + 1] - spline->points[k % count]) / length(k);
    };
    // The same curvature on both sides of each point: by Gauss and Seidel, as the diagonal is twice the rest.
    spline->tangents.assign(count + 1, Vec2(0));
    for (int round = 0; round < 100; ++round)
        for (size_t k = 0; k < count; ++k) {
            const double before = length(k + count - 1);
            const double after = length(k);
            const Vec2 right = 3.0 * (after * slope(k + count - 1) + before * slope(k));
            spline->tangents[k] = (right - after * spline->tangents[(k + count - 1) % count] -
                                   before * spline->tangents[(k + 1) % count]) /
                                  (2 * (before + after));
        }
    spline->tangents.back() = spline->tangents.front();
    const auto partAt = [spline](double t) {
        const auto next = std::upper_bound(spline->ends.begin() + 1, spline->ends.end() - 1, t);
        return static_cast<size_t>(next - spline->ends.begin()) - 1;
    };
    const auto pieceOf = [spline](size_t k) {
        return cubic({spline->ends[k], spline->points[k], spline->tangents[k]},
                     {spline->ends[k + 1], spline->points[k + 1], spline->tangents[k + 1]});
    };
    const auto share = [spline](size_t k, double t) {
        return (t - spline->ends[k]) / (spline->ends[k + 1] - spline->ends[k]);
    };
    PlanePiece piece;
    piece.breaks.assign(spline->ends.begin() + 1, spline->ends.end() - 1);
    piece.at = [=](double t) { return pointOf(pieceOf(partAt(t)), share(partAt(t), t)); };
    piece.change = [=](double t) {
        const size_t k = partAt(t);
        const std::array<Vec2, 4> b = pieceOf(k);
        const double s = share(k, t);
        const Vec2 low = glm::mix(b[1] - b[0], b[2] - b[1], s);
        const Vec2 high = glm::mix(b[2] - b[1], b[3] - b[2], s);
        return 3.0 * glm::mix(low, high, s) / (spline->ends[k + 1] - spline->ends[k]);
    };
    return {std::move(piece)};
}

std::optional<Vec2> projectedPlace(const NurbsSurface& surface, const PlaneProjection& projection,
                                   const Vec2& point, const Vec2& start)
{
    return ProjectedSheet(surface, projection).placeOf(point, start);
}

Result<ProjectedCurve> projectedOnto(const NurbsSurface& surface, const PlaneProjection& projection,
                                     const PlaneCurve& curve, const Vec2& start, double tolerance)
{
    const ProjectedSheet sheet(surface, projection);
    ProjectedCurve result;
    std::vector<std::vector<Knot>> parts;
    Vec2 at = start;
    for (const PlanePiece& piece : curve) {
        Following following(sheet, piece, tolerance);
        if (!following.run(at))
            return failure("The curve comes to where the surface is seen edge-on or turns away",
                           "Draw it where the surface faces you, or turn the view");
        parts.push_back(following.knots());
        if (parts.size() > 1)
            parts.back().front().at = at;
        at = parts.back().back().at;
        result.error = std::max(result.error, following.error());
    }
    // The same place by two ways, but for rounding.
    Vec2& end = parts.back().back().at;
    const Vec2& begin = parts.front().front().at;
    if (glm::all(glm::lessThan(glm::abs(end - begin), 1e-9 * sheet.size())))
        end = begin;
    for (const std::vector<Knot>& knots : parts)
        result.curves.push_back(curveThrough(knots));
    return result;
}

}  // namespace knotspan
