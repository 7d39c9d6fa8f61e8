#include "model/matching/site_network.h"

#include <algorithm>
#include <numeric>

#include "model/matching/row_relation.h"
#include "model/matching/shaping_points.h"

namespace knotspan {

// Both sides of an edge, their points numbered.
struct SiteNetwork::Sides {
    EdgeRows rows;
    int firstA;
    int firstB;

    [[nodiscard]] int pointA(int row, int k) const { return firstA + rows.a.index(row, k); }
    [[nodiscard]] int pointB(int row, int k) const { return firstB + rows.b.index(row, k); }
};

namespace {

Role roleOf(const NurbsSurface& surface, int i, int j)
{
    const bool borderU = i == 0 || i == surface.countU() - 1;
    const bool borderV = j == 0 || j == surface.countV() - 1;
    if (borderU && borderV)
        return Role::corner;
    return borderU || borderV ? Role::edge : Role::inner;
}

bool isTrimmed(const FriendEdge& edge)
{
    return edge.a.trim || edge.b.trim;
}

}  // namespace

std::string SiteNetwork::sentenceStart(const FriendEdge& edge) const
{
    if (names_.empty())
        return "The edge between surfaces " + std::to_string(edge.a.surface) + " and " +
               std::to_string(edge.b.surface) + " cannot follow: ";
    if (edge.a.surface == edge.b.surface)
        return "The seam of " + names_[edge.a.surface] + " cannot follow: ";
    return "The edge between " + names_[edge.a.surface] + " and " + names_[edge.b.surface] +
           " cannot follow: ";
}

SiteNetwork::SiteNetwork(const std::vector<PlacedSurface>& surfaces, const std::vector<FriendEdge>& edges,
                         double gap, std::vector<std::string> names)
    : gap_(gap),
      names_(std::move(names))
{
    number(surfaces);
    std::vector<std::pair<int, int>> touched;
    for (size_t number = 0; number < edges.size(); ++number)
        if (isTrimmed(edges[number]) && edges[number].continuity != Continuity::none)
            for (const int point : holdTrimmed(edges[number], surfaces))
                if (edges[number].areFriends())
                    touched.emplace_back(point, static_cast<int>(number));
    const auto sidesOf = [&](const FriendEdge& edge) {
        return Sides{EdgeRows(edge, surfaces[edge.a.surface], surfaces[edge.b.surface]),
                     firstPoint(edge.a.surface), firstPoint(edge.b.surface)};
    };
    for (const FriendEdge& edge : edges)
        if (edge.continuity != Continuity::none && !isTrimmed(edge))
            close(edge, sidesOf(edge));
    for (size_t point = 0; point < sites_.size(); ++point)
        sites_[point] = root(static_cast<int>(point));
    for (size_t number = 0; number < edges.size(); ++number)
        if (edges[number].areFriends() && !isTrimmed(edges[number])) {
            const Sides sides = sidesOf(edges[number]);
            relate(edges[number], sides);
            for (const int row : {0, 1}) {
                for (int k = 0; k < sides.rows.a.length(); ++k)
                    touched.emplace_back(sides.pointA(row, k), static_cast<int>(number));
                for (int k = 0; k < sides.rows.b.length(); ++k)
                    touched.emplace_back(sides.pointB(row, k), static_cast<int>(number));
            }
        }
    edgesOf_ = NumberLists(sites_.size(), touched);
    index();
}

void SiteNetwork::number(const std::vector<PlacedSurface>& surfaces)
{
    int first = 0;
    for (const PlacedSurface& placed : surfaces) {
        firstPoints_.push_back(first);
        for (int i = 0; i < placed.surface->countU(); ++i)
            for (int j = 0; j < placed.surface->countV(); ++j)
                roles_.push_back(roleOf(*placed.surface, i, j));
        first += placed.surface->countU() * placed.surface->countV();
    }
    sites_.resize(roles_.size());
    std::iota(sites_.begin(), sites_.end(), 0);
    held_.assign(roles_.size(), -1);
}

std::uint32_t SiteNetwork::surfaceOf(int point) const
{
    const auto next = std::upper_bound(firstPoints_.begin(), firstPoints_.end(), point);
    return static_cast<std::uint32_t>(next - firstPoints_.begin()) - 1;
}

int SiteNetwork::root(int point)
{
    int& above = sites_[static_cast<size_t>(point)];
    if (above != point)
        above = root(above);
    return above;
}

// Points of the two edges become one site each.
void SiteNetwork::close(const FriendEdge& edge, const Sides& sides)
{
    if (const auto same = requireSameRows(edge, sides.rows, gap_); !same) {
        hold(edge, sides, 1, same.error().what);
        return;
    }
    for (int k = 0; k < sides.rows.a.length(); ++k)
        sites_[static_cast<size_t>(root(sides.pointB(0, sides.rows.alongB(k))))] = root(sides.pointA(0, k));
}

void SiteNetwork::relate(const FriendEdge& edge, const Sides& sides)
{
    if (const auto same = requireSameRows(edge, sides.rows, gap_); !same) {
        hold(edge, sides, 2, same.error().what);
        return;
    }
    const auto relation = rowRelation(sides.rows);
    if (!relation) {
        hold(edge, sides, 2, relation.error().what);
        return;
    }
    for (int k = 0; k < sides.rows.a.length(); ++k) {
        const int there = sides.rows.alongB(k);
        conditions_.push_back({{{site(sides.pointB(1, there)), sides.rows.b.at(1, there).weight},
                                {site(sides.pointA(0, k)), -relation->ofEdge * sides.rows.a.at(0, k).weight},
                                {site(sides.pointA(1, k)), -relation->ofRow * sides.rows.a.at(1, k).weight}},
                               Vec3(0)});
    }
}

void SiteNetwork::hold(const FriendEdge& edge, const Sides& sides, int rows, const std::string& why)
{
    const int reason = static_cast<int>(reasons_.size());
    reasons_.push_back(sentenceStart(edge) + why);
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k < sides.rows.a.length(); ++k)
            held_[static_cast<size_t>(sides.pointA(row, k))] = reason;
        for (int k = 0; k < sides.rows.b.length(); ++k)
            held_[static_cast<size_t>(sides.pointB(row, k))] = reason;
    }
}

