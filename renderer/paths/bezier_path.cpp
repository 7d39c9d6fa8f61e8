// The traditional baseline: at every edit the CPU decomposes what changed into rational Bezier patches and
// sends them (BezierNets); the tessellation stages draw them as they draw KSQuads, with the same grids and
// edges.
#include "renderer/paths/tessellated_tiles.h"

namespace knotspan {

PathFactory bezierPath()
{
    return {{PathId::bezier, "bezier",
             "The processor makes Bezier patches at every edit, the tessellation stages draw them", true,
             tileRules(), false},
            [](const Device& device) { return device.abilities().noTessellation; },
            [](const Device& device, Bindings& bindings,
               const PathVariant& variant) -> std::unique_ptr<SurfacePath> {
                return makeTessellatedTiles(device, bindings, variant, Packing::bezier);
            }};
}

}  // namespace knotspan
