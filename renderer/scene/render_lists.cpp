#include "renderer/scene/render_lists.h"

#include <charconv>

namespace knotspan {

const std::vector<ShadingInfo>& shadings()
{
    static const std::vector<ShadingInfo> list = {
        {Shading::shaded, "shaded", "Lit by lamps that go with the camera"},
        {Shading::normals, "normals", "The surface normal as a colour"},
        {Shading::ksquads, "ksquads", "Each KSQuad in a colour of its own"}};
    return list;
}

std::optional<Shading> findShading(std::string_view name)
{
    for (const ShadingInfo& shading : shadings())
        if (shading.name == name)
            return shading.id;
    return std::nullopt;
}

std::optional<SamplingRule> parseSamplingRule(std::string_view text)
{
    if (text == "area")
        return SamplingRule{SamplingRule::Kind::area, 0};
    constexpr std::string_view kFixed = "fixed:";
    if (!text.starts_with(kFixed))
        return std::nullopt;
    text.remove_prefix(kFixed.size());
    int count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || count < 1 || count > 64)
        return std::nullopt;
    return SamplingRule{SamplingRule::Kind::fixed, count};
}

std::string name(SamplingRule rule)
{
    switch (rule.kind) {
    case SamplingRule::Kind::area:
        return "area";
    case SamplingRule::Kind::fixed:
        return "fixed:" + std::to_string(rule.count);
    default:
        return "default";
    }
}

}  // namespace knotspan
