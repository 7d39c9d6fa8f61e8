#include "model/analysis/corner_groups.h"

#include <numeric>

#include <glm/geometric.hpp>

namespace knotspan {

CornerGroups::CornerGroups(std::vector<std::uint32_t> names, const std::vector<CornerPlace>& corners,
                           double widest)
    : names_(std::move(names)),
      places_(corners),
      owner_(corners.size()),
      next_(corners.size()),
      seen_(corners.size(), 0),
      widest_(widest)
{
    std::iota(owner_.begin(), owner_.end(), 0U);
    std::iota(next_.begin(), next_.end(), 0U);
    for (std::uint32_t corner = 0; corner < corners.size(); ++corner)
        grid_.insert(corner, around(corner));
    std::vector<std::uint32_t> touched;
    regroup(std::vector<std::uint32_t>(owner_), touched);
}

Box CornerGroups::around(std::uint32_t corner) const
{
    const Vec3& at = places_[corner].at;
    return {at - Vec3(widest_), at + Vec3(widest_)};
}

std::vector<std::uint32_t> CornerGroups::move(const Moves& moves)
{
    std::vector<std::uint32_t> seeds;
    for (const auto& [corner, place] : moves)
        forGroup(corner, [&](std::uint32_t member) { seeds.push_back(member); });
    for (const auto& [corner, place] : moves) {
        grid_.erase(corner, around(corner));
        places_[corner] = place;
        grid_.insert(corner, around(corner));
    }
    std::vector<std::uint32_t> touched;
    regroup(seeds, touched);
    std::sort(touched.begin(), touched.end());
    return touched;
}

void CornerGroups::regroup(const std::vector<std::uint32_t>& seeds, std::vector<std::uint32_t>& touched)
{
    for (const std::uint32_t seed : seeds) {
        if (seen_[seed] != 0)
            continue;
        const size_t first = touched.size();
        touched.push_back(seed);
        seen_[seed] = 1;
        std::uint32_t owner = seed;
        for (size_t k = first; k < touched.size(); ++k) {
            const std::uint32_t corner = touched[k];
            if (names_[corner] < names_[owner])
                owner = corner;
            grid_.near(places_[corner].at, [&](std::uint32_t other) {
                const double tolerance = std::max(places_[corner].tolerance, places_[other].tolerance);
                if (seen_[other] == 0 && glm::distance(places_[corner].at, places_[other].at) <= tolerance) {
                    seen_[other] = 1;
                    touched.push_back(other);
                }
            });
        }
        for (size_t k = first; k < touched.size(); ++k) {
            owner_[touched[k]] = owner;
            next_[touched[k]] = touched[k + 1 < touched.size() ? k + 1 : first];
        }
    }
    for (const std::uint32_t corner : touched)
        seen_[corner] = 0;
}

}  // namespace knotspan
