#include "renderer/scene/shown_sides.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace knotspan {

bool ShownSides::follow(const std::vector<Resident>& residents, const CoincidentEdges& edges)
{
    const HeldResidents::Difference difference = held_.take(residents);
    if (difference.isEmpty())
        return false;
    if (difference.anew) {
        shells_ = Shells(placedSurfaces(residents), edges);
        tables_ = {};
    } else {
        shells_.update(difference.changes, edges);
    }
    return true;
}

const SideTables& ShownSides::of(const std::vector<Resident>& residents, const CoincidentEdges& edges,
                                 const Camera& camera, double aspect, const Box& bounds)
{
    const double cutOff = camera.cutOff(aspect, bounds);
    const bool changed = follow(residents, edges);
    if (!changed && camera_ && *camera_ == camera && cutOff_ == cutOff)
        return tables_;
    camera_ = camera;
    cutOff_ = cutOff;
    const std::vector<float> known = std::move(tables_.sides);
    tables_ = asTold(residents);
    std::vector<std::uint32_t> firsts(shells_.count(), ~0U);
    for (std::uint32_t k = 0; k < residents.size(); ++k) {
        if (residents[k].object->sides != Sides::automatic)
            continue;
        const std::uint32_t shell = shells_.shellOf(k);
        const int side = shells_.side(k);
        if (firsts[shell] == ~0U) {
            firsts[shell] = k;
            const bool outside =
                shells_.isClosed(shell) && side != 0 &&
                (camera.orthographic ? shells_.isOutsideAlong(shell, camera.forward(), cutOff)
                                     : shells_.isOutside(shell, camera.eye, cutOff));
            tables_.shown[k] = outside ? 1 : 0;
        }
        tables_.shells[k] = firsts[shell];
        if (side != 0)
            tables_.sides[k] = static_cast<float>(side);
        else if (known.size() == residents.size())
            tables_.sides[k] = known[k];
    }
    return tables_;
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
