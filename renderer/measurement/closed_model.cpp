#include "renderer/measurement/closed_model.h"

#include "model/analysis/border_cover.h"

namespace knotspan {

bool isClosedModel(const Scene& scene)
{
    std::vector<PlacedSurface> surfaces;
    for (const auto& [id, object] : scene.objects()) {
        if (!object->visible)
            continue;
        if (!object->trimLoops.empty())
            return false;
        surfaces.push_back({&object->surface, object->transform});
    }
    if (surfaces.empty())
        return false;
    const CoincidentEdges edges(surfaces);
    for (std::uint32_t side = 0; side < edges.sideCount(); ++side)
        if (!isClosedSide(edges, side))
            return false;
    return true;
}

}  // namespace knotspan
