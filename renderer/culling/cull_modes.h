// The culling modes as C++ sees them: made from shaders/shared/cull_list.h, so that a new mode appears in the
// command line, the window and the statistics by its one line there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shaders/shared/cull_list.h"

namespace knotspan {

struct CullMode {
    std::string name;         // "lqc"
    std::string description;  // a sentence for a tooltip
    bool conservative;        // never drops what shows
    bool byDefault;           // on unless asked otherwise
    std::uint32_t colour;     // sRGB as 0xrrggbb: what it drops is outlined in it
};

constexpr int kCullModeCount = KNOTSPAN_CULL_MODE_COUNT;

// In the order of the list; the index of a mode is its bit in CullSet.
[[nodiscard]] const std::vector<CullMode>& cullModes();

// Which modes are on. No mode on is what the command line calls "none".
struct CullSet {
    std::uint32_t bits = 0;

    [[nodiscard]] bool has(int mode) const { return (bits >> mode & 1U) != 0; }
    void set(int mode, bool on) { bits = on ? bits | 1U << mode : bits & ~(1U << mode); }
    [[nodiscard]] bool operator==(const CullSet&) const = default;
};

// "none", or names joined by commas; nothing where a name is unknown.
[[nodiscard]] std::optional<CullSet> parseCullSet(std::string_view text);
// Those that are on unless asked otherwise.
[[nodiscard]] CullSet defaultCulling();
[[nodiscard]] std::vector<std::string> names(CullSet set);  // {"none"} for the empty set

}  // namespace knotspan
