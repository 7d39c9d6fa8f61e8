#include "renderer/overlays/marks.h"

namespace knotspan {

Marks::Marks(const Device& device, Bindings& bindings, Uploader& uploader)
    : points_(makeGraphicsPipeline(device, bindings,
                                   {.stages = {"mark.vert", "mark.frag"},
                                    .topology = VK_PRIMITIVE_TOPOLOGY_POINT_LIST,
                                    .overlay = true,
                                    .specialization = {}})),
      records_(bindings, uploader, BINDING_MARKS)
{
}

void Marks::prepare(const std::vector<ControlPointMark>& marks, const std::vector<Resident>& residents)
{
    std::vector<gpu::MarkRecord> records;
    records.reserve(marks.size());
    for (const ControlPointMark& mark : marks) {
        const Resident* resident = findResident(residents, mark.object);
        if (resident == nullptr)
            continue;
        const NurbsSurface& net = resident->object->surface;
        const auto [i, j] = mark.index;
        if (i >= 0 && i < net.countU() && j >= 0 && j < net.countV())
            records.push_back({static_cast<std::uint32_t>(resident - residents.data()),
                               static_cast<std::uint32_t>(i * net.countV() + j), mark.colour, mark.sizePx});
    }
    records_.send(std::move(records));
}

void Marks::draw(VkCommandBuffer commands) const
{
    if (records_.isEmpty())
        return;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, points_.get());
    vkCmdSetDepthCompareOp(commands, VK_COMPARE_OP_ALWAYS);
    vkCmdDraw(commands, records_.count(), 1, 0, 0);
}

}  // namespace knotspan
