#include "model/analysis/net_on_screen.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "model/core/check.h"

namespace knotspan {

namespace {

struct FlatBox {
    Vec2 low{std::numeric_limits<double>::infinity()};
    Vec2 high{-std::numeric_limits<double>::infinity()};

    void add(const Vec2& point)
    {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

// Whether all points lie beyond one side of the picture. Linear in homogeneous space, so it holds for the
// hull, whatever the sign of w.
bool beyondOneSide(const BezierNet& net, const ScreenView& view)
{
    bool left = true;
    bool right = true;
    bool above = true;
    bool below = true;
    for (const Vec4& point : net.points) {
        left = left && point.x < view.low.x * point.w;
        right = right && point.x > view.high.x * point.w;
        above = above && point.y < view.low.y * point.w;
        below = below && point.y > view.high.y * point.w;
    }
    return left || right || above || below;
}

}  // namespace

Disc Disc::around(const std::vector<Vec2>& points)
{
    FlatBox box;
    for (const Vec2& point : points)
        box.add(point);
    return ofBox(box.low, box.high);
}

Disc Disc::ofBox(const Vec2& low, const Vec2& high)
{
    return {low + 0.5 * (high - low), 0.5 * glm::length(high - low)};
}

double Disc::doubt(const Vec4& d) const
{
    return d.w == 0 ? 0 : radius * std::abs(d.w);
}

double Disc::largestSeen(const Vec4& d) const
{
    return glm::length(seen(d)) + doubt(d);
}

NetOnScreen::NetOnScreen(const BezierNet& net, const ScreenView& view)
{
    bool allBehind = true;
    double depth = std::numeric_limits<double>::infinity();
    nearest = depth;
    for (const Vec4& point : net.points) {
        const bool front = point.z <= point.w && point.w > 0;
        inFront = inFront && front;
        allBehind = allBehind && point.z > point.w;
        nearest = std::min(nearest, point.w);
        farthest = std::max(farthest, point.w);
        depth = std::min(depth, point.z);
    }
    visible = !allBehind && !beyondOneSide(net, view);
    if (!visible)
        return;
    if (!inFront) {
        // What shows has w >= z, and the picture limits where.
        nearest = std::max(depth, nearest);
        disc = Disc::ofBox(view.low, view.high);
        return;
    }
    FlatBox box;
    for (const Vec4& point : net.points)
        box.add(Vec2(point) / point.w);
    whole =
        glm::all(glm::lessThanEqual(view.low, box.low)) && glm::all(glm::lessThanEqual(box.high, view.high));
    disc = Disc::ofBox(glm::max(box.low, view.low), glm::min(box.high, view.high));
}

std::vector<Vec4> secondDerivatives(const BezierNet& net, int orderU, int orderV)
{
    check(orderU + orderV == 2, "a second derivative is along u twice, v twice or both");
    const int p = net.degreeU;
    const int q = net.degreeV;
    std::vector<Vec4> result;
    if (p < orderU || q < orderV)
        return result;
    result.reserve(static_cast<size_t>((p + 1 - orderU) * (q + 1 - orderV)));
    for (int i = 0; i <= p - orderU; ++i)
        for (int j = 0; j <= q - orderV; ++j) {
            const Vec4& at = net.at(i, j);
            // Outer terms first, so that a curve read backwards gives the same bits.
            if (orderU == 2)
                result.push_back(double(p * (p - 1)) * ((at + net.at(i + 2, j)) - 2.0 * net.at(i + 1, j)));
            else if (orderV == 2)
                result.push_back(double(q * (q - 1)) * ((at + net.at(i, j + 2)) - 2.0 * net.at(i, j + 1)));
            else
                result.push_back(double(p * q) *
                                 ((at + net.at(i + 1, j + 1)) - (net.at(i + 1, j) + net.at(i, j + 1))));
        }
    return result;
}

}  // namespace knotspan
