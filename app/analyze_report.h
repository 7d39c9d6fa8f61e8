// How smoothly the surfaces of a model meet, as people and programs read it, and what of that misses.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "model/friends/creases.h"
#include "model/friends/scene_friends.h"

namespace knotspan::app {

// What has to hold for a model to pass.
struct Requirement {
    Continuity continuity = Continuity::g1;  // at every edge that meets another: g0, g1 or g2
    bool closed = false;                     // and no edge may be naked

    // An edge whose verdict is undetermined meets a requirement only where what that asks is certain.
    [[nodiscard]] bool isMetBy(const FriendEdge& edge, const FriendTolerances& tolerances) const;
};

// Inside surface `surface` of the report's friends.
struct InnerCrease {
    std::uint32_t surface = 0;
    Crease crease;
};

struct AnalyzeReport {
    std::string file;  // its name without folders
    std::string units;
    std::vector<size_t> numbers;  // of the surfaces in `friends`, as `info` numbers them
    SceneFriends friends;
    Requirement requirement;
    std::vector<InnerCrease> creases = {};  // they are listed, and do not miss

    [[nodiscard]] std::vector<size_t> misses() const;  // into friends.edges(), increasing
    // Whether the gap tolerance is so large that no edge is left to judge, which is no pass.
    [[nodiscard]] bool saysNothing() const;
    [[nodiscard]] bool passes() const;
};

[[nodiscard]] AnalyzeReport analyzed(const Scene& scene, const FriendTolerances& tolerances,
                                     const Requirement& requirement);

// What misses comes first. No more than `rows` lines of edges, and of naked edges, where that is not 0.
[[nodiscard]] std::string tableOf(const AnalyzeReport& report, size_t rows);
[[nodiscard]] nlohmann::ordered_json jsonOf(const AnalyzeReport& report);

}  // namespace knotspan::app
