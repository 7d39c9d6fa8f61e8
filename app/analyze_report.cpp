#include "app/analyze_report.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace knotspan::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kVerdicts{Continuity::none, Continuity::g0, Continuity::g1, Continuity::g2,
                               Continuity::undetermined};

template <class... Values>
std::string printed(const char* format, Values... values)
{
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

size_t countOf(const AnalyzeReport& report, Continuity verdict)
{
    const auto& edges = report.friends.edges();
    return static_cast<size_t>(std::count_if(
        edges.begin(), edges.end(), [&](const FriendEdge& edge) { return edge.continuity == verdict; }));
}

std::string counted(size_t count, const char* one, const char* many)
{
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

// One line whatever is in the name.
std::string surfaceText(const AnalyzeReport& report, std::uint32_t surface)
{
    std::string name = report.friends.object(surface)->name;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return std::to_string(report.numbers[surface]) + (name.empty() ? "" : " " + name);
}

std::string textOf(const AnalyzeReport& report, const EdgePart& part)
{
    return surfaceText(report, part.surface) + ": " + edgeName(part) +
           printed(" [%.6g, %.6g]", part.from, part.to);
}

std::string rowText(const AnalyzeReport& report, size_t number)
{
    const FriendEdge& edge = report.friends.edges()[number];
    const bool met = report.requirement.isMetBy(edge, report.friends.tolerances());
    const Vec3& worst = edge.worstPoint;
    const std::string bend = edge.areFriends() ? printed("%.3g", edge.curvatureMax) : "-";
    return printed("%-6s  %-12s  %9.3g  %8.3g  %8.3g  %9s  %-32s  ", met ? "" : "misses",
                   continuityName(edge.continuity), edge.gapMax, edge.angleMaxDeg, edge.angleBoundDeg,
                   bend.c_str(), printed("(%.5g, %.5g, %.5g)", worst.x, worst.y, worst.z).c_str()) +
           textOf(report, edge.a) + "  |  " + textOf(report, edge.b) + '\n';
}

std::string headText()
{
    constexpr const char* kColumns = "%-6s  %-12s  %9s  %8s  %8s  %9s  %-32s  %s\n";
    return printed(kColumns, "", "", "largest", "largest", "at most", "curvature", "", "") +
           printed(kColumns, "", "verdict", "gap", "angle", "", "differs", "worst at", "edges");
}

// Text of the rows there is room for.
template <class RowText>
std::string rowsText(size_t count, size_t rows, const RowText& rowText)
{
    const size_t shown = rows == 0 ? count : std::min(count, rows);
    std::string text;
    for (size_t k = 0; k < shown; ++k)
        text += rowText(k);
    if (shown < count)
        text += "... and " + std::to_string(count - shown) + " more\n";
    return text;
}

std::string edgesText(const AnalyzeReport& report, size_t rows)
{
    const auto& edges = report.friends.edges();
    if (edges.empty())
        return {};
    std::vector<size_t> order(edges.size());
    for (size_t k = 0; k < order.size(); ++k)
        order[k] = k;
    std::stable_partition(order.begin(), order.end(), [&](size_t k) {
        return !report.requirement.isMetBy(edges[k], report.friends.tolerances());
    });
    return headText() + rowsText(order.size(), rows, [&](size_t k) { return rowText(report, order[k]); }) +
           '\n';
}

std::string nakedText(const AnalyzeReport& report, size_t rows)
{
    const auto& naked = report.friends.nakedEdges();
    if (naked.empty())
        return {};
    const std::string head =
        report.requirement.closed ? "naked edges, none of which may be\n" : "naked edges\n";
    return head +
           rowsText(naked.size(), rows, [&](size_t k) { return "  " + textOf(report, naked[k]) + '\n'; }) +
           '\n';
}

std::string creasesText(const AnalyzeReport& report, size_t rows)
{
    if (report.creases.empty())
        return {};
    const auto rowText = [&](size_t k) {
        const auto& [surface, crease] = report.creases[k];
        return "  " + surfaceText(report, surface) +
               printed(": %s = %.6g, %.3g degrees\n", crease.across == Direction::U ? "u" : "v",
                       crease.parameter, crease.angleMaxDeg);
    };
    return "creases inside surfaces\n" + rowsText(report.creases.size(), rows, rowText) + '\n';
}

std::string summaryText(const AnalyzeReport& report)
{
    std::string verdicts;
    for (const Continuity verdict : kVerdicts)
        if (const size_t count = countOf(report, verdict); count > 0)
            verdicts +=
                (verdicts.empty() ? " (" : ", ") + std::to_string(count) + ' ' + continuityName(verdict);
    verdicts += verdicts.empty() ? "" : ")";
    const FriendTolerances& tolerances = report.friends.tolerances();
    const size_t missing = report.misses().size();
    std::string text = report.file + ": " + counted(report.friends.edges().size(), "edge", "edges") +
                       verdicts + " where surfaces meet, " +
                       counted(report.friends.nakedEdges().size(), "naked edge", "naked edges") + ". " +
                       continuityName(report.requirement.continuity) +
                       printed(" within a gap of %g ", tolerances.gap) + report.units +
                       printed(" and an angle of %g degrees: ", tolerances.angleDeg);
    if (report.saysNothing())
        return text + "no edge is long enough to judge; give a smaller --gap.\n";
    text += missing == 0 ? "no edge misses" : counted(missing, "edge misses", "edges miss");
    if (missing == 0 && !report.passes())
        text += ", but naked edges are not allowed";
    return text + ".\n";
}

Json jsonOf(const AnalyzeReport& report, const EdgePart& part)
{
    return {{"surface", report.numbers[part.surface]}, {"side", edgeName(part)}};
}

Json jsonOf(const AnalyzeReport& report, const FriendEdge& edge)
{
    return {{"a", jsonOf(report, edge.a)},
            {"b", jsonOf(report, edge.b)},
            {"range", {edge.a.from, edge.a.to}},
            {"gap_max", edge.gapMax},
            {"angle_max_deg", edge.angleMaxDeg},
            {"angle_bound_deg", edge.angleBoundDeg},
            {"curvature_max", edge.areFriends() ? Json(edge.curvatureMax) : Json(nullptr)},
            {"continuity", continuityName(edge.continuity)},
            {"friends", edge.areFriends()}};
}

Json summaryJson(const AnalyzeReport& report)
{
    Json verdicts = Json::object();
    for (const Continuity verdict : kVerdicts)
        verdicts[continuityName(verdict)] = countOf(report, verdict);
    Json misses = Json::array();
    for (const size_t number : report.misses()) {
        const FriendEdge& edge = report.friends.edges()[number];
        const Vec3& at = edge.worstPoint;
        misses.push_back({{"edge", number}, {"parameter", edge.worst}, {"point", {at.x, at.y, at.z}}});
    }
    return {{"edges", report.friends.edges().size()},
            {"continuity", std::move(verdicts)},
            {"naked_edges", report.friends.nakedEdges().size()},
            {"short_edges", report.friends.shortEdges().size()},
            {"units", report.units},
            {"gap", report.friends.tolerances().gap},
            {"angle_deg", report.friends.tolerances().angleDeg},
            {"require", continuityName(report.requirement.continuity)},
            {"closed", report.requirement.closed},
            {"misses", std::move(misses)},
            {"passes", report.passes()}};
}

}  // namespace

bool Requirement::isMetBy(const FriendEdge& edge, const FriendTolerances& tolerances) const
{
    if (edge.continuity == Continuity::undetermined)
        return continuity == Continuity::g0 && edge.gapMax <= tolerances.gap;
    return edge.continuity >= continuity;
}

std::vector<size_t> AnalyzeReport::misses() const
{
    std::vector<size_t> result;
    for (size_t k = 0; k < friends.edges().size(); ++k)
        if (!requirement.isMetBy(friends.edges()[k], friends.tolerances()))
            result.push_back(k);
    return result;
}

bool AnalyzeReport::saysNothing() const
{
    return friends.edges().empty() && friends.nakedEdges().empty() && !friends.shortEdges().empty();
}

bool AnalyzeReport::passes() const
{
    return misses().empty() && !saysNothing() && !(requirement.closed && !friends.nakedEdges().empty());
}

AnalyzeReport analyzed(const Scene& scene, const FriendTolerances& tolerances, const Requirement& requirement)
{
    AnalyzeReport report{{}, scene.units(), {}, SceneFriends(tolerances), requirement};
    report.friends.follow(scene);
    for (std::uint32_t k = 0; k < report.friends.objects().size(); ++k)
        for (const Crease& crease : creasesOf(placed(*report.friends.object(k)), tolerances))
            report.creases.push_back({k, crease});
    size_t number = 0;
    for (const auto& [id, object] : scene.objects()) {
        if (object->visible)
            report.numbers.push_back(number);
        ++number;
    }
    return report;
}

std::string tableOf(const AnalyzeReport& report, size_t rows)
{
    return edgesText(report, rows) + nakedText(report, rows) + creasesText(report, rows) +
           summaryText(report);
}

nlohmann::ordered_json jsonOf(const AnalyzeReport& report)
{
    Json edges = Json::array();
    for (const FriendEdge& edge : report.friends.edges())
        edges.push_back(jsonOf(report, edge));
    Json naked = Json::array();
    for (const EdgePart& part : report.friends.nakedEdges()) {
        Json json = jsonOf(report, part);
        json["range"] = {part.from, part.to};
        naked.push_back(std::move(json));
    }
    Json creases = Json::array();
    for (const auto& [surface, crease] : report.creases)
        creases.push_back({{"surface", report.numbers[surface]},
                           {"direction", crease.across == Direction::U ? "u" : "v"},
                           {"parameter", crease.parameter},
                           {"angle_max_deg", crease.angleMaxDeg}});
    return {{"edges", std::move(edges)},
            {"naked_edges", std::move(naked)},
            {"creases", std::move(creases)},
            {"summary", summaryJson(report)}};
}

}  // namespace knotspan::app
