#include "model/matching/keep_friends.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "model/core/check.h"
#include "model/matching/site_network.h"

namespace knotspan {

namespace {

constexpr size_t kMostConditions = 500;  // that are solved at once
constexpr double kSlack = 1e-9;          // of the model's size: conditions met to this are met

// Match leaves knots and rows of the other side as they are, so it is no way out.
constexpr const char* kRemedy = "Pull control points further from it, or switch off Keep friends";

using Displacements = std::map<int, Vec3>;  // of sites, in model space

// One attempt: sites up to a role may move.
class Attempt {
public:
    Attempt(const SiteNetwork& network, const Displacements& pulled, Role freest)
        : network_(network),
          pulled_(pulled),
          freest_(freest)
    {
        for (const auto& [site, displacement] : pulled)
            collect(site);
        for (size_t k = 0; k < unknowns_.size() && conditions_.size() <= kMostConditions; ++k)
            collect(unknowns_[k]);
    }

    [[nodiscard]] const std::string* whyHeld() const { return whyHeld_; }

    [[nodiscard]] std::optional<Displacements> solved(double slack) const
    {
        if (conditions_.size() > kMostConditions)
            return std::nullopt;
        std::vector<LinearCondition> conditions;
        for (const int number : conditions_)
            conditions.push_back(reduced(network_.condition(number)));
        const auto found = leastChange(static_cast<int>(unknowns_.size()), conditions, slack);
        if (!found)
            return std::nullopt;
        Displacements result = pulled_;
        for (size_t k = 0; k < unknowns_.size(); ++k)
            result[unknowns_[k]] = (*found)[k];
        return result;
    }

private:
    // The conditions on a site that moves, and who else they let move.
    void collect(int site)
    {
        for (const int number : network_.conditionsOf(site)) {
            if (!conditions_.insert(number).second)
                continue;
            for (const auto& term : network_.condition(number).terms)
                consider(term.first);
        }
    }

    void consider(int site)
    {
        if (pulled_.count(site) != 0 || numbers_.count(site) != 0)
            return;
        if (const std::string* why = network_.whyHeld(site))
            whyHeld_ = why;
        else if (network_.role(site) <= freest_) {
            numbers_[site] = static_cast<int>(unknowns_.size());
            unknowns_.push_back(site);
        }
    }

    // Between the unknowns alone.
    [[nodiscard]] LinearCondition reduced(const LinearCondition& condition) const
    {
        LinearCondition result;
        for (const auto& [site, coefficient] : condition.terms) {
            if (const auto pulled = pulled_.find(site); pulled != pulled_.end())
                result.right -= coefficient * pulled->second;
            else if (const auto number = numbers_.find(site); number != numbers_.end())
                result.terms.emplace_back(number->second, coefficient);
        }
        return result;
    }

    const SiteNetwork& network_;
    const Displacements& pulled_;
    Role freest_;
    std::set<int> conditions_;
    std::map<int, int> numbers_;
    std::vector<int> unknowns_;
    const std::string* whyHeld_ = nullptr;
};

}  // namespace

NurbsSurface withMoves(const NurbsSurface& surface, std::uint32_t number, const std::vector<PointMove>& moves)
{
    const auto isOurs = [number](const PointMove& move) { return move.surface == number; };
    if (std::none_of(moves.begin(), moves.end(), isOurs))
        return surface;
    std::vector<ControlPoint> points = surface.controlPoints();
    for (const PointMove& move : moves)
        if (isOurs(move))
            points[static_cast<size_t>(move.index.i * surface.countV() + move.index.j)].position =
                move.position;
    auto result = NurbsSurface::create(surface.knotsU(), surface.knotsV(), std::move(points));
    check(result.has_value(), "control points move to finite places");
    return *std::move(result);
}

struct FriendKeeper::State {
    struct Surface {
        Mat4 transform;
        Mat4 inverse;
        int countV = 0;
        std::vector<ControlPoint> points;
    };
    std::vector<Surface> surfaces;
    SiteNetwork network;
    double size = 0;

    State(const std::vector<PlacedSurface>& placed, const std::vector<FriendEdge>& edges,
          std::vector<std::string> names, double gap)
        : network(placed, edges, gap, std::move(names))
    {
        for (const PlacedSurface& one : placed) {
            surfaces.push_back({one.transform,
                                one.transform == Mat4(1.0) ? Mat4(1.0) : glm::inverse(one.transform),
                                one.surface->countV(), one.surface->controlPoints()});
            size = std::max(size, transformed(one.surface->bounds(), one.transform).diagonal());
        }
    }

    [[nodiscard]] int pointOf(const PointMove& move) const
    {
        check(move.surface < surfaces.size(), "a control point is pulled of a surface that is there");
        const Surface& surface = surfaces[move.surface];
        const int index = move.index.i * surface.countV + move.index.j;
        check(move.index.i >= 0 && move.index.j >= 0 && move.index.j < surface.countV &&
                  static_cast<size_t>(index) < surface.points.size(),
              "a pulled control point lies inside its net");
        return network.firstPoint(move.surface) + index;
    }

