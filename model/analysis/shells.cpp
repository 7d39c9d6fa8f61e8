#include "model/analysis/shells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/analysis/border_cover.h"

namespace knotspan {

namespace {

// Surfaces in groups, each turned like the first of its group or the other way.
class TurnedGroups {
public:
    explicit TurnedGroups(std::uint32_t count) : next_(count), turned_(count, 0), twisted_(count, 0)
    {
        std::iota(next_.begin(), next_.end(), 0U);
    }

    void join(std::uint32_t a, std::uint32_t b, bool opposed)
    {
        const auto [rootA, turnedA] = rootOf(a);
        const auto [rootB, turnedB] = rootOf(b);
        const bool opposedRoots = opposed != (turnedA != turnedB);
        if (rootA == rootB) {
            twisted_[rootA] |= opposedRoots ? 1 : 0;
            return;
        }
        const auto [low, high] = std::minmax(rootA, rootB);
        next_[high] = low;
        turned_[high] = opposedRoots ? 1 : 0;
        twisted_[low] |= twisted_[high];
    }

    struct Root {
        std::uint32_t root;
        bool turned;
    };
    [[nodiscard]] Root rootOf(std::uint32_t surface)
    {
        Root found{surface, false};
        while (next_[found.root] != found.root) {
            found.turned = found.turned != (turned_[found.root] != 0);
            found.root = next_[found.root];
        }
        next_[surface] = found.root;
        turned_[surface] = found.turned ? 1 : 0;
        return found;
    }
    // No choice of turns agrees along all borders.
    [[nodiscard]] bool isTwisted(std::uint32_t root) const { return twisted_[root] != 0; }

private:
    std::vector<std::uint32_t> next_;
    std::vector<char> turned_;  // against next
    std::vector<char> twisted_;
};

// Whether border side k, along its parameter, runs counterclockwise round the surface's domain.
bool runsRound(const BorderNumbers& numbers, std::uint32_t k)
{
    const std::uint32_t n = numbers.spansV;
    return (k >= n && k < 2 * n) || (k >= 2 * n && k < 2 * n + numbers.spansU);
}

struct SideOf {
    std::uint32_t surface = 0;
    bool round = false;
};

std::vector<SideOf> sidesOf(const std::vector<BorderNumbers>& all)
{
    std::vector<SideOf> sides;
    for (std::uint32_t surface = 0; surface < all.size(); ++surface)
        for (std::uint32_t k = 0; k < all[surface].borderCount(); ++k)
            sides.push_back({surface, runsRound(all[surface], k)});
    return sides;
}

// Neighbours are turned alike where they run along their edge in opposite ways.
void joinAlong(const CoincidentEdge& edge, const std::vector<SideOf>& sides, TurnedGroups& groups)
{
    for (size_t k = 0; k + 1 < edge.cuts.size(); ++k) {
        const EdgeMember* before = nullptr;
        for (const EdgeMember& member : edge.members) {
            if (!member.covers(edge.cuts[k].at, edge.cuts[k + 1].at))
                continue;
            const auto forwards = [&](const EdgeMember& one) {
                return (one.start < one.end) == sides[one.side].round;
            };
            if (before != nullptr)
                groups.join(sides[before->side].surface, sides[member.side].surface,
                            forwards(*before) == forwards(member));
            before = &member;
        }
    }
}

}  // namespace

Shells::Shells(const std::vector<PlacedSurface>& surfaces, const CoincidentEdges& edges)
{
    for (const PlacedSurface& placed : surfaces)
        parts_.push_back(std::make_shared<const ShellPart>(placed));
    join(edges);
}

void Shells::update(const std::vector<CoincidentEdges::Change>& changes, const CoincidentEdges& edges)
{
    for (const CoincidentEdges::Change& change : changes)
        parts_[change.index] = std::make_shared<const ShellPart>(change.placed);
    join(edges);
}

void Shells::join(const CoincidentEdges& edges)
{
    const std::vector<SideOf> sideOf = sidesOf(edges.numbers());
    TurnedGroups groups(static_cast<std::uint32_t>(parts_.size()));
    for (std::uint32_t side = 0; side < edges.sideCount(); ++side)
        if (const CoincidentEdge* edge = edges.edgeAlong(side);
            edge != nullptr && edge->members.front().side == side)
            joinAlong(*edge, sideOf, groups);

    shells_.clear();
    shellOf_.assign(parts_.size(), 0);
    sides_.assign(parts_.size(), 0);
    std::vector<char> turned(parts_.size(), 0);
    for (std::uint32_t surface = 0; surface < parts_.size(); ++surface) {
        const auto [root, isTurned] = groups.rootOf(surface);
        turned[surface] = isTurned ? 1 : 0;
        shellOf_[surface] = root == surface ? count() : shellOf_[root];
        if (root == surface)
            shells_.push_back({{}, true, nullptr});
        shells_[shellOf_[surface]].surfaces.push_back(surface);
    }
    for (std::uint32_t side = 0; side < edges.sideCount(); ++side)
        if (!isManifoldSide(edges, side))
            shells_[shellOf_[sideOf[side].surface]].closed = false;
    for (Shell& shell : shells_)
        if (shell.closed && !groups.isTwisted(shell.surfaces.front()))
            findSides(shell, turned, edges);
}

void Shells::findSides(Shell& shell, const std::vector<char>& turned, const CoincidentEdges& edges)
{
    Box box;
    for (const std::uint32_t surface : shell.surfaces)
        box.add(parts_[surface]->box());
    double volume = 0;
    double error = 0;
    for (const std::uint32_t surface : shell.surfaces) {
        const SweptVolume& swept = parts_[surface]->sweptVolume();
        volume += (turned[surface] != 0 ? -1 : 1) * swept.seenFrom(box.centre());
        error += swept.errorFrom(box.centre());
    }
    const Vec3 size = box.size();
    constexpr double kLeast = 1e-6;  // of its box
    if (!(std::abs(volume) > kLeast * size.x * size.y * size.z + 4 * error))
        return;
    std::vector<ShellMesh::Member> members;
    for (const std::uint32_t surface : shell.surfaces)
        members.push_back({surface, parts_[surface], (turned[surface] != 0) != (volume < 0)});
    auto mesh = std::make_shared<const ShellMesh>(members, edges);
    if (!crossings_.lookAgain(shell.surfaces, parts_, edges, mesh->margin()))
        return;
    for (const ShellMesh::Member& member : members)
        sides_[member.surface] = member.turned != member.part->isMirrored() ? -1 : 1;
    shell.mesh = std::move(mesh);
}

bool Shells::isOutside(std::uint32_t shell, const Vec3& eye, double radius) const
{
    return shells_[shell].mesh != nullptr && shells_[shell].mesh->isOutside(eye, radius);
}

bool Shells::isOutsideAlong(std::uint32_t shell, const Vec3& direction, double nearest) const
{
    if (shells_[shell].mesh == nullptr)
        return false;
    const Box& box = shells_[shell].mesh->box();
    const double middle = glm::dot(direction, box.centre());
    const double reach = glm::dot(glm::abs(direction), box.size()) / 2;
    return middle - reach > nearest || middle + reach < nearest;
}

}  // namespace knotspan
