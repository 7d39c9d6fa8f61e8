#include "model/matching/row_relation.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

constexpr double kSameKnot = 1e-9;  // of the domain's length
// Of the distance between the rows: what may be left over, 0.006 degrees. It stays as it is when rows move.
constexpr double kLeftOver = 1e-4;

bool isAlongV(Side side)
{
    return side == Side::startU || side == Side::endU;
}

bool isWhole(const EdgePart& part, const KnotVector& along)
{
    const double near = 1e-6 * (along.domainEnd() - along.domainStart());
    return part.from <= along.domainStart() + near && part.to >= along.domainEnd() - near;
}

// From 0 to 1 over the domain, seen from the other end where `reversed`.
double share(const KnotVector& knots, size_t k, bool reversed)
{
    const double length = knots.domainEnd() - knots.domainStart();
    return reversed ? (knots.domainEnd() - knots.values()[knots.values().size() - 1 - k]) / length
                    : (knots.values()[k] - knots.domainStart()) / length;
}

Vec4 homogeneousAt(const ControlPoint& point, const Mat4& place, const Vec3& origin)
{
    return {point.weight * (transformed(point.position, place) - origin), point.weight};
}

}  // namespace

int EdgeRows::length() const
{
    return isAlongV(side_) ? surface_->countV() : surface_->countU();
}

int EdgeRows::count() const
{
    return isAlongV(side_) ? surface_->countU() : surface_->countV();
}

const KnotVector& EdgeRows::along() const
{
    return isAlongV(side_) ? surface_->knotsV() : surface_->knotsU();
}

bool EdgeRows::isClamped() const
{
    const KnotVector& across = isAlongV(side_) ? surface_->knotsU() : surface_->knotsV();
    const int last = across.controlPointCount() + across.degree();
    const bool fromEnd = side_ == Side::endU || side_ == Side::endV;
    return fromEnd ? across[last - 1] == across.domainEnd() : across[1] == across.domainStart();
}

int EdgeRows::index(int row, int k) const
{
    const bool fromEnd = side_ == Side::endU || side_ == Side::endV;
    const int across = fromEnd ? count() - 1 - row : row;
    return isAlongV(side_) ? across * surface_->countV() + k : k * surface_->countV() + across;
}

const ControlPoint& EdgeRows::at(int row, int k) const
{
    return surface_->controlPoints()[static_cast<size_t>(index(row, k))];
}

Result<void> requireSameRows(const FriendEdge& edge, const EdgeRows& a, const EdgeRows& b)
{
    if (!isWhole(edge.a, a.along()) || !isWhole(edge.b, b.along()))
        return failure("only a part of one edge runs along the other");
    if (!a.isClamped() || !b.isClamped())
        return failure("a surface's knots do not end at it");
    if (a.along().degree() != b.along().degree() || a.length() != b.length())
        return failure("its two sides have different degrees or knots along it");
    for (size_t k = 0; k < a.along().values().size(); ++k)
        if (std::abs(share(a.along(), k, false) - share(b.along(), k, edge.reversed)) > kSameKnot)
            return failure("its two sides have different knots along it");
    return {};
}

Result<RowRelation> rowRelation(const FriendEdge& edge, const EdgeRows& a, const Mat4& placeA,
                                const EdgeRows& b, const Mat4& placeB)
{
    const int last = a.length() - 1;
    const Vec3 origin = transformed(a.at(0, 0).position, placeA);
    double size = 0;
    for (int k = 0; k <= last; ++k)
        size = std::max(size, glm::length(transformed(a.at(1, k).position, placeA) - origin));

    // Least squares of b's row 1 by a's rows 0 and 1, weights counting as lengths do.
    const Vec4 units{1, 1, 1, size};
    double m00 = 0;
    double m01 = 0;
    double m11 = 0;
    double r0 = 0;
    double r1 = 0;
    const auto each = [&](const auto& visit) {
        for (int k = 0; k <= last; ++k)
            visit(units * homogeneousAt(a.at(0, k), placeA, origin),
                  units * homogeneousAt(a.at(1, k), placeA, origin),
                  units * homogeneousAt(b.at(1, edge.reversed ? last - k : k), placeB, origin));
    };
    each([&](const Vec4& x0, const Vec4& x1, const Vec4& y1) {
        m00 += glm::dot(x0, x0);
        m01 += glm::dot(x0, x1);
        m11 += glm::dot(x1, x1);
        r0 += glm::dot(x0, y1);
        r1 += glm::dot(x1, y1);
    });
    const double determinant = m00 * m11 - m01 * m01;
    const RowRelation relation{(r0 * m11 - r1 * m01) / determinant, (r1 * m00 - r0 * m01) / determinant};
    double leftOver = 0;
    double between = 0;
    each([&](const Vec4& x0, const Vec4& x1, const Vec4& y1) {
        leftOver = std::max(leftOver, glm::length(y1 - relation.ofEdge * x0 - relation.ofRow * x1));
        between = std::max(between, glm::length(Vec3(x1) / x1.w - Vec3(x0) / x0.w) * x1.w / size);
    });
    if (!(relation.ofRow < 0) || !(leftOver <= kLeftOver * between * std::abs(relation.ofRow)))
        return failure("the rows of control points on its two sides do not keep one proportion");
    return relation;
}

}  // namespace knotspan
