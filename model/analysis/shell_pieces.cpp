#include "model/analysis/shell_pieces.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "model/analysis/bezier_curves.h"

namespace knotspan {

Slabs::Slabs(const BezierNet& net)

{
    low_.fill(std::numeric_limits<double>::infinity());
    high_.fill(-std::numeric_limits<double>::infinity());
    for (const Vec4& homogeneous : net.points) {
        const Vec3 p = pointOf(homogeneous);
        const std::array<double, kCount> along = {p.x,
                                                  p.y,
                                                  p.z,
                                                  p.x + p.y,
                                                  p.x - p.y,
                                                  p.x + p.z,
                                                  p.x - p.z,
                                                  p.y + p.z,
                                                  p.y - p.z,
                                                  p.x + p.y + p.z,
                                                  p.x + p.y - p.z,
                                                  p.x - p.y + p.z,
                                                  p.x - p.y - p.z};
        for (size_t k = 0; k < kCount; ++k) {
            low_[k] = std::min(low_[k], along[k]);
            high_[k] = std::max(high_[k], along[k]);
        }
    }
}

Piece::Piece(BezierNet of) : net_(std::move(of)), slabs_(net_)
{
    for (size_t k = 0; k < 4; ++k)
        corners_[k] = pointOf(net_.at(k % 2 == 0 ? 0 : net_.degreeU, k < 2 ? 0 : net_.degreeV));
}

const std::vector<Piece>& Piece::quarters()

{
    if (!quarters_.empty())
        return quarters_;
    quarters_.reserve(4);
    const auto [low, high] = split(net_, Direction::U);
    for (const BezierNet* half : {&low, &high}) {
        auto [first, second] = split(*half, Direction::V);
        quarters_.emplace_back(std::move(first));
        quarters_.emplace_back(std::move(second));
    }
    return quarters_;
}

bool Piece::isApartFrom(const Piece& other) const
{
    const auto areApartAlong = [&](const Vec3& direction) {
        const auto [low, high] = reach(direction);
        const auto [otherLow, otherHigh] = other.reach(direction);
        return low > otherHigh || otherLow > high;
    };
    return slabs_.areApart(other.slabs_) || areApartAlong(across()) || areApartAlong(other.across());
}

bool Piece::sharesCorner(const Piece& other, double margin) const
{
    for (const Vec3& one : corners_)
        for (const Vec3& another : other.corners_)
            if (glm::dot(one - another, one - another) <= margin * margin)
                return true;
    return false;
}

Vec3 Piece::across() const
{
    return glm::cross(corners_[3] - corners_[0], corners_[2] - corners_[1]);
}

std::pair<double, double> Piece::reach(const Vec3& direction) const
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vec4& point : net_.points) {
        const double along = glm::dot(direction, pointOf(point));
        low = std::min(low, along);
        high = std::max(high, along);
    }
    return {low, high};
}

namespace {

constexpr int kSplits = 200;

// `splits` are those that it may still take.
bool areApartWith(const Piece& a, const Piece& b, int& splits)
{
    if (a.isApartFrom(b))
        return true;
    if (--splits < 0)
        return false;
    const bool cutA = a.slabs().size() > b.slabs().size();
    Piece cut = cutA ? a : b;
    for (const Piece& quarter : cut.quarters())
        if (!areApartWith(quarter, cutA ? b : a, splits))
            return false;
    return true;
}

}  // namespace

bool areApart(const Piece& a, const Piece& b)
{
    int splits = kSplits;
    return areApartWith(a, b, splits);
}

bool areApartButForCorners(Piece& a, Piece& b, double margin)
{
    for (const Piece& one : a.quarters())
        for (const Piece& other : b.quarters()) {
            if (!one.slabs().areApart(other.slabs()) && !one.sharesCorner(other, margin) &&
                !areApart(one, other))
                return false;
        }
    return true;
}

}  // namespace knotspan
