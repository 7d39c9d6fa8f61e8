#include "renderer/scene/held_residents.h"

#include <utility>

namespace knotspan {

HeldResidents::Difference HeldResidents::take(const std::vector<Resident>& residents,
                                              const ResidentChanges* log)
{
    const auto moment = std::exchange(seen_, log != nullptr ? log->now() : 0);
    if (const auto changed = log != nullptr ? log->since(moment) : std::nullopt)
        return takeLogged(residents, *changed);
    Difference difference{.anew = held_.size() != residents.size(), .changes = {}};
    for (size_t k = 0; k < residents.size() && !difference.anew; ++k) {
        difference.anew = !isSameShape(*held_[k], *residents[k].object);
        if (held_[k] != residents[k].object)
            difference.changes.push_back(
                {static_cast<std::uint32_t>(k), placedSurface(*residents[k].object)});
    }
    if (difference.isEmpty())
        return difference;
    held_.clear();
    for (const Resident& resident : residents)
        held_.push_back(resident.object);
    return difference;
}

HeldResidents::Difference HeldResidents::takeLogged(const std::vector<Resident>& residents,
                                                    std::span<const std::uint32_t> changed)
{
    Difference difference;
    for (const std::uint32_t k : changed)
        if (held_[k] != residents[k].object) {
            held_[k] = residents[k].object;
            difference.changes.push_back({k, placedSurface(*held_[k])});
        }
    return difference;
}

}  // namespace knotspan
