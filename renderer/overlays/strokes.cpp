#include "renderer/overlays/strokes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

std::uint32_t packed(std::uint32_t colour, float opacity)
{
    const auto rounded = static_cast<std::uint32_t>(std::lround(255 * std::clamp(opacity, 0.0F, 1.0F)));
    return (colour & 0xffffffU) | rounded << 24U;
}

// The shader divides by the length of each side.
bool isDrawable(const gpu::StrokeRecord& record)
{
    for (int k = 0; k < 4; ++k) {
        const float length = glm::length(record.corners[(k + 1) % 4] - record.corners[k]);
        if (!(length > 0) || !std::isfinite(length))
            return false;
    }
    return true;
}

gpu::StrokeRecord recordOf(const Stroke& stroke)
{
    constexpr float kPoint = 0.02F;  // what tapers to nothing ends so wide
    const Vec2 whole = stroke.to - stroke.from;
    const Vec2 across = Vec2(-whole.y, whole.x) / glm::length(whole);
    const Vec2 from = across * (0.5 * std::max(stroke.widthFromPx, kPoint));
    const Vec2 to = across * (0.5 * std::max(stroke.widthToPx, kPoint));
    return {{gpu::vec2(stroke.from - from), gpu::vec2(stroke.to - to), gpu::vec2(stroke.to + to),
             gpu::vec2(stroke.from + from)},
            packed(stroke.colour, stroke.opacity)};
}

// Around it as strokes are, whichever way it came.
gpu::StrokeRecord recordOf(const Patch& patch)
{
    const auto& at = patch.corners;
    double area = 0;
    for (size_t k = 0; k < 4; ++k) {
        const Vec2& next = at[(k + 1) % 4];
        area += at[k].x * next.y - at[k].y * next.x;
    }
    gpu::StrokeRecord record{{}, packed(patch.colour, patch.opacity)};
    for (size_t k = 0; k < 4; ++k)
        record.corners[k] = gpu::vec2(at[area > 0 ? k : 3 - k]);
    return record;
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

void Strokes::prepare(const std::vector<Patch>& patches, const std::vector<Stroke>& strokes)
{
    std::vector<gpu::StrokeRecord> records;
    records.reserve(patches.size() + strokes.size());
    const auto add = [&records](const auto& shape) {
        const gpu::StrokeRecord record = recordOf(shape);
        if (isDrawable(record))
            records.push_back(record);
    };
    std::for_each(patches.begin(), patches.end(), add);
    std::for_each(strokes.begin(), strokes.end(), add);
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
