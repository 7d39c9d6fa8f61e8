#include "renderer/overlays/edge_lines.h"

#include <algorithm>
#include <cstring>

namespace knotspan {

namespace {

void addParts(const EdgeLine& line, const Resident& resident, std::vector<gpu::EdgeLineRecord>& to)
{
    const NurbsSurface& surface = resident.object->surface;
    const bool alongV = line.side == Side::startU || line.side == Side::endU;
    const bool atEnd = line.side == Side::endU || line.side == Side::endV;
    const KnotVector& knots = alongV ? surface.knotsV() : surface.knotsU();
    const auto spansU = static_cast<std::uint32_t>(surface.knotsU().spans().size());
    const auto spansV = static_cast<std::uint32_t>(surface.knotsV().spans().size());
    std::uint32_t ksquad = resident.firstKsquad;
    if (atEnd)
        ksquad += alongV ? (spansU - 1) * spansV : spansV - 1;
    for (const int span : knots.spans()) {
        const double start = knots[span];
        const double length = knots[span + 1] - start;
        const double from = std::max((line.from - start) / length, 0.0);
        const double to1 = std::min((line.to - start) / length, 1.0);
        if (from < to1)
            to.push_back({ksquad, static_cast<std::uint32_t>(line.side), static_cast<float>(from),
                          static_cast<float>(to1), line.colour, static_cast<float>(0.5 * line.widthPx)});
        ksquad += alongV ? 1 : spansV;
    }
}

bool isSame(const std::vector<gpu::EdgeLineRecord>& a, const std::vector<gpu::EdgeLineRecord>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a.front())) == 0);
}

}  // namespace

void EdgeLines::prepare(const std::vector<EdgeLine>& lines, const std::vector<Resident>& residents,
                        const Specialization& specialization)
{
    std::vector<gpu::EdgeLineRecord> records;
    for (const EdgeLine& line : lines)
        if (const Resident* resident = findResident(residents, line.object))
            addParts(line, *resident, records);
    specialization_ = specialization;
    if (records.empty()) {
        held_.clear();
        return;
    }
    if (pipelines_.count(specialization) == 0)
        pipelines_[specialization] = makeGraphicsPipeline(device_, bindings_,
                                                          {.stages = {"edge_line.vert", "edge_line.frag"},
                                                           .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
                                                           .overlay = true,
                                                           .lines = true,
                                                           .specialization = specialization});
    if (isSame(records, held_))
        return;
    uploader_.forget(buffer_);
    bindings_.provide(BINDING_EDGE_LINES, buffer_, records.size() * sizeof(gpu::EdgeLineRecord));
    uploader_.write(buffer_, 0, std::span(std::as_const(records)));
    held_ = std::move(records);
}

void EdgeLines::draw(VkCommandBuffer commands) const
{
    if (held_.empty())
        return;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.at(specialization_).get());
    vkCmdSetDepthCompareOp(commands, VK_COMPARE_OP_GREATER_OR_EQUAL);
    vkCmdDraw(commands, 2 * (EDGE_LINE_SEGMENTS + 1), static_cast<std::uint32_t>(held_.size()), 0, 0);
}

}  // namespace knotspan
