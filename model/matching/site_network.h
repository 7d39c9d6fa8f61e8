// Which control points move together along friend edges, and how: the conditions under which the edges stay
// closed and G1.
//
// Control points that are one point of an edge are one site and move as one. Points are numbered surface
// after surface, as their nets store them; a site has the number of one of its points.
#pragma once

#include <string>

#include "model/friends/friends.h"
#include "model/matching/least_change.h"
#include "model/matching/number_lists.h"

namespace knotspan {

// How reluctantly a site moves that is not pulled.
enum class Role { inner, edge, corner };

class SiteNetwork {
public:
    // `names` of the surfaces, for sentences; without, their numbers. `gap` is the tolerance within which the
    // edges were found.
    SiteNetwork(const std::vector<PlacedSurface>& surfaces, const std::vector<FriendEdge>& edges, double gap,
                std::vector<std::string> names);

    [[nodiscard]] int firstPoint(std::uint32_t surface) const { return firstPoints_[surface]; }
    [[nodiscard]] std::uint32_t surfaceOf(int point) const;
    [[nodiscard]] int site(int point) const { return sites_[static_cast<size_t>(point)]; }
    [[nodiscard]] std::span<const int> pointsOf(int site) const { return points_.of(site); }
    [[nodiscard]] Role role(int site) const { return roles_[static_cast<size_t>(site)]; }

    // Between displacements of sites, in model space; their sum is 0.
    [[nodiscard]] const LinearCondition& condition(int number) const
    {
        return conditions_[static_cast<size_t>(number)];
    }
    [[nodiscard]] std::span<const int> conditionsOf(int site) const { return conditionsOf_.of(site); }

    // Why a site shapes an edge that cannot follow, so that it must stay; null where nothing holds it.
    [[nodiscard]] const std::string* whyHeld(int site) const;

    // Friend edges, by their number among those given, of which the point is in the first two rows, or which
    // it shapes where they are trim curves.
    [[nodiscard]] std::span<const int> edgesOf(int point) const { return edgesOf_.of(point); }

private:
    struct Sides;

    [[nodiscard]] std::string sentenceStart(const FriendEdge& edge) const;
    void number(const std::vector<PlacedSurface>& surfaces);
    [[nodiscard]] int root(int point);
    void close(const FriendEdge& edge, const Sides& sides);
    void relate(const FriendEdge& edge, const Sides& sides);
    void hold(const FriendEdge& edge, const Sides& sides, int rows, const std::string& why);
    std::vector<int> holdTrimmed(const FriendEdge& edge, const std::vector<PlacedSurface>& surfaces);
    void index();

    double gap_;
    std::vector<std::string> names_;
    std::vector<int> firstPoints_;
    std::vector<int> sites_;
    NumberLists points_;
    std::vector<Role> roles_;
    std::vector<LinearCondition> conditions_;
    NumberLists conditionsOf_;
    std::vector<std::string> reasons_;
    std::vector<int> held_;  // of each point: which reason; -1 none
    NumberLists edgesOf_;
};

}  // namespace knotspan
