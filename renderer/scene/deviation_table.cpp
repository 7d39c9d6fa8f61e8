#include "renderer/scene/deviation_table.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "model/geometry/ksquad.h"

namespace knotspan {

namespace {

double largestOf(const SharedSurfaceNumbers& numbers)
{
    float largest = 0;
    if (numbers)
        for (const auto& [id, of] : *numbers)
            for (const float value : of.values)
                largest = std::max(largest, value);
    return largest;
}

}  // namespace

bool DeviationTable::follow(const std::vector<Resident>& residents, const SharedSurfaceNumbers& numbers,
                            const ResidentChanges* log)
{
    const bool others = held_.take(residents, log).anew || !isHeld_;
    if (!others && numbers == numbers_)
        return false;
    if (numbers != numbers_ || !isHeld_) {
        const double largest = largestOf(numbers);
        range_ = {0, largest > 0 ? largest : 1};
    }
    isHeld_ = true;
    numbers_ = numbers;
    size_t ksquads = 0;
    for (const Resident& resident : residents)
        ksquads += ksQuadCount(resident.object->surface);
    words_.assign(ksquads, 0);
    if (!numbers_)
        return true;
    for (const Resident& resident : residents) {
        const auto found = numbers_->find(resident.id);
        const size_t count = ksQuadCount(resident.object->surface);
        if (found == numbers_->end() || found->second.cells.size() != count)
            continue;
        const GridNumbers& of = found->second;
        for (size_t k = 0; k < count; ++k) {
            words_[resident.firstKsquad + k] = static_cast<std::uint32_t>(words_.size());
            words_.push_back(of.cells[k]);
            const size_t values = size_t{of.cells[k] + 1} * (of.cells[k] + 1);
            for (size_t value = of.first[k]; value < of.first[k] + values; ++value)
                words_.push_back(std::bit_cast<std::uint32_t>(of.values[value]));
        }
    }
    return true;
}

}  // namespace knotspan