    // Where a point stands, in its surface's own space.
    [[nodiscard]] PointMove atRest(int point) const
    {
        const std::uint32_t surface = network.surfaceOf(point);
        const int index = point - network.firstPoint(surface);
        const int countV = surfaces[surface].countV;
        return {surface,
                {index / countV, index % countV},
                surfaces[surface].points[static_cast<size_t>(index)].position};
    }

    [[nodiscard]] Vec3 inModel(const PointMove& move) const
    {
        const Mat4& transform = surfaces[move.surface].transform;
        return transform == Mat4(1.0) ? move.position : transformed(move.position, transform);
    }

    [[nodiscard]] Result<Displacements> pulledSites(const std::vector<PointMove>& pulled) const
    {
        Displacements sites;
        for (const PointMove& move : pulled) {
            const int point = pointOf(move);
            const int site = network.site(point);
            const Vec3 displacement = inModel(move) - inModel(atRest(point));
            if (const std::string* why = network.whyHeld(site))
                return failure(*why, kRemedy);
            const auto [place, isNew] = sites.emplace(site, displacement);
            if (!isNew && glm::length(place->second - displacement) > kSlack * size)
                return failure("Control points that are one point of an edge are pulled apart",
                               "Pull one of them, the others follow");
        }
        return sites;
    }

    [[nodiscard]] Result<Displacements> solved(const Displacements& pulled) const
    {
        const std::string* why = nullptr;
        for (const Role freest : {Role::inner, Role::edge, Role::corner}) {
            const Attempt attempt(network, pulled, freest);
            if (auto found = attempt.solved(kSlack * size))
                return *found;
            if (attempt.whyHeld() != nullptr)
                why = attempt.whyHeld();
        }
        if (why != nullptr)
            return failure(*why, kRemedy);
        return failure("The surfaces that meet at this corner leave its control points no way to follow",
                       "Pull the corner itself, or switch off Keep friends");
    }

    [[nodiscard]] std::vector<PointMove> movesOf(const Displacements& displacements,
                                                 const std::vector<PointMove>& pulled) const
    {
        std::map<int, PointMove> moves;
        for (const auto& [site, displacement] : displacements)
            if (displacement != Vec3(0))
                for (const int point : network.pointsOf(site)) {
                    PointMove move = atRest(point);
                    const Mat4& transform = surfaces[move.surface].transform;
                    move.position = transform == Mat4(1.0) ? move.position + displacement
                                                           : transformed(inModel(move) + displacement,
                                                                         surfaces[move.surface].inverse);
                    moves.emplace(point, move);
                }
        for (const PointMove& move : pulled)
            takeAlong(move, moves);
        std::vector<PointMove> result;
        for (const auto& [point, move] : moves)
            result.push_back(move);
        return result;
    }

    // The pulled point goes where it was pulled to, to the bit, and so do those that had its bits before.
    void takeAlong(const PointMove& pulled, std::map<int, PointMove>& moves) const
    {
        const int point = pointOf(pulled);
        moves[point] = pulled;
        const PointMove rest = atRest(point);
        for (const int other : network.pointsOf(network.site(point))) {
            const PointMove otherRest = atRest(other);
            if (otherRest.position == rest.position &&
                surfaces[otherRest.surface].transform == surfaces[rest.surface].transform)
                moves[other] = {otherRest.surface, otherRest.index, pulled.position};
        }
    }
};

FriendKeeper::FriendKeeper(const std::vector<PlacedSurface>& surfaces, const std::vector<FriendEdge>& edges,
                           std::vector<std::string> names, double gap)
    : state_(std::make_unique<State>(surfaces, edges, std::move(names), gap))
{
}

FriendKeeper::~FriendKeeper() = default;
FriendKeeper::FriendKeeper(FriendKeeper&&) noexcept = default;
FriendKeeper& FriendKeeper::operator=(FriendKeeper&&) noexcept = default;

Result<std::vector<PointMove>> FriendKeeper::follow(const std::vector<PointMove>& pulled) const
{
    const auto sites = state_->pulledSites(pulled);
    if (!sites)
        return tl::unexpected(sites.error());
    const auto displacements = state_->solved(*sites);
    if (!displacements)
        return tl::unexpected(displacements.error());
    return state_->movesOf(*displacements, pulled);
}

std::vector<size_t> FriendKeeper::touchedEdges(const std::vector<PointMove>& moves) const
{
    std::set<size_t> edges;
    for (const PointMove& move : moves)
        for (const int edge : state_->network.edgesOf(state_->pointOf(move)))
            edges.insert(static_cast<size_t>(edge));
    return {edges.begin(), edges.end()};
}

}  // namespace knotspan
