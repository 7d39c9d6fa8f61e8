#include "model/sculpting/nearest_points.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace knotspan {

namespace {

std::uint8_t longestAxis(const Vec3& size)
{
    if (size.x >= size.y && size.x >= size.z)
        return 0;
    return size.y >= size.z ? 1 : 2;
}

}  // namespace

NearestPoints::NearestPoints(const std::vector<Vec3>& points) : axes_(points.size(), 0)
{
    entries_.reserve(points.size());
    for (size_t index = 0; index < points.size(); ++index) {
        entries_.push_back({points[index], index});
        bounds_.add(points[index]);
    }
    arrange(0, entries_.size());
}

void NearestPoints::arrange(size_t first, size_t last)
{
    if (last - first < 2)
        return;
    Box box;
    for (size_t k = first; k < last; ++k)
        box.add(entries_[k].position);
    const std::uint8_t axis = longestAxis(box.size());
    const size_t middle = first + (last - first) / 2;
    const auto at = [&](size_t k) { return entries_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(first), at(middle), at(last), [&](const Entry& a, const Entry& b) {
        return a.position[axis] != b.position[axis] ? a.position[axis] < b.position[axis] : a.index < b.index;
    });
    axes_[middle] = axis;
    arrange(first, middle);
    arrange(middle + 1, last);
}

NearestPoints::Part NearestPoints::whole(const Vec3& place) const
{
    const Vec3 inside = glm::clamp(place, bounds_.low, bounds_.high);
    return {0, entries_.size(), place - inside};
}

// Arya and Mount: a part further along one axis is at least as far as the place lies outside it along all.
template <class Visit>
void NearestPoints::visitNear(const Vec3& place, const Part& part, const double& reachSquared,
                              const Visit& visit) const
{
    // A little more, as rounding must not hide a point that is as near as the nearest.
    constexpr double kRounding = 1 + 1e-12;
    if (part.first >= part.last || glm::dot(part.outside, part.outside) > reachSquared * kRounding)
        return;
    const size_t middle = part.first + (part.last - part.first) / 2;
    const Entry& entry = entries_[middle];
    const Vec3 away = place - entry.position;
    visit(entry, glm::dot(away, away));
    const int axis = axes_[middle];
    const bool above = away[axis] >= 0;
    Part lower{part.first, middle, part.outside};
    Part upper{middle + 1, part.last, part.outside};
    Part& far = above ? lower : upper;
    far.outside[axis] = std::max(std::abs(far.outside[axis]), std::abs(away[axis]));
    visitNear(place, above ? upper : lower, reachSquared, visit);
    visitNear(place, far, reachSquared, visit);
}

std::optional<NearestPoints::Found> NearestPoints::nearest(const Vec3& place, double reach) const
{
    std::optional<Found> found;
    double nearestSquared = reach * reach;
    visitNear(place, whole(place), nearestSquared, [&](const Entry& entry, double squared) {
        if (squared > nearestSquared || (found && squared == nearestSquared && entry.index > found->index))
            return;
        nearestSquared = squared;
        found = Found{entry.index, 0};
    });
    if (found)
        found->distance = std::sqrt(nearestSquared);
    return found;
}

std::vector<size_t> NearestPoints::within(const Vec3& place, double reach) const
{
    std::vector<size_t> found;
    const double reachSquared = reach * reach;
    visitNear(place, whole(place), reachSquared, [&](const Entry& entry, double squared) {
        if (squared <= reachSquared)
            found.push_back(entry.index);
    });
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace knotspan
