#include "renderer/overlays/edge_lines.h"

#include <algorithm>
#include <cstring>

namespace knotspan {

namespace {

// Adds lines on one object.
class Adding {
public:
    Adding(const Resident& resident, const EdgeLine& line, std::vector<gpu::EdgeLineRecord>& to)
        : surface_(resident.object->surface),
          first_(resident.firstKsquad),
          line_(line),
          to_(to)
    {
    }

    void side()
    {
        const EdgePart& edge = line_.edge;
        const bool alongV = edge.side == Side::startU || edge.side == Side::endU;
        const double across = edge.side == Side::endU || edge.side == Side::endV ? 1 : 0;
        const KnotVector& knots = alongV ? surface_.knotsV() : surface_.knotsU();
        const KnotVector& other = alongV ? surface_.knotsU() : surface_.knotsV();
        const int otherSpan = across > 0 ? other.spans().back() : other.spans().front();
        for (const int span : knots.spans()) {
            const auto place = [&](double t) { return alongV ? Vec2(across, t) : Vec2(t, across); };
            add(alongV ? otherSpan : span, alongV ? span : otherSpan, knots[span], knots[span + 1], place);
        }
    }

    void trim(const std::vector<TrimPiece>& pieces)
    {
        for (const TrimPiece& piece : pieces) {
            const auto place = [&](double t) {
                return Vec2(glm::mix(piece.u.front(), piece.u.back(), t),
                            glm::mix(piece.v.front(), piece.v.back(), t));
            };
            add(piece.spanU, piece.spanV, piece.from, piece.to, place);
        }
    }

private:
    // What of `start` to `end`, where the edge runs through a KSQuad, belongs to the line.
    template <class Place>
    void add(int spanU, int spanV, double start, double end, const Place& place)
    {
        const double from = std::max((line_.edge.from - start) / (end - start), 0.0);
        const double upTo = std::min((line_.edge.to - start) / (end - start), 1.0);
        if (!(from < upTo))
            return;
        const std::vector<int>& spansU = surface_.knotsU().spans();
        const std::vector<int>& spansV = surface_.knotsV().spans();
        const auto a = std::lower_bound(spansU.begin(), spansU.end(), spanU) - spansU.begin();
        const auto b = std::lower_bound(spansV.begin(), spansV.end(), spanV) - spansV.begin();
        const auto ksquad =
            static_cast<std::uint32_t>(static_cast<size_t>(a) * spansV.size() + static_cast<size_t>(b));
        to_.push_back({first_ + ksquad, gpu::vec2(place(from)), gpu::vec2(place(upTo)), line_.colour,
                       static_cast<float>(0.5 * line_.widthPx)});
    }

    const NurbsSurface& surface_;
    std::uint32_t first_;
    const EdgeLine& line_;
    std::vector<gpu::EdgeLineRecord>& to_;
};

bool isSame(const std::vector<gpu::EdgeLineRecord>& a, const std::vector<gpu::EdgeLineRecord>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a.front())) == 0);
}

}  // namespace

void EdgeLines::add(const EdgeLine& line, const Resident& resident, std::vector<gpu::EdgeLineRecord>& to)
{
    Adding adding(resident, line, to);
    if (!line.edge.trim)
        adding.side();
    else if (const std::vector<TrimPiece>* pieces =
                 trimLines_.of(line.object, resident.object, *line.edge.trim))
        adding.trim(*pieces);
}

void EdgeLines::prepare(const std::vector<EdgeLine>& lines, const std::vector<Resident>& residents,
                        const Specialization& specialization)
{
    std::vector<gpu::EdgeLineRecord> records;
    for (const EdgeLine& line : lines)
        if (const Resident* resident = findResident(residents, line.object))
            add(line, *resident, records);
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
