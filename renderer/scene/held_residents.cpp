#include "renderer/scene/held_residents.h"

namespace knotspan {

HeldResidents::Difference HeldResidents::take(const std::vector<Resident>& residents)
{
    Difference difference{.anew = held_.size() != residents.size(), .changes = {}};
    for (size_t k = 0; k < residents.size() && !difference.anew; ++k) {
        difference.anew = !isSameShape(held_[k]->surface, residents[k].object->surface);
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

}  // namespace knotspan
