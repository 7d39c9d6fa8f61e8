#include "model/trimming/curve_cutting.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/geometry/bezier_conversion.h"

namespace knotspan {

namespace {

using Numbers = std::vector<double>;
constexpr int kMostHalvings = 48;

// Of polynomials in the Bernstein basis.
Numbers product(const Numbers& a, const Numbers& b)
{
    const auto binomials = [](size_t degree) {
        Numbers row(degree + 1, 1.0);
        for (size_t k = 1; k <= degree; ++k)
            row[k] = row[k - 1] * static_cast<double>(degree - k + 1) / static_cast<double>(k);
        return row;
    };
    const Numbers ofA = binomials(a.size() - 1);
    const Numbers ofB = binomials(b.size() - 1);
    const Numbers ofBoth = binomials(a.size() + b.size() - 2);
    Numbers result(ofBoth.size(), 0.0);
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t j = 0; j < b.size(); ++j)
            result[i + j] += ofA[i] * a[i] * ofB[j] * b[j] / ofBoth[i + j];
    return result;
}

Numbers differences(const Numbers& a)
{
    Numbers result;
    for (size_t k = 0; k + 1 < a.size(); ++k)
        result.push_back(a[k + 1] - a[k]);
    return result;
}

double valueAt(Numbers a, double t)
{
    for (size_t count = a.size(); count > 1; --count)
        for (size_t k = 0; k + 1 < count; ++k)
            a[k] = (1 - t) * a[k] + t * a[k + 1];
    return a[0];
}

// A polynomial with the sign of the derivative along an axis.
Numbers slopeSign(const TrimArc& arc, int axis)
{
    Numbers weighted;
    Numbers weights;
    for (const TrimPoint& point : arc.points) {
        weighted.push_back(point.weight * (point.position[axis] - arc.start()[axis]));
        weights.push_back(point.weight);
    }
    if (std::all_of(weights.begin(), weights.end(), [&](double w) { return w == weights[0]; }))
        return differences(weighted);
    const Numbers rising = product(differences(weighted), weights);
    const Numbers falling = product(weighted, differences(weights));
    Numbers result;
    for (size_t k = 0; k < rising.size(); ++k)
        result.push_back(rising[k] - falling[k]);
    return result;
}

int signChanges(const Numbers& a)
{
    double largest = 0;
    for (const double value : a)
        largest = std::max(largest, std::abs(value));
    int changes = 0;
    double last = 0;
    for (const double value : a)
        if (std::abs(value) > 1e-14 * largest) {
            changes += last * value < 0;
            last = value;
        }
    return changes;
}

double onlyRoot(const Numbers& a)
{
    double low = 0;
    double high = 1;
    const auto first = std::find_if(a.begin(), a.end(), [](double value) { return value != 0; });
    for (int step = 0; step < 54; ++step) {
        const double middle = (low + high) / 2;
        (valueAt(a, middle) * *first > 0 ? low : high) = middle;
    }
    return (low + high) / 2;
}

// How far the control polygon runs backwards.
double backwards(const TrimArc& arc, int axis)
{
    const double way = arc.end()[axis] < arc.start()[axis] ? -1 : 1;
    double reached = way * arc.start()[axis];
    double off = 0;
    for (const TrimPoint& point : arc.points) {
        const double at = way * point.position[axis];
        off = std::max({off, reached - at, at - way * arc.end()[axis]});
        reached = std::max(reached, at);
    }
    return off;
}

// Takes out what rounding made run backwards.
void straighten(TrimArc& arc)
{
    for (const int axis : {0, 1}) {
        const double low = std::min(arc.start()[axis], arc.end()[axis]);
        const double high = std::max(arc.start()[axis], arc.end()[axis]);
        const bool rises = arc.start()[axis] <= arc.end()[axis];
        double reached = arc.start()[axis];
        for (size_t k = 1; k + 1 < arc.points.size(); ++k) {
            double& at = arc.points[k].position[axis];
            at = std::clamp(at, low, high);
            at = rises ? std::max(at, reached) : std::min(at, reached);
            reached = at;
        }
    }
}

class Cutting {
public:
    explicit Cutting(const CuttingLines& lines) : lines_(lines) {}

    void addMonotone(const TrimArc& arc, int halvings)
    {
        for (const int axis : {0, 1}) {
            if (halvings == kMostHalvings || backwards(arc, axis) <= 0.1 * lines_.nothing[axis])
                continue;
            const Numbers slope = slopeSign(arc, axis);
            const double at = signChanges(slope) == 1 ? onlyRoot(slope) : 0.5;
            if (!(at > 1e-12 && at < 1 - 1e-12))
                continue;
            auto [below, above] = split(arc, at);
            const Vec2 middle = lines_.snapped(below.end());
            below.points.back().position = middle;
            above.points.front().position = middle;
            addMonotone(below, halvings + 1);
            addMonotone(above, halvings + 1);
            return;
        }
        TrimArc straight = arc;
        straighten(straight);
        addPieces(straight, 0);
    }
    [[nodiscard]] std::vector<TrimArc> taken() { return std::move(arcs_); }

private:
    // Of a monotone arc, what lies between the lines.
    void addPieces(const TrimArc& arc, int axis)
    {
        if (axis == 2) {
            if (arc.start() != arc.end())
                arcs_.push_back(arc);
            return;
        }
        const auto line = crossed(arc, axis);
        if (!line)
            return addPieces(arc, axis + 1);
        double low = 0;
        double high = 1;
        const bool rises = arc.start()[axis] < arc.end()[axis];
        for (int step = 0; step < 54; ++step) {
            const double middle = (low + high) / 2;
            ((placeOf(arc.points, middle)[axis] < *line) == rises ? low : high) = middle;
        }
        auto [below, above] = split(arc, (low + high) / 2);
        Vec2 middle = below.end();
        middle[axis] = *line;
        middle = lines_.snapped(glm::clamp(middle, min(arc.start(), arc.end()), max(arc.start(), arc.end())));
        below.points.back().position = middle;
        above.points.front().position = middle;
        straighten(below);
        straighten(above);
        addPieces(below, axis);
        addPieces(above, axis);
    }

