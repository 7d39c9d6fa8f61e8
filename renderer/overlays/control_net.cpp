#include "renderer/overlays/control_net.h"

namespace knotspan {

namespace {

// sRGB with opacity; blue lines and orange points stay apart for colour-blind eyes.
constexpr gpu::vec4 kLineColour{0.42F, 0.66F, 0.95F, 0.75F};
constexpr gpu::vec4 kPointColour{0.98F, 0.86F, 0.42F, 1.0F};
constexpr gpu::vec4 kSelectedColour{1.0F, 0.42F, 0.1F, 1.0F};
constexpr gpu::vec4 kHoverColour{1.0F, 1.0F, 1.0F, 1.0F};
constexpr float kHiddenOpacity = 0.3F;
constexpr float kPointSize = 6.0F;
constexpr float kMarkSize = 10.0F;

}  // namespace

ControlNet::ControlNet(const Device& device, const Bindings& bindings)
    : bindings_(bindings),
      lines_(makeGraphicsPipeline(device, bindings,
                                  {.stages = {"net.vert", "net.frag"},
                                   .topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST,
                                   .overlay = true,
                                   .lines = true})),
      points_(makeGraphicsPipeline(device, bindings,
                                   {.stages = {"net.vert", "net.frag"},
                                    .topology = VK_PRIMITIVE_TOPOLOGY_POINT_LIST,
                                    .overlay = true}))
{
}

void ControlNet::drawNet(VkCommandBuffer commands, std::uint32_t surface, const NurbsSurface& net) const
{
    const auto countU = static_cast<std::uint32_t>(net.countU());
    const auto countV = static_cast<std::uint32_t>(net.countV());
    gpu::OverlayConstants constants{kLineColour, surface, countU, countV, NO_MARK, kPointSize};
    for (const bool hidden : {true, false}) {
        const float opacity = hidden ? kHiddenOpacity : 1.0F;
        constants.colour = kLineColour;
        constants.colour.w *= opacity;
        bindings_.push(commands, &constants, sizeof(constants));
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, lines_.get());
        vkCmdSetDepthCompareOp(commands, hidden ? VK_COMPARE_OP_LESS : VK_COMPARE_OP_GREATER_OR_EQUAL);
        vkCmdDraw(commands, 2 * (countU * (countV - 1) + (countU - 1) * countV), 1, 0, 0);
        constants.colour = kPointColour;
        constants.colour.w *= opacity;
        bindings_.push(commands, &constants, sizeof(constants));
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, points_.get());
        vkCmdSetDepthCompareOp(commands, hidden ? VK_COMPARE_OP_LESS : VK_COMPARE_OP_GREATER_OR_EQUAL);
        vkCmdDraw(commands, countU * countV, 1, 0, 0);
    }
}

void ControlNet::drawMark(VkCommandBuffer commands, std::uint32_t surface, std::uint32_t point,
                          bool selected) const
{
    const gpu::OverlayConstants constants{
        selected ? kSelectedColour : kHoverColour, surface, 0, 0, point, kMarkSize};
    bindings_.push(commands, &constants, sizeof(constants));
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, points_.get());
    vkCmdSetDepthCompareOp(commands, VK_COMPARE_OP_ALWAYS);
    vkCmdDraw(commands, 1, 1, 0, 0);
}

}  // namespace knotspan
