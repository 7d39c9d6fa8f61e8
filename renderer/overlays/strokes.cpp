#include "renderer/overlays/strokes.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

gpu::StrokeRecord recordOf(const Stroke& stroke)
{
    const auto opacity =
        static_cast<std::uint32_t>(std::lround(255 * std::clamp(stroke.opacity, 0.0F, 1.0F)));
    return {gpu::vec2(stroke.from), gpu::vec2(stroke.to), (stroke.colour & 0xffffffU) | opacity << 24U,
            0.5F * stroke.widthFromPx, 0.5F * stroke.widthToPx};
}

}  // namespace

Strokes::Strokes(const Device& device, Bindings& bindings, Uploader& uploader)
    : rectangles_(makeGraphicsPipeline(device, bindings,
                                       {.stages = {"stroke.vert", "stroke.frag"},
                                        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
                                        .overlay = true,
                                        .specialization = {}})),
      records_(bindings, uploader, BINDING_STROKES)
{
}

void Strokes::prepare(const std::vector<Stroke>& strokes)
{
    std::vector<gpu::StrokeRecord> records;
    records.reserve(strokes.size());
    for (const Stroke& stroke : strokes) {
        const gpu::StrokeRecord record = recordOf(stroke);
        const float length = glm::length(record.to - record.from);
        if (length > 0 && std::isfinite(length))
            records.push_back(record);
    }
    records_.send(std::move(records));
}

void Strokes::draw(VkCommandBuffer commands) const
{
    if (records_.isEmpty())
        return;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, rectangles_.get());
    vkCmdSetDepthCompareOp(commands, VK_COMPARE_OP_ALWAYS);
    vkCmdDraw(commands, 4, records_.count(), 0, 0);
}

}  // namespace knotspan
