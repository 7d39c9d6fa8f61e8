#include "model/geometry/local_net.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace knotspan {

namespace {

// p / (length of the knots under it): what turns the difference of the points `index` and `index` + 1 of the
// `order` - 1-th derivative into a point of the `order`-th. Indices count from the first that shapes `span`.
double rate(const KnotVector& knots, int first, int order, int index)
{
    const int p = knots.degree() - order + 1;
    const int low = first + order + index;
    return p / (knots[low + p] - knots[low]);
}

}  // namespace

LocalNet::LocalNet(const NurbsSurface& surface, double u, double v) : surface_(surface)
{
    const int spanU = surface.knotsU().findSpan(u);
    const int spanV = surface.knotsV().findSpan(v);
    firstU_ = spanU - degreeU();
    firstV_ = spanV - degreeV();
    basisU_ = basisOfDegrees(surface.knotsU(), spanU, u);
    basisV_ = basisOfDegrees(surface.knotsV(), spanV, v);
    // Binary orders of size are exact enough, and products of tiny figures do not vanish.
    int most = std::numeric_limits<int>::min();
    for (int i = 0; i <= degreeU(); ++i)
        for (int j = 0; j <= degreeV(); ++j) {
            const double partU = basisU_[0][static_cast<size_t>(i)];
            const double partV = basisV_[0][static_cast<size_t>(j)];
            if (!(partU > 0) || !(partV > 0))
                continue;
            const int order = std::ilogb(partU) + std::ilogb(partV) + std::ilogb(point(i, j).weight);
            if (order > most) {
                most = order;
                heaviestI_ = i;
                heaviestJ_ = j;
            }
        }
    lightening_ = std::ldexp(1.0, std::clamp(-std::ilogb(point(heaviestI_, heaviestJ_).weight), -1022, 1022));
    const Box& box = surface.bounds();
    const Vec3 largest = glm::max(glm::abs(box.low), glm::abs(box.high));
    if (std::max({largest.x, largest.y, largest.z}) > 0x1p500)
        shrinking_ = 0x1p-600;
}

double LocalNet::weight(int i, int j) const
{
    return std::min(point(i, j).weight * lightening_, 0x1p1000);
}

// w1 (P1 - O) - w0 (P0 - O) with O = heaviest() + from, by what differs: exact to the last digits where
// neighbours nearly coincide and where one weighs much more than the other.
template <LocalNet::Parts parts>
Vec4 LocalNet::neighbours(int i, int j, int nextI, int nextJ, const Vec3& from) const
{
    const double weight0 = weight(i, j);
    const double weight1 = weight(nextI, nextJ);
    const Vec3 step = position(nextI, nextJ) - position(i, j);
    const Vec3 arm = (weight0 < weight1 ? position(nextI, nextJ) : position(i, j)) - heaviest() - from;
    const double lighter = std::min(weight0, weight1);
    const double more = weight1 - weight0;
    if constexpr (parts == Parts::sizes)
        return {lighter * glm::abs(step) + std::abs(more) * glm::abs(arm), std::abs(more)};
    return {lighter * step + more * arm, more};
}

// Point (i, j) of the net of a partial derivative.
template <LocalNet::Parts parts>
Vec4 LocalNet::controlPoint(int orderU, int orderV, int i, int j, const Vec3& from) const
{
    const auto combined = [](const Vec4& a, const Vec4& b) { return parts == Parts::sizes ? b + a : b - a; };
    if (orderU == 0 && orderV == 0) {
        const Vec3 arm = position(i, j) - heaviest() - from;
        return weight(i, j) * Vec4(parts == Parts::sizes ? glm::abs(arm) : arm, 1);
    }
    if (orderU > 0) {
        const double perU = rate(surface_.knotsU(), firstU_, orderU, i);
        if (orderU == 1 && orderV == 0)
            return perU * neighbours<parts>(i, j, i + 1, j, from);
        return perU * combined(controlPoint<parts>(orderU - 1, orderV, i, j, from),
                               controlPoint<parts>(orderU - 1, orderV, i + 1, j, from));
    }
    const double perV = rate(surface_.knotsV(), firstV_, orderV, j);
    if (orderV == 1)
        return perV * neighbours<parts>(i, j, i, j + 1, from);
    return perV * combined(controlPoint<parts>(0, orderV - 1, i, j, from),
                           controlPoint<parts>(0, orderV - 1, i, j + 1, from));
}

template <LocalNet::Parts parts>
Vec4 LocalNet::total(int orderU, int orderV, const Vec3& from) const
{
    Vec4 result{0};
    for (int i = 0; i <= degreeU() - orderU; ++i) {
        Vec4 row{0};
        for (int j = 0; j <= degreeV() - orderV; ++j) {
            const double part = basisV_[static_cast<size_t>(orderV)][static_cast<size_t>(j)];
            if (part != 0)  // what counts for nothing may be beyond all bounds
                row += part * controlPoint<parts>(orderU, orderV, i, j, from);
        }
        result += basisU_[static_cast<size_t>(orderU)][static_cast<size_t>(i)] * row;
    }
    return result;
}

Vec4 LocalNet::sum(int orderU, int orderV, const Vec3& from) const
{
    return total<Parts::signed_>(orderU, orderV, from);
}

Vec4 LocalNet::sumOfSizes(int orderU, int orderV, const Vec3& from) const
{
    return total<Parts::sizes>(orderU, orderV, from);
}

}  // namespace knotspan