    // The middle one of the lines strictly between its ends.
    [[nodiscard]] std::optional<double> crossed(const TrimArc& arc, int axis) const
    {
        const std::vector<double>& places = lines_.places[axis];
        const double low = std::min(arc.start()[axis], arc.end()[axis]);
        const double high = std::max(arc.start()[axis], arc.end()[axis]);
        const auto first = std::upper_bound(places.begin(), places.end(), low);
        const auto last = std::lower_bound(places.begin(), places.end(), high);
        if (first >= last)
            return std::nullopt;
        return first[(last - first) / 2];
    }

    static Vec2 min(const Vec2& a, const Vec2& b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
    static Vec2 max(const Vec2& a, const Vec2& b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }

    const CuttingLines& lines_;
    std::vector<TrimArc> arcs_;
};

}  // namespace

std::vector<TrimArc> bezierArcs(const TrimCurve& curve)
{
    const KnotVector& knots = curve.knots();
    const auto order = static_cast<size_t>(knots.degree() + 1);
    std::vector<TrimArc> arcs;
    for (const int span : knots.spans()) {
        const std::vector<double> matrix = bezierMatrix(knots, span);
        const TrimPoint* const points = &curve.points()[static_cast<size_t>(span) + 1 - order];
        const Vec2 origin = points[0].position;
        TrimArc arc{std::vector<TrimPoint>(order), knots[span], knots[span + 1]};
        for (size_t k = 0; k < order; ++k) {
            Vec2 sum(0.0);
            double weight = 0;
            for (size_t i = 0; i < order; ++i) {
                const double share = matrix[k * order + i] * points[i].weight;
                sum += share * (points[i].position - origin);
                weight += share;
            }
            arc.points[k] = {origin + sum / weight, weight};
        }
        if (!arcs.empty())
            arc.points.front().position = arcs.back().end();
        arcs.push_back(std::move(arc));
    }
    return arcs;
}

std::pair<TrimArc, TrimArc> split(const TrimArc& arc, double t)
{
    const size_t count = arc.points.size();
    const double middle = arc.from + t * (arc.to - arc.from);
    std::pair<TrimArc, TrimArc> parts{{arc.points, arc.from, middle}, {arc.points, middle, arc.to}};
    std::vector<TrimPoint>& points = parts.second.points;
    for (size_t step = 1; step < count; ++step) {
        for (size_t k = 0; k + step < count; ++k) {
            const double low = (1 - t) * points[k].weight;
            const double high = t * points[k + 1].weight;
            const Vec2 way = points[k + 1].position - points[k].position;
            points[k] = {points[k].position + high / (low + high) * way, low + high};
        }
        parts.first.points[step] = points[0];
    }
    return parts;
}

Vec2 placeOf(const std::vector<TrimPoint>& points, double t)
{
    const TrimArc arc{points};
    return split(arc, t).first.end();
}

CuttingLines CuttingLines::of(const KnotVector& knotsU, const KnotVector& knotsV)
{
    CuttingLines lines;
    for (const int axis : {0, 1}) {
        const KnotVector& knots = axis == 0 ? knotsU : knotsV;
        for (const int span : knots.spans())
            lines.places[axis].push_back(knots[span]);
        lines.places[axis].push_back(knots.domainEnd());
        lines.nothing[axis] = 1e-11 * (knots.domainEnd() - knots.domainStart());
    }
    return lines;
}

Vec2 CuttingLines::snapped(Vec2 place) const
{
    for (const int axis : {0, 1}) {
        const auto next = std::lower_bound(places[axis].begin(), places[axis].end(), place[axis]);
        if (next != places[axis].end() && *next - place[axis] <= nothing[axis])
            place[axis] = *next;
        else if (next != places[axis].begin() && place[axis] - next[-1] <= nothing[axis])
            place[axis] = next[-1];
    }
    return place;
}

std::vector<TrimArc> cutArcs(const TrimArc& arc, const CuttingLines& lines)
{
    TrimArc snapped = arc;
    for (TrimPoint& point : snapped.points)
        point.position = lines.snapped(point.position);
    Cutting cutting(lines);
    cutting.addMonotone(snapped, 0);
    return cutting.taken();
}

}  // namespace knotspan
