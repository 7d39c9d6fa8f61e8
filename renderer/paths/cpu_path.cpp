// The processor makes the triangles, as it did before graphics cards could: uniformly over whole surfaces
// (Macri, 1999), or each KSQuad as finely as the bound asks. Vertices stay in the surfaces' own coordinates,
// so that a camera that moves sends only those of grids that change.
#include "renderer/paths/surface_path.h"

#include <algorithm>
#include <bit>

#include "renderer/scene/adaptive_grids.h"
#include "renderer/scene/cell_indices.h"
#include "renderer/scene/cpu_culling.h"
#include "renderer/scene/uniform_grids.h"

namespace knotspan {

namespace {

class CpuPath : public SurfacePath {
public:
    CpuPath(const Device& device, Bindings& bindings, const PathVariant& variant)
        : bindings_(bindings),
          captures_(variant.specialization.captures),
          capture_(makeComputePipeline(device, bindings, "cpu_capture.comp", variant.specialization)),
          draw_(makeGraphicsPipeline(
              device, bindings,
              {.stages = {"cpu.vert", variant.fragmentStage()}, .specialization = variant.specialization}))
    {
    }

    [[nodiscard]] std::optional<TileLimits> tiles() const override { return std::nullopt; }

    [[nodiscard]] std::uint32_t followed(std::uint32_t cullBits, SamplingRule rule) const override
    {
        return rule.kind == SamplingRule::Kind::fixed ? 0 : cullBits;
    }

    void prepare(const PathFrame& frame, gpu::FrameRecord& record) override
    {
        const bool isUniform = frame.rule.kind == SamplingRule::Kind::fixed;
        const bool switched = isUniform != isUniform_;
        isUniform_ = isUniform;
        if (isUniform)
            evaluations_ = uniform_.update(frame.scene.residents(), record.fixedDice);
        else
            adapt(frame, record);
        if (captures_) {  // all vertices, none between grids
            adaptive_.closeGaps();
            uniform_.closeGaps();
        }
        if (switched)
            store().allChanged();
        indices_.provide(grids());
        send(frame.uploader);
        ksquads_ = frame.scene.ksquadCount();
        record.vertexCapacity = vertexCount();
        record.flags |= isUniform ? FRAME_SPANS : 0U;
        if ((record.flags & FRAME_NOTE_VERDICTS) != 0)
            sendVerdicts(frame);
    }

    void forget() override
    {
        store().allChanged();
        indices_.allUnsent();
    }

    void count(gpu::Counters& counters) const override
    {
        std::uint64_t cells = 0;
        std::uint32_t drawn = 0;
        for (const VertexGrid& grid : grids()) {
            cells += grid.cells();
            drawn += grid.u > 0 ? 1 : 0;
        }
        counters.drawn = isUniform_ ? ksquads_ : drawn;
        set(counters.ksdice, cells);
        set(counters.triangles, 2 * cells);
        set(counters.evaluations, evaluations_);
        if (isUniform_)
            return;
        const auto culled = adaptive_.culled();
        std::copy(culled.begin(), culled.end(), counters.culled);
        counters.errorBound = std::bit_cast<std::uint32_t>(static_cast<float>(adaptive_.bound()));
    }

    void compute(VkCommandBuffer commands) const override
    {
        if (!captures_ || vertexCount() == 0)
            return;
        const GroupCount groups = groupsFor(vertexCount(), MESH_ITEMS);
        bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, capture_.get());
        vkCmdDispatch(commands, groups.x, groups.y, 1);
    }

    void draw(VkCommandBuffer commands, std::uint32_t, const TileDraws&) const override
    {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, draw_.get());
        vkCmdBindIndexBuffer(commands, indexBuffer_.get(), 0, VK_INDEX_TYPE_UINT32);
        for (const VertexGrid& grid : grids())
            if (grid.u > 0)
                vkCmdDrawIndexed(commands, static_cast<std::uint32_t>(6 * grid.cells()), 1,
                                 indices_.firstOf(grid), static_cast<std::int32_t>(grid.first), 0);
    }

private:
    static void set(gpu::uint (&words)[2], std::uint64_t number)
    {
        words[0] = static_cast<std::uint32_t>(number);
        words[1] = static_cast<std::uint32_t>(number >> 32U);
    }

