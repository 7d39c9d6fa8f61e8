#include "renderer/scene/shown_sides.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

PlacedSurface placed(const SharedObject& object)
{
    return {&object->surface, object->transform};
}

bool isSameShape(const SharedObject& a, const SharedObject& b)
{
    return a->surface.knotsU() == b->surface.knotsU() && a->surface.knotsV() == b->surface.knotsV();
}

}  // namespace

void ShownSides::follow(const std::vector<Resident>& residents, const CoincidentEdges& edges)
{
    bool anew = held_.size() != residents.size();
    std::vector<CoincidentEdges::Change> changes;
    for (size_t k = 0; k < residents.size() && !anew; ++k) {
        anew = !isSameShape(held_[k], residents[k].object);
        if (held_[k] != residents[k].object)
            changes.push_back({static_cast<std::uint32_t>(k), placed(residents[k].object)});
    }
    if (!anew && changes.empty())
        return;
    held_.clear();
    for (const Resident& resident : residents)
        held_.push_back(resident.object);
    if (anew) {
        std::vector<PlacedSurface> surfaces;
        for (const SharedObject& object : held_)
            surfaces.push_back(placed(object));
        shells_ = Shells(surfaces, edges);
        sides_.assign(residents.size(), 0.0F);
    } else {
        shells_.update(changes, edges);
    }
}

SideTables ShownSides::of(const std::vector<Resident>& residents, const CoincidentEdges& edges,
                          const Camera& camera, double aspect, const Box& bounds)
{
    follow(residents, edges);
    SideTables tables = all(residents.size());
    const double cutOff = camera.cutOff(aspect, bounds);
    std::vector<std::uint32_t> firsts(shells_.count(), ~0U);
    for (std::uint32_t k = 0; k < residents.size(); ++k) {
        const std::uint32_t shell = shells_.shellOf(k);
        if (firsts[shell] == ~0U) {
            firsts[shell] = k;
            const bool outside =
                shells_.isClosed(shell) && shells_.side(k) != 0 &&
                (camera.orthographic ? shells_.isOutsideAlong(shell, camera.forward(), cutOff)
                                     : shells_.isOutside(shell, camera.eye, cutOff));
            tables.shown[k] = outside ? 1 : 0;
        }
        tables.shells[k] = firsts[shell];
        if (shells_.side(k) != 0)
            sides_[k] = static_cast<float>(shells_.side(k));
    }
    tables.sides = sides_;
    return tables;
}

SideTables ShownSides::all(size_t surfaces)
{
    SideTables tables;
    tables.sides.resize(surfaces, 0.0F);
    tables.shown.resize(surfaces, 0);
    tables.shells.resize(surfaces);
    for (size_t k = 0; k < surfaces; ++k)
        tables.shells[k] = static_cast<std::uint32_t>(k);
    return tables;
}

bool SideTables::anyShownAlone() const
{
    return std::find(shown.begin(), shown.end(), 1U) != shown.end();
}

}  // namespace knotspan
