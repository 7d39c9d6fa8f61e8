// RPNS' first variant (Concheiro et al. 2014): the geometry stage alone makes the triangles. What it may put
// out limits a tile to a few cells, so large KSQuads take many invocations.
#include "renderer/paths/surface_path.h"

#include <algorithm>

#include "shaders/shared/borders.glsl"

namespace knotspan {

namespace {

// How many vertices a geometry stage may put out here, of the components that each has in surface_io.glsl.
std::uint32_t verticesOf(const Device& device)
{
    constexpr std::uint32_t kComponents = 4 + 1 + 3 + 3 + 2 + 1 + 3;
    return std::min(device.limits().maxGeometryOutputVertices,
                    device.limits().maxGeometryTotalOutputComponents / kComponents);
}

class GeometryPath : public SurfacePath {
public:
    GeometryPath(const Device& device, const Bindings& bindings, const PathVariant& variant)
        : device_(device),
          pipeline_(makeGraphicsPipeline(
              device, bindings,
              {.stages = {"tile.vert", variant.cullsDice ? "geometry_evs.geom" : "geometry.geom",
                          variant.fragmentStage()},
               .topology = VK_PRIMITIVE_TOPOLOGY_POINT_LIST,
               .specialization = variant.specialization}))
    {
    }

    [[nodiscard]] std::optional<TileLimits> tiles() const override
    {
        return TileLimits{.side = GEOMETRY_SIDE, .snap = SNAP_RING, .ringTriangles = GEOMETRY_VERTICES / 3};
    }
    [[nodiscard]] std::string limit() const override
    {
        return "The geometry stage puts out at most " + std::to_string(verticesOf(device_)) +
               " vertices here: tiles of " + std::to_string(GEOMETRY_SIDE) + " by " +
               std::to_string(GEOMETRY_SIDE) + " cells";
    }

    void draw(VkCommandBuffer commands, std::uint32_t, const TileDraws& tiles) const override
    {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
        drawIndirect(commands, device_, tiles);
    }

private:
    const Device& device_;
    Pipeline pipeline_;
};

}  // namespace

PathFactory geometryPath()
{
    return {{PathId::geometry, "geometry", "The geometry stage alone, a few cells at a time", true,
             tileRules(), true, true},
            [](const Device& device) -> std::string {
                if (!device.abilities().noGeometry.empty())
                    return device.abilities().noGeometry;
                return verticesOf(device) < GEOMETRY_VERTICES
                           ? "This device's geometry stage puts out too few vertices"
                           : "";
            },
            [](const Device& device, Bindings& bindings,
               const PathVariant& variant) -> std::unique_ptr<SurfacePath> {
                return std::make_unique<GeometryPath>(device, bindings, variant);
            }};
}

}  // namespace knotspan
