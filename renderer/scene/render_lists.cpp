#include "renderer/scene/render_lists.h"

#include <algorithm>
#include <charconv>

namespace knotspan {

const std::vector<ShadingInfo>& shadings()
{
    static const std::vector<ShadingInfo> list = {
        {Shading::shaded, "shaded", "Lit by lamps that go with the camera"},
        {Shading::zebra, "zebra",
         "Stripes mirrored in the surface: they jump where edges are G0, kink where they are G1"},
        {Shading::reflection, "reflection", "Thin light lines mirrored in the surface"},
        {Shading::isophotes, "isophotes", "Bands where the normal leans equally"},
        {Shading::matcap, "matcap", "A material lit in a studio that turns with the eye"},
        {Shading::curvature, "curvature", "How strongly the surface bends: blue one way, orange the other"},
        {Shading::draft, "draft",
         "How far the surface leans from the direction in which a mould is pulled: blue is undercut"},
        {Shading::checker, "checker",
         "Squares along the parameters, or of one length: how the parameters run"},
        {Shading::deviation, "deviation",
         "How far each point is from what it is compared with: blue not at all, orange the most"},
        {Shading::normals, "normals", "The surface normal as a colour"},
        {Shading::ksquads, "ksquads", "Each KSQuad in a colour of its own"},
        {Shading::error, "error",
         "Each pixel's distance from the exact surface: dark blue none, pale yellow the tolerance, magenta "
         "beyond it"}};
    return list;
}

std::optional<Shading> findShading(std::string_view name)
{
    for (const ShadingInfo& shading : shadings())
        if (shading.name == name)
            return shading.id;
    return std::nullopt;
}

const std::vector<SamplingRuleInfo>& samplingRules()
{
    static const std::vector<SamplingRuleInfo> list = {
        {SamplingRule::Kind::bound, "bound", "As few as keep every pixel within the tolerance"},
        {SamplingRule::Kind::area, "area", "By the area that a KSQuad covers on the screen"},
        {SamplingRule::Kind::areaNoFriends, "area-no-friends",
         "As area, with twice as many along the borders that surfaces share"},
        {SamplingRule::Kind::edge, "edge", "By the length of a KSQuad's edges on the screen"},
        {SamplingRule::Kind::fixed, "fixed", "The same number along each side of every KSQuad"}};
    return list;
}

std::optional<SamplingRule> parseSamplingRule(std::string_view text)
{
    const size_t colon = std::min(text.find(':'), text.size());
    const std::string_view word = text.substr(0, colon);
    for (const SamplingRuleInfo& rule : samplingRules()) {
        if (rule.name != word)
            continue;
        if (rule.kind != SamplingRule::Kind::fixed)
            return colon == text.size() ? std::optional(SamplingRule{rule.kind, 0}) : std::nullopt;
        if (colon == text.size())
            return std::nullopt;
        const std::string_view number = text.substr(colon + 1);
        int count = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), count);
        if (error != std::errc() || end != number.data() + number.size() || count < 1 || count > 64)
            return std::nullopt;
        return SamplingRule{rule.kind, count};
    }
    return std::nullopt;
}

std::string name(SamplingRule rule)
{
    for (const SamplingRuleInfo& info : samplingRules())
        if (info.kind == rule.kind)
            return info.kind == SamplingRule::Kind::fixed ? info.name + ":" + std::to_string(rule.count)
                                                          : info.name;
    return "default";
}

}  // namespace knotspan
