// The smaller lists that a frame chooses from: shadings and sampling rules, with the names the command line
// uses.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knotspan {

// Numbered as SHADING_... of shaders/shared/layouts.h.
enum class Shading : int {
    shaded,
    normals,
    ksquads,
    error,
    zebra,
    reflection,
    isophotes,
    matcap,
    curvature,
    draft,
    checker,
    deviation
};

struct ShadingInfo {
    Shading id;
    std::string name;
    std::string description;
};
[[nodiscard]] const std::vector<ShadingInfo>& shadings();
[[nodiscard]] std::optional<Shading> findShading(std::string_view name);

// How many KSDice a KSQuad gets.
struct SamplingRule {
    enum class Kind { pathDefault, bound, area, areaNoFriends, edge, fixed };
    Kind kind = Kind::pathDefault;
    int count = 0;  // fixed: KSDice along each side, 1 .. 64

    [[nodiscard]] bool operator==(const SamplingRule&) const = default;
};

// The rules to choose from: all kinds but pathDefault.
struct SamplingRuleInfo {
    SamplingRule::Kind kind;
    std::string name;  // "bound"; of `fixed` without its number
    std::string description;
};
[[nodiscard]] const std::vector<SamplingRuleInfo>& samplingRules();
// A name of the list, "fixed" as "fixed:N"; nothing for anything else.
[[nodiscard]] std::optional<SamplingRule> parseSamplingRule(std::string_view text);
[[nodiscard]] std::string name(SamplingRule rule);

}  // namespace knotspan
