#include "renderer/overlays/edge_lines.h"

#include <algorithm>

namespace knotspan {

namespace {

constexpr std::uint32_t kOutlineColour = 0x0c0e11;
constexpr double kOutlineWidthPx = 1.5;

// Adds lines on one object.
class Adding {
public:
    Adding(const Resident& resident, std::uint32_t colour, double widthPx,
           std::vector<gpu::EdgeLineRecord>& to)
        : surface_(resident.object->surface),
          first_(resident.firstKsquad),
          colour_(colour),
          halfWidth_(static_cast<float>(0.5 * widthPx)),
          to_(to)
    {
    }

    void side(const EdgePart& edge)
    {
        const bool alongV = edge.side == Side::startU || edge.side == Side::endU;
        const bool atEnd = edge.side == Side::endU || edge.side == Side::endV;
        const KnotVector& other = alongV ? surface_.knotsU() : surface_.knotsV();
        across(alongV ? Direction::U : Direction::V, atEnd ? other.spans().back() : other.spans().front(),
               atEnd ? 1 : 0, edge.from, edge.to);
    }

    void iso(Direction direction, double parameter)
    {
        const bool isU = direction == Direction::U;
        const KnotVector& knots = isU ? surface_.knotsU() : surface_.knotsV();
        const KnotVector& other = isU ? surface_.knotsV() : surface_.knotsU();
        const double at = knots.inDomain(parameter);
        const int span = knots.findSpan(at);
        across(direction, span, (at - knots[span]) / (knots[span + 1] - knots[span]), other.domainStart(),
               other.domainEnd());
    }

    void trim(const std::vector<TrimPiece>& pieces, double from, double upTo)
    {
        for (const TrimPiece& piece : pieces) {
            const auto place = [&](double t) {
                return Vec2(glm::mix(piece.u.front(), piece.u.back(), t),
                            glm::mix(piece.v.front(), piece.v.back(), t));
            };
            add(piece.spanU, piece.spanV, (from - piece.from) / (piece.to - piece.from),
                (upTo - piece.from) / (piece.to - piece.from), place);
        }
    }

    void chords(const std::vector<OutlineChord>& chords)
    {
        for (const OutlineChord& chord : chords)
            to_.push_back(
                {first_ + chord.ksquad, gpu::vec2(chord.from), gpu::vec2(chord.to), colour_, halfWidth_});
    }

private:
    // Through all spans of the other direction, the parameter `across` standing still at t of a span.
    void across(Direction direction, int stillSpan, double t, double from, double upTo)
    {
        const bool isU = direction == Direction::U;
        const KnotVector& knots = isU ? surface_.knotsV() : surface_.knotsU();
        for (const int span : knots.spans()) {
            const double start = knots[span];
            const double length = knots[span + 1] - start;
            const auto place = [&](double s) { return isU ? Vec2(t, s) : Vec2(s, t); };
            add(isU ? stillSpan : span, isU ? span : stillSpan, (from - start) / length,
                (upTo - start) / length, place);
        }
    }

    // What of `from` to `upTo` lies between 0 and 1, where the line runs through a KSQuad.
    template <class Place>
    void add(int spanU, int spanV, double from, double upTo, const Place& place)
    {
        from = std::max(from, 0.0);
        upTo = std::min(upTo, 1.0);
        if (!(from < upTo))
            return;
        const std::vector<int>& spansU = surface_.knotsU().spans();
        const std::vector<int>& spansV = surface_.knotsV().spans();
        const auto a = std::lower_bound(spansU.begin(), spansU.end(), spanU) - spansU.begin();
        const auto b = std::lower_bound(spansV.begin(), spansV.end(), spanV) - spansV.begin();
        const auto ksquad =
            static_cast<std::uint32_t>(static_cast<size_t>(a) * spansV.size() + static_cast<size_t>(b));
        to_.push_back({first_ + ksquad, gpu::vec2(place(from)), gpu::vec2(place(upTo)), colour_, halfWidth_});
    }

    const NurbsSurface& surface_;
    std::uint32_t first_;
    std::uint32_t colour_;
    float halfWidth_;
    std::vector<gpu::EdgeLineRecord>& to_;
};

}  // namespace

void EdgeLines::add(const EdgeLine& line, const Resident& resident, std::vector<gpu::EdgeLineRecord>& to)
{
    Adding adding(resident, line.colour, line.widthPx, to);
    if (!line.edge.trim)
        adding.side(line.edge);
    else if (const std::vector<TrimPiece>* pieces =
                 trimLines_.of(line.object, resident.object, *line.edge.trim))
        adding.trim(*pieces, line.edge.from, line.edge.to);
}

void EdgeLines::prepare(const Overlays& overlays, const std::vector<Resident>& residents,
                        const Specialization& specialization)
{
    std::vector<gpu::EdgeLineRecord> records;
    if (overlays.outlines)
        for (const Resident& resident : residents)
            Adding(resident, kOutlineColour, kOutlineWidthPx, records).chords(outlines_.of(resident));
    for (const EdgeLine& line : overlays.edgeLines)
        if (const Resident* resident = findResident(residents, line.object))
            add(line, *resident, records);
    for (const IsoLine& line : overlays.isoLines)
        if (const Resident* resident = findResident(residents, line.object))
            Adding(*resident, line.colour, line.widthPx, records).iso(line.across, line.parameter);
    specialization_ = specialization;
    if (!records.empty() && pipelines_.count(specialization) == 0)
        pipelines_[specialization] = makeGraphicsPipeline(device_, bindings_,
                                                          {.stages = {"edge_line.vert", "edge_line.frag"},
                                                           .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
                                                           .overlay = true,
                                                           .lines = true,
                                                           .specialization = specialization});
    records_.send(std::move(records));
}

void EdgeLines::draw(VkCommandBuffer commands) const
{
    if (records_.isEmpty())
        return;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.at(specialization_).get());
    vkCmdSetDepthCompareOp(commands, VK_COMPARE_OP_GREATER_OR_EQUAL);
    vkCmdDraw(commands, 2 * (EDGE_LINE_SEGMENTS + 1), records_.count(), 0, 0);
}

}  // namespace knotspan
