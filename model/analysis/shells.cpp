#include "model/analysis/shells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

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
    const auto besideMoved = edges.onlyMovedSince(std::exchange(joined_, edges.revision()));
    if (!besideMoved) {
        join(edges);
        return;
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> followed;
    const auto follows = [&](std::uint32_t surface) { followed[shellOf_[surface]].push_back(surface); };
    for (const CoincidentEdges::Change& change : changes)
        follows(change.index);
    for (const std::uint32_t surface : *besideMoved)
        follows(surface);
    for (auto& [shell, surfaces] : followed) {
        std::sort(surfaces.begin(), surfaces.end());
        surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
        follow(shells_[shell], surfaces, edges);
    }
}

void Shells::join(const CoincidentEdges& edges)
{
    joined_ = edges.revision();
    ++revision_;
    const std::vector<SideOf> sideOf = sidesOf(edges.numbers());
    TurnedGroups groups(static_cast<std::uint32_t>(parts_.size()));
    for (std::uint32_t side = 0; side < edges.sideCount(); ++side)
        if (const CoincidentEdge* edge = edges.edgeAlong(side);
            edge != nullptr && edge->members.front().side == side)
            joinAlong(*edge, sideOf, groups);

    shells_.clear();
    shellOf_.assign(parts_.size(), 0);
    sides_.assign(parts_.size(), 0);
    turned_.assign(parts_.size(), 0);
    for (std::uint32_t surface = 0; surface < parts_.size(); ++surface) {
        const auto [root, isTurned] = groups.rootOf(surface);
        turned_[surface] = isTurned ? 1 : 0;
        shellOf_[surface] = root == surface ? count() : shellOf_[root];
        if (root == surface) {
            shells_.emplace_back();
            shells_.back().closed = true;
        }
        shells_[shellOf_[surface]].surfaces.push_back(surface);
    }
    for (std::uint32_t side = 0; side < edges.sideCount(); ++side)
        if (!isManifoldSide(edges, side))
            shells_[shellOf_[sideOf[side].surface]].closed = false;
    for (Shell& shell : shells_) {
        shell.turnable = shell.closed && !groups.isTwisted(shell.surfaces.front());
        if (shell.turnable)
            begin(shell, edges);
    }
}

void Shells::Swept::add(const Swept& other)
{
    volume += other.volume;
    area += other.area;
    error += other.error;
    areaError += other.areaError;
}

Shells::Swept Shells::sweptBy(std::uint32_t surface, const Vec3& seenFrom) const
{
    const SweptVolume swept = parts_[surface]->sweptVolume();
    const double sign = turned_[surface] != 0 ? -1 : 1;
    return {sign * swept.seenFrom(seenFrom), sign * swept.area, swept.errorFrom(seenFrom), swept.areaError};
}

ShellMesh::Member Shells::memberOf(std::uint32_t surface, bool inverted) const
{
    return {surface, parts_[surface], (turned_[surface] != 0) != inverted};
}

// All of a shell that can be turned.
void Shells::begin(Shell& shell, const CoincidentEdges& edges)
{
    Box box;
    for (const std::uint32_t surface : shell.surfaces)
        box.add(parts_[surface]->box());
    shell.seenFrom = box.centre();
    std::vector<Swept> swept;
    for (const std::uint32_t surface : shell.surfaces)
        swept.push_back(sweptBy(surface, shell.seenFrom));
    shell.swept = Totals<Swept>(swept);
    makeMesh(shell, false, edges);
    findSides(shell, edges, nullptr);
}

void Shells::makeMesh(Shell& shell, bool inverted, const CoincidentEdges& edges)
{
    std::vector<ShellMesh::Member> members;
    for (const std::uint32_t surface : shell.surfaces)
        members.push_back(memberOf(surface, inverted));
    shell.mesh = std::make_unique<ShellMesh>(members, edges);
}

// Surfaces of a shell that are other ones now, or have other ones beside them, and are joined as before.
void Shells::follow(Shell& shell, const std::vector<std::uint32_t>& changed, const CoincidentEdges& edges)
{
    if (!shell.turnable)
        return;
    const bool inverted = shell.mesh->isTurned(0) != (turned_[shell.surfaces.front()] != 0);
    std::vector<std::uint32_t> others;
    for (const std::uint32_t surface : changed) {
        const auto member = static_cast<size_t>(
            std::lower_bound(shell.surfaces.begin(), shell.surfaces.end(), surface) - shell.surfaces.begin());
        if (shell.mesh->part(member) != parts_[surface]) {
            shell.swept.set(member, sweptBy(surface, shell.seenFrom));
            others.push_back(surface);
        }
        shell.mesh->replace(member, memberOf(surface, inverted), edges);
    }
    findSides(shell, edges, &others);
}

// `changed`: all that is new; null: everything may be.
void Shells::findSides(Shell& shell, const CoincidentEdges& edges, const std::vector<std::uint32_t>* changed)
{
    const Box box = shell.mesh->boxOfParts();
    const Swept all = shell.swept.all();
    const Vec3 way = shell.seenFrom - box.centre();
    const double volume = all.volume + glm::dot(way, all.area) / 3;
    const double error = all.error + glm::length(way) * all.areaError / 3;
    const Vec3 size = box.size();
    constexpr double kLeast = 1e-6;  // of its box
    const bool encloses = std::abs(volume) > kLeast * size.x * size.y * size.z + 4 * error;
    const bool inverted = shell.mesh->isTurned(0) != (turned_[shell.surfaces.front()] != 0);
    const bool turns = encloses && inverted != (volume < 0);
    if (turns)
        makeMesh(shell, volume < 0, edges);
    const ShellCrossings::Body body{shell.surfaces, parts_, edges, *shell.mesh};
    const bool keepsApart =
        encloses &&
        (changed != nullptr && shell.looked ? crossings_.lookAgain(body, *changed) : crossings_.look(body));
    // What was not looked at has to be looked for.
    shell.looked = encloses;
    setSides(shell, keepsApart, turns ? nullptr : changed);
}

// Of the changed ones, where no others can have other sides.
void Shells::setSides(Shell& shell, bool sided, const std::vector<std::uint32_t>* changed)
{
    const bool all = changed == nullptr || sided != shell.sided;
    shell.sided = sided;
    const bool inverted = shell.mesh->isTurned(0) != (turned_[shell.surfaces.front()] != 0);
    for (const std::uint32_t surface : all ? shell.surfaces : *changed) {
        const bool turned = (turned_[surface] != 0) != inverted;
        const int side = !sided ? 0 : turned != parts_[surface]->isMirrored() ? -1 : 1;
        if (side != std::exchange(sides_[surface], side))
            ++revision_;
    }
}

bool Shells::isOutside(std::uint32_t shell, const Vec3& eye, double radius) const
{
    return shells_[shell].sided && shells_[shell].mesh->isOutside(eye, radius);
}

bool Shells::isOutsideAlong(std::uint32_t shell, const Vec3& direction, double nearest) const
{
    if (!shells_[shell].sided)
        return false;
    const Box box = shells_[shell].mesh->box();
    const double middle = glm::dot(direction, box.centre());
    const double reach = glm::dot(glm::abs(direction), box.size()) / 2;
    return middle - reach > nearest || middle + reach < nearest;
}

}  // namespace knotspan
