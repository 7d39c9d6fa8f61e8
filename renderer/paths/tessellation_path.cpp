// RPNS uniform (Concheiro et al. 2014): KSQuads as patches, and the evaluation stage computes the surface.
// Their grids come from the sampling pass, so that they keep the error bound and meet without cracks.
#include "renderer/paths/tessellated_tiles.h"

namespace knotspan {

PathFactory tessellationPath()
{
    return {{PathId::tessellation, "tessellation",
             "Tessellation stages, KSQuads as patches, as fine as the tolerance asks", true, tileRules()},
            [](const Device& device) { return device.abilities().noTessellation; },
            [](const Device& device, Bindings& bindings,
               const PathVariant& variant) -> std::unique_ptr<SurfacePath> {
                return makeTessellatedTiles(device, bindings, variant, Packing::ksquads);
            }};
}

}  // namespace knotspan