    [[nodiscard]] const std::vector<VertexGrid>& grids() const
    {
        return isUniform_ ? uniform_.grids() : adaptive_.grids();
    }
    [[nodiscard]] VertexStore& store() { return isUniform_ ? uniform_.store() : adaptive_.store(); }
    [[nodiscard]] const VertexStore& store() const
    {
        return isUniform_ ? uniform_.store() : adaptive_.store();
    }
    [[nodiscard]] std::uint32_t vertexCount() const
    {
        return static_cast<std::uint32_t>(store().vertices().size());
    }

    void adapt(const PathFrame& frame, const gpu::FrameRecord& record)
    {
        const auto changes =
            scene_.update(frame.scene.residents(), frame.scene.borders(), frame.scene.evaluator());
        auto view = GridView::of(scene_.residents(), frame.camera, frame.width, frame.height,
                                 frame.scene.bounds(), frame.tolerancePx, record.cullBits, frame.sides);
        view.facing = &frame.facing;
        if ((record.flags & FRAME_KEEP_VERDICTS) != 0)
            view.kept = &kept_;
        evaluations_ = adaptive_.update(scene_, changes, view).evaluations;
    }

    // What the modes said is kept here for the frames that follow, and there for the outlines.
    void sendVerdicts(const PathFrame& frame)
    {
        kept_.assign(ksquads_, kNotCulled);
        if (!isUniform_)
            kept_ = adaptive_.culledBy();
        const auto verdicts = frame.uploader.room<std::uint32_t>(frame.verdicts, 0, kept_.size());
        std::transform(kept_.begin(), kept_.end(), verdicts.begin(),
                       [](int mode) { return static_cast<std::uint32_t>(mode + 1); });
    }

    // Room for `count` elements, and for some more to come. True: what the buffer held is gone.
    template <class T>
    bool provide(Uploader& uploader, int binding, Buffer& buffer, size_t count)
    {
        const VkDeviceSize held = buffer.bytes();
        const VkDeviceSize bytes = count * sizeof(T);
        uploader.forget(buffer);
        bindings_.provide(binding, buffer, bytes > held ? bytes + bytes / 4 : bytes);
        return buffer.bytes() != held;
    }

    void send(Uploader& uploader)
    {
        const auto& vertices = store().vertices();
        if (provide<gpu::ObjectVertex>(uploader, BINDING_VERTICES, vertexBuffer_, vertices.size()))
            store().allChanged();
        for (const VertexStore::Range& range : store().takeChanged())
            uploader.write(vertexBuffer_, range.first, std::span(vertices).subspan(range.first, range.count));
        const auto& indices = indices_.indices();
        if (provide<std::uint32_t>(uploader, BINDING_INDICES, indexBuffer_, indices.size()))
            indices_.allUnsent();
        const std::uint32_t first = indices_.takeUnsent();
        uploader.write(indexBuffer_, first, std::span(indices).subspan(first));
    }

    Bindings& bindings_;
    bool captures_;  // vertices are noted down
    Pipeline capture_;
    Pipeline draw_;
    bool isUniform_ = false;
    CpuScene scene_;
    AdaptiveGrids adaptive_;
    std::vector<std::int8_t> kept_;  // by a culling camera that stands still
    UniformGrids uniform_;
    CellIndices indices_;
    Buffer vertexBuffer_;
    Buffer indexBuffer_;
    std::uint32_t ksquads_ = 0;
    std::uint64_t evaluations_ = 0;
};

}  // namespace

PathFactory cpuPath()
{
    return {
        {PathId::cpu,
         "cpu",
         "The processor makes triangles, as fine as the tolerance asks, and keeps those that stay as they "
         "are. fixed:N draws every surface as N by N cells, which may leave gaps, and culls nothing",
         true,
         {{SamplingRule::Kind::bound}, {SamplingRule::Kind::fixed}},
         false},
        [](const Device&) { return std::string(); },
        [](const Device& device, Bindings& bindings, const PathVariant& variant)
            -> std::unique_ptr<SurfacePath> { return std::make_unique<CpuPath>(device, bindings, variant); }};
}

}  // namespace knotspan
