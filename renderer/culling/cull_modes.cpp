#include "renderer/culling/cull_modes.h"

namespace knotspan {

const std::vector<CullMode>& cullModes()
{
#define KNOTSPAN_ROW(bit, name, function, conservative, byDefault, colour, sentence) \
    {#name, sentence, conservative, byDefault, colour},
    static const std::vector<CullMode> modes = {KNOTSPAN_CULL_LIST(KNOTSPAN_ROW)};
#undef KNOTSPAN_ROW
    return modes;
}

#define KNOTSPAN_ONE(...) +1
static_assert(KNOTSPAN_CULL_LIST(KNOTSPAN_ONE) == KNOTSPAN_CULL_MODE_COUNT, "the count goes with the list");
#undef KNOTSPAN_ONE

std::optional<CullSet> parseCullSet(std::string_view text)
{
    CullSet set;
    if (text == "none")
        return set;
    while (true) {
        const size_t comma = text.find(',');
        const std::string_view word = text.substr(0, comma);
        int mode = 0;
        while (mode < kCullModeCount && cullModes()[static_cast<size_t>(mode)].name != word)
            ++mode;
        if (mode == kCullModeCount)
            return std::nullopt;
        set.set(mode, true);
        if (comma == std::string_view::npos)
            return set;
        text.remove_prefix(comma + 1);
    }
}

CullSet defaultCulling()
{
    CullSet set;
    for (int mode = 0; mode < kCullModeCount; ++mode)
        set.set(mode, cullModes()[static_cast<size_t>(mode)].byDefault);
    return set;
}

std::vector<std::string> names(CullSet set)
{
    std::vector<std::string> result;
    for (int mode = 0; mode < kCullModeCount; ++mode)
        if (set.has(mode))
            result.push_back(cullModes()[static_cast<size_t>(mode)].name);
    if (result.empty())
        result.emplace_back("none");
    return result;
}

}  // namespace knotspan
