#include "renderer/scene/shown_sides.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

constexpr std::uint32_t kNone = ~0U;

}  // namespace

std::optional<std::vector<std::uint32_t>> ShownSides::follow(const std::vector<Resident>& residents,
                                                             const CoincidentEdges& edges,
                                                             const ResidentChanges* log)
{
    const HeldResidents::Difference difference = held_.take(residents, log);
    bool toldOtherwise = false;
    if (difference.anew) {
        shells_ = Shells(placedSurfaces(residents), edges);
        tables_.sides.clear();
        told_.clear();
    } else if (!difference.changes.empty()) {
        shells_.update(difference.changes, edges);
        for (const SurfaceChange& change : difference.changes)
            toldOtherwise = toldOtherwise || told_[change.index] != residents[change.index].object->sides;
    }
    const bool sameShells = std::exchange(shellsSeen_, shells_.revision()) == shells_.revision();
    if (difference.anew || !sameShells || toldOtherwise)
        return std::nullopt;
    std::vector<std::uint32_t> touched;
    for (const SurfaceChange& change : difference.changes)
        touched.push_back(shells_.shellOf(change.index));
    return touched;
}

const SideTables& ShownSides::of(const std::vector<Resident>& residents, const CoincidentEdges& edges,
                                 const Camera& camera, double aspect, const Box& bounds,
                                 const ResidentChanges* log)
{
    const View view{camera, camera.cutOff(aspect, bounds)};
    const auto touched = follow(residents, edges, log);
    if (!touched)
        makeTables(residents);
    if (touched && view_ == view)
        for (const std::uint32_t shell : *touched)
            showFrom(view, shell);
    else
        for (std::uint32_t shell = 0; shell < shells_.count(); ++shell)
            showFrom(view, shell);
    view_ = view;
    return tables_;
}

// All but whose outside alone is shown.
void ShownSides::makeTables(const std::vector<Resident>& residents)
{
    const std::vector<float> known = std::move(tables_.sides);
    const std::uint64_t revision = tables_.revision;
    tables_ = asTold(residents);
    tables_.revision = revision + 1;
    told_.clear();
    firsts_.assign(shells_.count(), kNone);
    open_.assign(shells_.count(), false);
    for (std::uint32_t k = 0; k < residents.size(); ++k) {
        if (isTrimmed(residents[k]))
            open_[shells_.shellOf(k)] = true;
        told_.push_back(residents[k].object->sides);
        if (told_[k] != Sides::automatic)
            continue;
        const std::uint32_t shell = shells_.shellOf(k);
        if (firsts_[shell] == kNone)
            firsts_[shell] = k;
        tables_.shells[k] = firsts_[shell];
        if (const int side = shells_.side(k); side != 0)
            tables_.sides[k] = static_cast<float>(side);
        else if (known.size() == residents.size())
            tables_.sides[k] = known[k];
    }
}

void ShownSides::showFrom(const View& view, std::uint32_t shell)
{
    const std::uint32_t first = firsts_[shell];
    if (first == kNone)
        return;
    const bool outside =
        shells_.isClosed(shell) && !open_[shell] && shells_.side(first) != 0 &&
        (view.camera.orthographic ? shells_.isOutsideAlong(shell, view.camera.forward(), view.cutOff)
                                  : shells_.isOutside(shell, view.camera.eye, view.cutOff));
    if (const std::uint32_t shown = outside ? 1 : 0; shown != std::exchange(tables_.shown[first], shown))
        ++tables_.revision;
}

SideTables ShownSides::asTold(const std::vector<Resident>& residents)
{
    const size_t surfaces = residents.size();
    SideTables tables;
    tables.sides.resize(surfaces, 0.0F);
    tables.shown.resize(surfaces, 0);
    tables.shells.resize(surfaces);
    for (size_t k = 0; k < surfaces; ++k) {
        tables.shells[k] = static_cast<std::uint32_t>(k);
        const Sides told = residents[k].object->sides;
        if (told == Sides::front || told == Sides::back) {
            tables.sides[k] = told == Sides::front ? 1.0F : -1.0F;
            tables.shown[k] = 1;
        }
    }
    return tables;
}

bool SideTables::anyShownAlone() const
{
    return std::find(shown.begin(), shown.end(), 1U) != shown.end();
}

}  // namespace knotspan
