// Which residents became other objects, and when: for all who keep something of each of them and follow at
// their own pace, without looking at those that stay.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace knotspan {

class ResidentChanges {
public:
    // A moment; no other residents have the same ones.
    using Moment = std::uint64_t;

    ResidentChanges() { restart(); }

    // Nothing of before holds.
    void restart();
    // Of a resident that is another object, of the same shape.
    void add(std::uint32_t resident);

    [[nodiscard]] Moment now() const { return start_ + changed_.size(); }
    // Those that changed since, perhaps several times each; good until the next change. Nothing: nobody
    // knows; compare all.
    [[nodiscard]] std::optional<std::span<const std::uint32_t>> since(Moment moment) const;

private:
    Moment start_ = 0;
    std::vector<std::uint32_t> changed_;
};

}  // namespace knotspan
