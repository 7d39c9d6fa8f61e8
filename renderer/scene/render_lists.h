// The smaller lists that a frame chooses from: shadings and sampling rules, with the names the command line
// uses.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knotspan {

enum class Shading : int { shaded, normals, ksquads };

struct ShadingInfo {
    Shading id;
    std::string name;
    std::string description;
};
[[nodiscard]] const std::vector<ShadingInfo>& shadings();
[[nodiscard]] std::optional<Shading> findShading(std::string_view name);

// How many KSDice a KSQuad gets.
struct SamplingRule {
    enum class Kind { pathDefault, area, fixed };
    Kind kind = Kind::pathDefault;
    int count = 0;  // fixed: KSDice along each side, 1 .. 64

    [[nodiscard]] bool operator==(const SamplingRule&) const = default;
};
// "area" or "fixed:N"; nothing for anything else.
[[nodiscard]] std::optional<SamplingRule> parseSamplingRule(std::string_view text);
[[nodiscard]] std::string name(SamplingRule rule);

}  // namespace knotspan
