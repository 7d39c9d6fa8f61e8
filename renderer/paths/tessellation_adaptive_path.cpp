// RPNS adaptive (Concheiro et al. 2014): the tessellator makes KSDice, the geometry stage splits them where
// they must be finer. By the bound it starts from half the drawn grid's lines and splits where the surface
// bends.
#include "renderer/paths/surface_path.h"

#include <algorithm>

#include "shaders/shared/borders.glsl"
#include "shaders/shared/grid_choice.glsl"

namespace knotspan {

namespace {

constexpr std::uint32_t kOutputComponents = 4 + 3 + 3 + 3 + 1;  // surface_io.glsl

class TessellationAdaptivePath : public SurfacePath {
public:
    TessellationAdaptivePath(const Device& device, Bindings& bindings, const PathVariant& variant)
        : device_(device),
          bindings_(bindings),
          blocks_(makeComputePipeline(device, bindings, "adaptive_blocks.comp", variant.specialization)),
          draw_(makeGraphicsPipeline(device, bindings,
                                     {.stages = {"tile.vert", "adaptive.tesc", "adaptive.tese",
                                                 "adaptive.geom", variant.fragmentStage()},
                                      .topology = VK_PRIMITIVE_TOPOLOGY_PATCH_LIST,
                                      .specialization = variant.specialization}))
    {
    }

    [[nodiscard]] std::optional<TileLimits> tiles() const override
    {
        // In cells of the drawn grid, of which the tessellator makes every other one; tiles that start at
        // even cells may be two wider.
        TileLimits limits{.side = 2 * device_.abilities().maxTessellationLevel - 2, .snap = SNAP_FALLING};
        if (const std::uint32_t vertices = device_.abilities().tessellatedVerticesPerDraw; vertices != 0) {
            constexpr std::uint32_t kSide = 16;
            constexpr std::uint32_t kBaseCells = (kSide / 2 + 1) * (kSide / 2 + 1);
            limits.side = kSide;
            limits.tilesPerDraw = vertices / (kBaseCells * ADAPTIVE_VERTICES);
        }
        return limits;
    }

    void prepare(const PathFrame& frame, gpu::FrameRecord& record) override
    {
        ksquads_ = record.ksquadCount;
        byBound_ = record.samplingRule == RULE_BOUND;
        record.flags |= FRAME_EVEN_TILES;
        if (record.samplingRule == RULE_AREA || record.samplingRule == RULE_EDGE) {
            record.snap = SNAP_HALVES;
            // RPNS eq. 5, boundary region: where the neighbour is no friend.
            record.flags |= FRAME_OVERSAMPLE_STRANGERS;
            if (frame.rule.kind == SamplingRule::Kind::areaNoFriends)
                record.flags |= FRAME_OVERSAMPLE_FRIENDS;
        }
        bindings_.provide(BINDING_ADAPTIVE_BLOCKS, blockBuffer_,
                          VkDeviceSize{ksquads_} * sizeof(std::uint32_t));
    }

    [[nodiscard]] bool asksForFriends(const SamplingRule& rule) const override
    {
        return rule.kind == SamplingRule::Kind::area || rule.kind == SamplingRule::Kind::edge;
    }

    void compute(VkCommandBuffer commands) const override
    {
        if (!byBound_)
            return;
        const GroupCount groups = groupsFor(ksquads_, LIST_KSQUADS / GRID_LANES);
        memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT,
                      VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                      VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, blocks_.get());
        vkCmdDispatch(commands, groups.x, groups.y, 1);
        memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                      VK_PIPELINE_STAGE_2_ALL_GRAPHICS_BIT,
                      VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    }

    void draw(VkCommandBuffer commands, std::uint32_t, const TileDraws& tiles) const override
    {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, draw_.get());
        drawIndirect(commands, device_, tiles);
    }

private:
    const Device& device_;
    Bindings& bindings_;
    Pipeline blocks_;
    Pipeline draw_;
    Buffer blockBuffer_;
    std::uint32_t ksquads_ = 0;
    bool byBound_ = true;
};

std::string whyUnavailable(const Device& device)
{
    if (!device.abilities().noTessellation.empty())
        return device.abilities().noTessellation;
    if (!device.abilities().noGeometry.empty())
        return device.abilities().noGeometry;
    const std::uint32_t vertices =
        std::min(device.limits().maxGeometryOutputVertices,
                 device.limits().maxGeometryTotalOutputComponents / kOutputComponents);
    return vertices < ADAPTIVE_VERTICES ? "This device's geometry stage puts out too few vertices" : "";
}

}  // namespace

PathFactory tessellationAdaptivePath()
{
    return {{PathId::tessellationAdaptive,
             "tessellation-adaptive",
             "Tessellation and geometry stages, finer only where the surface bends",
             true,
             {{SamplingRule::Kind::bound},
              {SamplingRule::Kind::area},
              {SamplingRule::Kind::areaNoFriends},
              {SamplingRule::Kind::edge},
              {SamplingRule::Kind::fixed}}},
            whyUnavailable,
            [](const Device& device, Bindings& bindings,
               const PathVariant& variant) -> std::unique_ptr<SurfacePath> {
                return std::make_unique<TessellationAdaptivePath>(device, bindings, variant);
            }};
}

}  // namespace knotspan
