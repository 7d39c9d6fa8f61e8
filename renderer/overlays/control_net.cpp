#include "renderer/overlays/control_net.h"

namespace knotspan {

namespace {

// sRGB with opacity; blue lines and orange points stay apart for colour-blind eyes.
constexpr gpu::vec4 kLineColour{0.42F, 0.66F, 0.95F, 0.75F};
constexpr gpu::vec4 kPointColour{0.98F, 0.86F, 0.42F, 1.0F};
constexpr float kHiddenOpacity = 0.3F;
constexpr float kPointSize = 6.0F;

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

void ControlNet::draw(VkCommandBuffer commands, std::uint32_t surface, const NurbsSurface& net,
                      Parts parts) const
{
    const auto countU = static_cast<std::uint32_t>(net.countU());
    const auto countV = static_cast<std::uint32_t>(net.countV());
    for (const bool hidden : {true, false}) {
        if (parts.hulls)
            drawPart(commands, lines_, {kLineColour, surface, countU, countV, 0}, hidden,
                     2 * (countU * (countV - 1) + (countU - 1) * countV));
        if (parts.points)
            drawPart(commands, points_, {kPointColour, surface, countU, countV, kPointSize}, hidden,
                     countU * countV);
    }
}

void ControlNet::drawPart(VkCommandBuffer commands, const Pipeline& pipeline, gpu::OverlayConstants constants,
                          bool hidden, std::uint32_t vertices) const
{
    constants.colour.w *= hidden ? kHiddenOpacity : 1.0F;
    bindings_.push(commands, &constants, sizeof(constants));
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get());
    vkCmdSetDepthCompareOp(commands, hidden ? VK_COMPARE_OP_LESS : VK_COMPARE_OP_GREATER_OR_EQUAL);
    vkCmdDraw(commands, vertices, 1, 0, 0);
}

}  // namespace knotspan