std::vector<int> SiteNetwork::holdTrimmed(const FriendEdge& edge, const std::vector<PlacedSurface>& surfaces)
{
    const int reason = static_cast<int>(reasons_.size());
    reasons_.push_back(sentenceStart(edge) + "it is cut out by a trim curve");
    std::vector<int> points;
    for (const EdgePart& part : {edge.a, edge.b})
        for (const int point : shapingPoints(surfaces[part.surface], part))
            points.push_back(firstPoint(part.surface) + point);
    for (const int point : points)
        held_[static_cast<size_t>(point)] = reason;
    return points;
}

void SiteNetwork::index()
{
    std::vector<std::pair<int, int>> points;
    for (size_t point = 0; point < sites_.size(); ++point) {
        const auto site = static_cast<size_t>(sites_[point]);
        points.emplace_back(sites_[point], static_cast<int>(point));
        roles_[site] = std::max(roles_[site], roles_[point]);
        held_[site] = std::max(held_[site], held_[point]);
    }
    points_ = NumberLists(sites_.size(), points);
    std::vector<std::pair<int, int>> conditions;
    for (size_t number = 0; number < conditions_.size(); ++number)
        for (const auto& term : conditions_[number].terms)
            conditions.emplace_back(term.first, static_cast<int>(number));
    conditionsOf_ = NumberLists(sites_.size(), conditions);
}

const std::string* SiteNetwork::whyHeld(int site) const
{
    const int reason = held_[static_cast<size_t>(site)];
    return reason < 0 ? nullptr : &reasons_[static_cast<size_t>(reason)];
}

}  // namespace knotspan
