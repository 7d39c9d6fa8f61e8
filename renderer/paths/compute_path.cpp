// NVIDIA's white paper on direct evaluation of NURBS surfaces (CUDA): the compute stage makes vertex and
// index buffers, an indirect draw shows them. Sampling has chosen the factors of edges before.
#include "renderer/paths/surface_path.h"

#include <algorithm>

#include "shaders/shared/borders.glsl"

namespace knotspan {

namespace {

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;

class ComputePath : public SurfacePath {
public:
    ComputePath(const Device& device, Bindings& bindings, const PathVariant& variant)
        : bindings_(bindings),
          count_(makeComputePipeline(device, bindings, "compute_count.comp")),
          scan_(makeComputePipeline(device, bindings, "compute_scan.comp")),
          starts_(makeComputePipeline(device, bindings, "compute_starts.comp")),
          vertices_(makeComputePipeline(device, bindings, "compute_vertices.comp", variant.specialization)),
          indices_(makeComputePipeline(device, bindings, "compute_indices.comp")),
          draw_(makeGraphicsPipeline(device, bindings,
                                     {.stages = {"compute.vert", variant.fragmentStage()},
                                      .specialization = variant.specialization}))
    {
    }

    [[nodiscard]] std::optional<TileLimits> tiles() const override
    {
        return TileLimits{.side = 64, .snap = SNAP_RING, .wholeGrids = true};
    }

    void prepare(const PathFrame&, gpu::FrameRecord& record) override
    {
        // Most tiles have a cell at least.
        vertexCapacity_ = std::max(vertexCapacity_, 4 * record.tileCapacity);
        triangleCapacity_ = std::max(triangleCapacity_, 2 * record.tileCapacity);
        record.vertexCapacity = vertexCapacity_;
        record.triangleCapacity = triangleCapacity_;
        tiles_ = record.tileCapacity;
        const VkDeviceSize groups = (tiles_ + MESH_TILES - 1) / MESH_TILES;
        bindings_.provide(BINDING_MESH_GROUPS, groupBuffer_, groups * 2 * sizeof(gpu::uvec2));
        bindings_.provide(BINDING_MESH_STARTS, startBuffer_, VkDeviceSize{tiles_} * sizeof(gpu::uvec2));
        bindings_.provide(BINDING_VERTICES, vertexBuffer_,
                          VkDeviceSize{vertexCapacity_} * sizeof(gpu::VertexRecord));
        bindings_.provide(BINDING_INDICES, indexBuffer_,
                          VkDeviceSize{triangleCapacity_} * 3 * sizeof(std::uint32_t));
    }

    void compute(VkCommandBuffer commands) const override
    {
        memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT,
                      VK_PIPELINE_STAGE_2_TRANSFER_BIT | kCompute,
                      VK_ACCESS_2_TRANSFER_WRITE_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
        vkCmdFillBuffer(commands, groupBuffer_.get(), 0, VK_WHOLE_SIZE, 0);
        memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, kCompute,
                      VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
        computeStep(commands, count_, groupsFor(tiles_, MESH_TILES));
        computeStep(commands, scan_, {1, 1});
        computeStep(commands, starts_, groupsFor(tiles_, MESH_TILES));
        computeStep(commands, vertices_, groupsFor(vertexCapacity_, MESH_ITEMS));
        computeStep(commands, indices_, groupsFor(triangleCapacity_, MESH_ITEMS));
        memoryBarrier(commands, kCompute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                      VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT |
                          VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT,
                      VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_INDEX_READ_BIT |
                          VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
    }

    [[nodiscard]] bool hadRoom(const gpu::Counters& counted) override
    {
        const bool room =
            counted.mostVertices <= vertexCapacity_ && counted.mostTriangles <= triangleCapacity_;
        vertexCapacity_ = room ? vertexCapacity_ : counted.mostVertices + counted.mostVertices / 4;
        triangleCapacity_ = room ? triangleCapacity_ : counted.mostTriangles + counted.mostTriangles / 4;
        return room;
    }

    void draw(VkCommandBuffer commands, std::uint32_t, const TileDraws& tiles) const override
    {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, draw_.get());
        vkCmdBindIndexBuffer(commands, indexBuffer_.get(), 0, VK_INDEX_TYPE_UINT32);
        vkCmdDrawIndexedIndirect(commands, tiles.draws, 0, 1, sizeof(gpu::IndexedDrawRecord));
    }

private:
    Bindings& bindings_;
    Pipeline count_;
    Pipeline scan_;
    Pipeline starts_;
    Pipeline vertices_;
    Pipeline indices_;
    Pipeline draw_;
    Buffer groupBuffer_;
    Buffer startBuffer_;
    Buffer vertexBuffer_;
    Buffer indexBuffer_;
    std::uint32_t tiles_ = 0;
    std::uint32_t vertexCapacity_ = 0;
    std::uint32_t triangleCapacity_ = 0;
};

}  // namespace

PathFactory computePath()
{
    return {{PathId::compute, "compute", "The compute stage makes triangles, as fine as the tolerance asks",
             true, tileRules()},
            [](const Device&) { return std::string(); },
            [](const Device& device, Bindings& bindings,
               const PathVariant& variant) -> std::unique_ptr<SurfacePath> {
                return std::make_unique<ComputePath>(device, bindings, variant);
            }};
}

}  // namespace knotspan
