// RPNS uniform (Concheiro et al. 2014): KSQuads as patches, the control stage decides how many KSDice each
// gets, the evaluation stage computes the surface.
#include "renderer/paths/surface_path.h"

#include <algorithm>

namespace knotspan {

namespace {

class TessellationPath : public SurfacePath {
public:
    TessellationPath(const Device& device, const Bindings& bindings, Evaluator evaluator)
        : device_(device),
          pipeline_(makeGraphicsPipeline(
              device, bindings,
              {.stages = {"tessellation.vert", "tessellation.tesc", "tessellation.tese", "surface.frag"},
               .topology = VK_PRIMITIVE_TOPOLOGY_PATCH_LIST,
               .evaluator = static_cast<std::uint32_t>(evaluator)}))
    {
    }

    [[nodiscard]] bool takesVisibleList() const override { return true; }
    [[nodiscard]] SamplingRule defaultSampling() const override { return {SamplingRule::Kind::area, 0}; }
    [[nodiscard]] bool supports(SamplingRule rule) const override
    {
        const auto most = static_cast<int>(device_.abilities().maxTessellationLevel);
        return rule.kind == SamplingRule::Kind::area ||
               (rule.kind == SamplingRule::Kind::fixed && rule.count <= most);
    }

    [[nodiscard]] std::uint32_t ksquadsPerDraw(SamplingRule rule) const override
    {
        const std::uint32_t vertices = device_.abilities().tessellatedVerticesPerDraw;
        if (vertices == 0)
            return ~0U;
        const std::uint32_t side =
            1 + (rule.kind == SamplingRule::Kind::fixed ? static_cast<std::uint32_t>(rule.count)
                                                        : device_.abilities().maxTessellationLevel);
        constexpr std::uint32_t kMeasuredBest = 64;  // there the cost of a draw grows faster than its patches
        return std::clamp(vertices / (side * side), 1U, kMeasuredBest);
    }

    void draw(VkCommandBuffer commands, std::uint32_t, const VisibleDraws& visible) const override
    {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
        constexpr std::uint32_t kStride = sizeof(VkDrawIndirectCommand);
        const std::uint32_t most = device_.limits().maxDrawIndirectCount;
        for (std::uint32_t first = 0; first < visible.count; first += most)
            vkCmdDrawIndirect(commands, visible.draws, static_cast<VkDeviceSize>(first) * kStride,
                              std::min(most, visible.count - first), kStride);
    }

private:
    const Device& device_;
    Pipeline pipeline_;
};

}  // namespace

PathFactory tessellationPath()
{
    return {{PathId::tessellation, "tessellation",
             "Tessellation stages, KSQuads as patches, finer where they are larger", true},
            [](const Device& device) { return device.abilities().noTessellation; },
            [](const Device& device, const Bindings& bindings,
               Evaluator evaluator) -> std::unique_ptr<SurfacePath> {
                return std::make_unique<TessellationPath>(device, bindings, evaluator);
            }};
}

}  // namespace knotspan
