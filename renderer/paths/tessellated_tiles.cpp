#include "renderer/paths/tessellated_tiles.h"

#include "shaders/shared/borders.glsl"

namespace knotspan {

namespace {

class TessellatedTiles : public SurfacePath {
public:
    TessellatedTiles(const Device& device, const Bindings& bindings, const PathVariant& variant,
                     Packing packing)
        : device_(device),
          packing_(packing),
          pipeline_(makeGraphicsPipeline(
              device, bindings,
              {.stages = {"tile.vert", "tessellation.tesc", "tessellation.tese", variant.fragmentStage()},
               .topology = VK_PRIMITIVE_TOPOLOGY_PATCH_LIST,
               .specialization = variant.specialization}))
    {
    }

    [[nodiscard]] std::optional<TileLimits> tiles() const override
    {
        // The tessellator cuts cells as it likes.
        TileLimits limits{.side = device_.abilities().maxTessellationLevel, .snap = SNAP_NEAREST};
        if (const std::uint32_t vertices = device_.abilities().tessellatedVerticesPerDraw; vertices != 0) {
            constexpr std::uint32_t kMeasuredBest = 64;  // the cost of a draw grows faster than its patches
            limits.tilesPerDraw = kMeasuredBest;
            while ((limits.side + 1) * (limits.side + 1) * kMeasuredBest > vertices)
                --limits.side;
        }
        return limits;
    }
    [[nodiscard]] Packing packing() const override { return packing_; }

    void draw(VkCommandBuffer commands, std::uint32_t, const TileDraws& tiles) const override
    {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
        drawIndirect(commands, device_, tiles);
    }

private:
    const Device& device_;
    Packing packing_;
    Pipeline pipeline_;
};

}  // namespace

std::unique_ptr<SurfacePath> makeTessellatedTiles(const Device& device, const Bindings& bindings,
                                                  const PathVariant& variant, Packing packing)
{
    return std::make_unique<TessellatedTiles>(device, bindings, variant, packing);
}

}  // namespace knotspan
