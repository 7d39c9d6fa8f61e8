// The path of Knotspan: grids that keep the error bound, without cracks, several small tiles in one mesh
// group.
#include "renderer/paths/surface_path.h"

#include <algorithm>

#include "shaders/shared/borders.glsl"

namespace knotspan {

namespace {

class MeshPath : public SurfacePath {
public:
    MeshPath(const Device& device, const Bindings& bindings, const PathVariant& variant)
        : device_(device),
          pipeline_(
              makeGraphicsPipeline(device, bindings,
                                   {.stages = {"mesh.task", variant.cullsDice ? "mesh_evs.mesh" : "mesh.mesh",
                                               variant.fragmentStage()},
                                    .specialization = variant.specialization}))
    {
    }

    [[nodiscard]] std::optional<TileLimits> tiles() const override
    {
        const std::uint32_t vertices = device_.abilities().meshVertices;
        const std::uint32_t triangles = device_.abilities().meshTriangles;
        return TileLimits{.vertices = vertices,
                          .triangles = triangles,
                          .tilesPerDraw = 0,
                          .taskTiles = TASK_TILES,
                          .snap = SNAP_RING,
                          .wholeGrids = true,
                          .ringTriangles = std::min({vertices - 2, triangles, 254U})};
    }

    void draw(VkCommandBuffer commands, std::uint32_t, const TileDraws& tiles) const override
    {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
        device_.drawMeshTasksIndirect()(commands, tiles.draws, 0, 1, sizeof(gpu::DrawRecord));
    }

private:
    const Device& device_;
    Pipeline pipeline_;
};

}  // namespace

PathFactory meshPath()
{
    return {{PathId::mesh, "mesh", "Task and mesh stages, as fine as the tolerance asks, without cracks",
             true, tileRules(), true, true},
            [](const Device& device) { return device.abilities().noMeshStages; },
            [](const Device& device, Bindings& bindings,
               const PathVariant& variant) -> std::unique_ptr<SurfacePath> {
                return std::make_unique<MeshPath>(device, bindings, variant);
            }};
}

}  // namespace knotspan
