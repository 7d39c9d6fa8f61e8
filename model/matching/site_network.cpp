#include "model/matching/site_network.h"

#include <algorithm>
#include <numeric>

#include "model/matching/row_relation.h"

namespace knotspan {

struct SiteNetwork::Sides {
    EdgeRows a;
    EdgeRows b;
    int firstA;
    int firstB;
    Mat4 placeA;
    Mat4 placeB;
    bool reversed;

    [[nodiscard]] int pointA(int row, int k) const { return firstA + a.index(row, k); }
    // Of b's row, seen along a's.
    [[nodiscard]] int alongB(int k) const { return reversed ? b.length() - 1 - k : k; }
    [[nodiscard]] int pointB(int row, int k) const { return firstB + b.index(row, k); }
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
                         std::vector<std::string> names)
    : names_(std::move(names))
{
    number(surfaces);
    const auto sidesOf = [&](const FriendEdge& edge) {
        const PlacedSurface& a = surfaces[edge.a.surface];
        const PlacedSurface& b = surfaces[edge.b.surface];
        return Sides{{*a.surface, edge.a.side},
                     {*b.surface, edge.b.side},
                     firstPoint(edge.a.surface),
                     firstPoint(edge.b.surface),
                     a.transform,
                     b.transform,
                     edge.reversed};
    };
    for (const FriendEdge& edge : edges)
        if (edge.continuity != Continuity::none)
            close(edge, sidesOf(edge));
    for (size_t point = 0; point < sites_.size(); ++point)
        sites_[point] = root(static_cast<int>(point));
    std::vector<std::pair<int, int>> touched;
    for (size_t number = 0; number < edges.size(); ++number)
        if (edges[number].areFriends()) {
            const Sides sides = sidesOf(edges[number]);
            relate(edges[number], sides);
            for (const int row : {0, 1}) {
                for (int k = 0; k < sides.a.length(); ++k)
                    touched.emplace_back(sides.pointA(row, k), static_cast<int>(number));
                for (int k = 0; k < sides.b.length(); ++k)
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
    if (const auto same = requireSameRows(edge, sides.a, sides.b); !same) {
        hold(edge, sides, 1, same.error().what);
        return;
    }
    for (int k = 0; k < sides.a.length(); ++k)
        sites_[static_cast<size_t>(root(sides.pointB(0, sides.alongB(k))))] = root(sides.pointA(0, k));
}

void SiteNetwork::relate(const FriendEdge& edge, const Sides& sides)
{
    if (const auto same = requireSameRows(edge, sides.a, sides.b); !same) {
        hold(edge, sides, 2, same.error().what);
        return;
    }
    const auto relation = rowRelation(edge, sides.a, sides.placeA, sides.b, sides.placeB);
    if (!relation) {
        hold(edge, sides, 2, relation.error().what);
        return;
    }
    for (int k = 0; k < sides.a.length(); ++k) {
        const int there = sides.alongB(k);
        conditions_.push_back({{{site(sides.pointB(1, there)), sides.b.at(1, there).weight},
                                {site(sides.pointA(0, k)), -relation->ofEdge * sides.a.at(0, k).weight},
                                {site(sides.pointA(1, k)), -relation->ofRow * sides.a.at(1, k).weight}},
                               Vec3(0)});
    }
}

void SiteNetwork::hold(const FriendEdge& edge, const Sides& sides, int rows, const std::string& why)
{
    const int reason = static_cast<int>(reasons_.size());
    reasons_.push_back(sentenceStart(edge) + why);
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k < sides.a.length(); ++k)
            held_[static_cast<size_t>(sides.pointA(row, k))] = reason;
        for (int k = 0; k < sides.b.length(); ++k)
            held_[static_cast<size_t>(sides.pointB(row, k))] = reason;
    }
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
