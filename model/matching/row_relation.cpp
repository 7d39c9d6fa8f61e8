#include "model/matching/row_relation.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/matching/edge_parameters.h"

namespace knotspan {

namespace {

// Of the weight: an edge stays closed though it is pulled a million times as far as its gap is wide.
constexpr double kSameWeight = 1e-9;
// Of the distance between the rows: what may be left over, 0.006 degrees. It stays as it is when rows move.
constexpr double kLeftOver = 1e-4;
// Of the way between two points of row 0: how much less or more of it the other side may go. Tangents along
// the edge differ by that, and when it is pulled out of its plane, so do tangent planes: by 0.03 degrees.
constexpr double kOtherWay = 5e-4;

bool isAlongV(Side side)
{
    return side == Side::startU || side == Side::endU;
}

constexpr const char* kOtherPlaces = "its two sides have their control points at different places along it";

// From 0 to 1 over the domain, seen from the other end where `reversed`.
double share(const KnotVector& knots, size_t k, bool reversed)
{
    const double length = knots.domainEnd() - knots.domainStart();
    return reversed ? (knots.domainEnd() - knots.values()[knots.values().size() - 1 - k]) / length
                    : (knots.values()[k] - knots.domainStart()) / length;
}

Vec3 pointOf(const PlacedSurface& placed, const ControlPoint& point)
{
    return transformed(point.position, placed.transform);
}

bool isWhole(const PlacedSurface& placed, const EdgePart& part, double gap)
{
    return isWholeSide(*placed.surface, upToNearEnds(placed, part, gap));
}

// Whether the two polygons of rows 0 run alike from point to point.
bool runAlike(const EdgeRows& rows)
{
    Vec3 lastA{0};
    Vec3 lastB{0};
    for (int k = 0; k < rows.a.length(); ++k) {
        const Vec3 onA = pointOf(rows.placedA, rows.a.at(0, k));
        const Vec3 onB = pointOf(rows.placedB, rows.b.at(0, rows.alongB(k)));
        const double rounding = 1e-12 * (glm::length(onA) + glm::length(lastA));
        if (k > 0 &&
            glm::distance(onA - lastA, onB - lastB) > kOtherWay * glm::distance(onA, lastA) + rounding)
            return false;
        lastA = onA;
        lastB = onB;
    }
    return true;
}

// How much heavier b's row 0 is than a's.
double weightFactor(const EdgeRows& rows)
{
    return rows.b.at(0, rows.alongB(0)).weight / rows.a.at(0, 0).weight;
}

// Column k of rows 0 and 1, homogeneous, relative to an origin, weights counting as a length does: a's row 0
// and the steps from there to the rows 1.
struct Column {
    Vec4 edge;
    Vec4 stepA;
    Vec4 stepB;
    double between = 0;  // a's rows, counting as the others do
};

std::vector<Column> columnsOf(const EdgeRows& rows)
{
    const Vec3 origin = pointOf(rows.placedA, rows.a.at(0, 0));
    double size = 0;
    for (int k = 0; k < rows.a.length(); ++k)
        size = std::max(size, glm::distance(pointOf(rows.placedA, rows.a.at(1, k)), origin));
    const auto homogeneous = [&](const PlacedSurface& placed, const ControlPoint& point) {
        return Vec4(point.weight * (pointOf(placed, point) - origin), point.weight * size);
    };
    std::vector<Column> columns;
    for (int k = 0; k < rows.a.length(); ++k) {
        const int there = rows.alongB(k);
        const ControlPoint& row0 = rows.a.at(0, k);
        const ControlPoint& row1 = rows.a.at(1, k);
        const Vec4 edge = homogeneous(rows.placedA, row0);
        columns.push_back(
            {edge, homogeneous(rows.placedA, row1) - edge,
             homogeneous(rows.placedB, rows.b.at(1, there)) - homogeneous(rows.placedB, rows.b.at(0, there)),
             row1.weight * glm::distance(pointOf(rows.placedA, row1), pointOf(rows.placedA, row0))});
    }
    return columns;
}

}  // namespace

int NetRows::length() const
{
    return isAlongV(side_) ? surface_->countV() : surface_->countU();
}

int NetRows::count() const
{
    return isAlongV(side_) ? surface_->countU() : surface_->countV();
}

const KnotVector& NetRows::along() const
{
    return knotsAlong(*surface_, side_);
}

bool NetRows::isClamped() const
{
    const KnotVector& across = isAlongV(side_) ? surface_->knotsU() : surface_->knotsV();
    const int last = across.controlPointCount() + across.degree();
    const bool fromEnd = side_ == Side::endU || side_ == Side::endV;
    return fromEnd ? across[last - 1] == across.domainEnd() : across[1] == across.domainStart();
}

int NetRows::index(int row, int k) const
{
    const bool fromEnd = side_ == Side::endU || side_ == Side::endV;
    const int across = fromEnd ? count() - 1 - row : row;
    return isAlongV(side_) ? across * surface_->countV() + k : k * surface_->countV() + across;
}

const ControlPoint& NetRows::at(int row, int k) const
{
    return surface_->controlPoints()[static_cast<size_t>(index(row, k))];
}

EdgeRows::EdgeRows(const FriendEdge& edge, const PlacedSurface& ofA, const PlacedSurface& ofB)
    : placedA(ofA),
      placedB(ofB),
      a(*ofA.surface, edge.a.side),
      b(*ofB.surface, edge.b.side),
      reversed(edge.reversed)
{
}

Result<void> requireSameRows(const FriendEdge& edge, const EdgeRows& rows, double gap)
{
    const NetRows& a = rows.a;
    const NetRows& b = rows.b;
    if (!isWhole(rows.placedA, edge.a, gap) || !isWhole(rows.placedB, edge.b, gap))
        return failure("only a part of one edge runs along the other");
    if (!a.isClamped() || !b.isClamped())
        return failure("a surface's knots do not end at it");
    if (a.along().degree() != b.along().degree() || a.length() != b.length())
        return failure("its two sides have different degrees or knots along it");
    for (size_t k = 0; k < a.along().values().size(); ++k)
        if (std::abs(share(a.along(), k, false) - share(b.along(), k, edge.reversed)) > kSameKnot)
            return failure("its two sides have different knots along it");
    const double factor = weightFactor(rows);
    for (int k = 0; k < a.length(); ++k) {
        const ControlPoint& onA = a.at(0, k);
        const ControlPoint& onB = b.at(0, rows.alongB(k));
        if (!(glm::distance(pointOf(rows.placedA, onA), pointOf(rows.placedB, onB)) <= gap))
            return failure(kOtherPlaces);
        if (std::abs(onB.weight - factor * onA.weight) > kSameWeight * onB.weight)
            return failure("its two sides have different weights along it");
    }
    return {};
}

// The step of b by a's edge and a's step, least squares: as combinations of the steps, which are what counts,
// and not of the rows, which are all but the same where they lie close to each other.
Result<RowRelation> rowRelation(const EdgeRows& rows)
{
    if (!runAlike(rows))
        return failure(kOtherPlaces);
    const std::vector<Column> columns = columnsOf(rows);
    const auto sum = [&](const auto& term) {
        double total = 0;
        for (const Column& column : columns)
            total += term(column);
        return total;
    };
    const double edges = sum([](const Column& c) { return glm::dot(c.edge, c.edge); });
    // a's step less what it has of the edge.
    const double tilt = sum([](const Column& c) { return glm::dot(c.edge, c.stepA); }) / edges;
    const auto beside = [tilt](const Column& c) { return c.stepA - tilt * c.edge; };
    const double ofStep = sum([&](const Column& c) { return glm::dot(beside(c), c.stepB); }) /
                          sum([&](const Column& c) { return glm::dot(beside(c), beside(c)); });
    const double ofEdge =
        sum([&](const Column& c) { return glm::dot(c.edge, c.stepB - ofStep * c.stepA); }) / edges;
    double leftOver = 0;
    double between = 0;
    for (const Column& c : columns) {
        leftOver = std::max(leftOver, glm::length(c.stepB - ofEdge * c.edge - ofStep * c.stepA));
        between = std::max(between, c.between);
    }
    if (!(ofStep < 0) || !(leftOver <= kLeftOver * between * std::abs(ofStep)))
        return failure("the rows of control points on its two sides do not keep one proportion");
    return RowRelation{weightFactor(rows) + ofEdge - ofStep, ofStep};
}

}  // namespace knotspan
