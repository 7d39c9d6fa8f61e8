#include "renderer/scene/resident_changes.h"

#include <atomic>

namespace knotspan {

namespace {

constexpr size_t kMost = 1 << 16;  // then those who are that far behind compare all

}  // namespace

void ResidentChanges::restart()
{
    static std::atomic<Moment> next{1};
    start_ = next.fetch_add(2 * kMost);
    changed_.clear();
}

void ResidentChanges::add(std::uint32_t resident)
{
    if (changed_.size() == kMost)
        restart();
    changed_.push_back(resident);
}

std::optional<std::span<const std::uint32_t>> ResidentChanges::since(Moment moment) const
{
    if (moment < start_ || moment > now())
        return std::nullopt;
    return std::span(changed_).subspan(static_cast<size_t>(moment - start_));
}

}  // namespace knotspan
