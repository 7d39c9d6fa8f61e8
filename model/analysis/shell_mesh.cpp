#include "model/analysis/shell_mesh.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/analysis/bezier_curves.h"
#include "model/analysis/solid_angles.h"

namespace knotspan {

void ShellMesh::Reach::add(const Reach& other)
{
    box.add(other.box);
    widest = std::max(widest, other.widest);
    apart = std::max(apart, other.apart);
}

ShellMesh::ShellMesh(const std::vector<Member>& members, const CoincidentEdges& edges)
{
    std::vector<Reach> reaches;
    for (const Member& member : members) {
        reaches.push_back(reachOf(member, edges));
        placed_.push_back(placedAs(member, edges));
    }
    reaches_ = Totals<Reach>(reaches);
}

void ShellMesh::replace(size_t k, const Member& member, const CoincidentEdges& edges)
{
    placed_[k] = placedAs(member, edges);
    reaches_.set(k, reachOf(member, edges));
    if (look_)
        replaced_.push_back(k);
}

ShellMesh::Placed ShellMesh::placedAs(const Member& member, const CoincidentEdges& edges)
{
    return {member.part, borderOf(member.surface, edges), member.turned};
}

ShellMesh::Reach ShellMesh::reachOf(const Member& member, const CoincidentEdges& edges)
{
    const Vec3 size = member.part->box().size();
    Reach reach{member.part->box(), std::max({size.x, size.y, size.z}), 0};
    const BorderNumbers& numbers = edges.numbers()[member.surface];
    const CornerGroups& corners = edges.corners();
    for (std::uint32_t k = 0; k < numbers.borderCount(); ++k) {
        const std::uint32_t corner = numbers.firstBorder + k;
        reach.apart = std::max(
            reach.apart, glm::distance(corners.place(corner).at, corners.place(corners.ownerOf(corner)).at));
    }
    return reach;
}

// Twice the tolerance of CoincidentEdges.
double ShellMesh::margin() const
{
    const Reach all = reaches_.all();
    return std::ldexp(all.widest, -20) + all.apart;
}

// No less, and the same while the body's largest part grows a little.
double ShellMesh::proofMargin() const
{
    const double margin = this->margin();
    return margin > 0 ? std::ldexp(1.0, std::ilogb(margin) + 1) : margin;
}

Box ShellMesh::box() const
{
    const Box box = reaches_.all().box;
    return {box.low - Vec3(margin()), box.high + Vec3(margin())};
}

ShellMesh::Border ShellMesh::borderOf(std::uint32_t surface, const CoincidentEdges& edges)
{
    const BorderNumbers& numbers = edges.numbers()[surface];
    Border border;
    const auto add = [&](std::uint32_t corner) {
        border.points.push_back(edges.corners().place(edges.corners().ownerOf(corner)).at);
    };
    for (std::uint32_t k = 0; k < numbers.borderCount(); ++k) {
        border.starts.push_back(static_cast<std::uint32_t>(border.points.size()));
        const std::uint32_t side = numbers.firstBorder + k;
        const auto ends = numbers.cornersOf(k);
        add(ends[0]);
        if (const CoincidentEdge* edge = edges.edgeAlong(side); edge != nullptr) {
            const auto along = std::find_if(edge->members.begin(), edge->members.end(),
                                            [&](const EdgeMember& one) { return one.side == side; });
            const size_t first = border.points.size();
            for (const EdgeCut& cut : edge->cuts)
                if (along->isWithin(cut.at))
                    add(cut.corner);
            if (along->end < along->start)
                std::reverse(border.points.begin() + static_cast<std::ptrdiff_t>(first), border.points.end());
        }
        add(ends[1]);
    }
    border.starts.push_back(static_cast<std::uint32_t>(border.points.size()));
    return border;
}

// One eye's look at a shell. A false return: nothing can be shown.
class ShellMesh::Proof {
public:
    Proof(const Vec3& eye, double reach, int splits)
        : allowed_(splits),
          splits_(splits),
          eye_(eye),
          reach_(reach),
          angles_(eye)
    {
    }

    // Whether the ball and the box meet.
    [[nodiscard]] bool touches(const Box& box) const
    {
        const Vec3 apart = glm::max(glm::max(box.low - eye_, eye_ - box.high), Vec3(0));
        return !(glm::dot(apart, apart) > reach_ * reach_);
    }

    [[nodiscard]] bool add(const Placed& placed)
    {
        angles_.turn(placed.turned);
        if (!touches(placed.part->box())) {
            addRound(placed, 0, 0, placed.part->spansU(), placed.part->spansV());
            return true;
        }
        for (std::uint32_t a = 0; a < placed.part->spansU(); ++a)
            for (std::uint32_t b = 0; b < placed.part->spansV(); ++b) {
                if (!touches(placed.part->box(a, b)))
                    addRound(placed, a, b, a + 1, b + 1);
                else if (!addNear(placed, a, b))
                    return false;
            }
        return true;
    }

    // Of what was added; nothing where that cannot be told.
    [[nodiscard]] std::optional<Seen> seen() const
    {
        const auto turns = angles_.turns();
        return turns ? std::optional(Seen{*turns, allowed_ - splits_}) : std::nullopt;
    }

private:
    using Corners = std::array<Vec3, 4>;  // in the order of a polygon: (0, 0), (1, 0), (1, 1), (0, 1)

    // The polygon round KSQuads [a, endA) x [b, endB): the way of their common border.
    void addRound(const Placed& placed, std::uint32_t a, std::uint32_t b, std::uint32_t endA,
                  std::uint32_t endB)
    {
        angles_.beginPolygon();
        for (std::uint32_t i = a; i < endA; ++i)
            addSide(placed, i, b, false, true);
        for (std::uint32_t j = b; j < endB; ++j)
            addSide(placed, endA, j, true, true);
        for (std::uint32_t i = endA; i > a; --i)
            addSide(placed, i - 1, endB, false, false);
        for (std::uint32_t j = endB; j > b; --j)
            addSide(placed, a, j - 1, true, false);
    }

    // From lattice point (i, j) along v or along u, or the other way; without the last point.
    void addSide(const Placed& placed, std::uint32_t i, std::uint32_t j, bool alongV, bool forwards)
    {
        const std::span<const Vec3> line = borderLine(placed, i, j, alongV);
        if (line.empty())
            angles_.addCorner(
                corner(placed, i + (!forwards && !alongV ? 1 : 0), j + (!forwards && alongV ? 1 : 0)));
        for (size_t k = 0; k + 1 < line.size(); ++k)
            angles_.addCorner(forwards ? line[k] : line[line.size() - 1 - k]);
    }

    // Empty inside the surface.
    [[nodiscard]] static std::span<const Vec3> borderLine(const Placed& placed, std::uint32_t i,
                                                          std::uint32_t j, bool alongV)
    {
        const std::uint32_t m = placed.part->spansU();
        const std::uint32_t n = placed.part->spansV();
        if (alongV && (i == 0 || i == m))
            return placed.border.line(i == 0 ? j : n + j);
        if (!alongV && (j == 0 || j == n))
            return placed.border.line(j == 0 ? 2 * n + i : 2 * n + m + i);
        return {};
    }

    [[nodiscard]] static Vec3 corner(const Placed& placed, std::uint32_t i, std::uint32_t j)
    {
        const std::uint32_t m = placed.part->spansU();
        const std::uint32_t n = placed.part->spansV();
        if (j == 0 || j == n)
            return i < m ? borderLine(placed, i, j, false).front()
                         : borderLine(placed, m - 1, j, false).back();
        if (i == 0 || i == m)
            return borderLine(placed, i, j, true).front();
        return placed.part->corner(i, j);
    }

    [[nodiscard]] bool addNear(const Placed& placed, std::uint32_t a, std::uint32_t b)
    {
        const BezierNet net = placed.part->net(a, b);
        struct {
            Side side;
            std::uint32_t i;
            std::uint32_t j;
            bool forwards;
        } const sides[] = {{Side::startV, a, b, true},
                           {Side::endU, a + 1, b, true},
                           {Side::endV, a, b + 1, false},
                           {Side::startU, a, b, false}};
        // Where others end within a side it has no middle that both sides know: the way between it and its
        // chords must not come near at all.
        for (const auto& side : sides) {
            const bool alongV = side.side == Side::startU || side.side == Side::endU;
            const std::span<const Vec3> line = borderLine(placed, side.i, side.j, alongV);
            if (line.size() <= 2)
                continue;
            if (touches(boundsOf(boundary(net, side.side))))
                return false;
            angles_.beginPolygon();
            for (size_t k = 0; k < line.size(); ++k)
                angles_.addCorner(side.forwards ? line[k] : line[line.size() - 1 - k]);
        }
        return addPiece(net,
                        {corner(placed, a, b), corner(placed, a + 1, b), corner(placed, a + 1, b + 1),
                         corner(placed, a, b + 1)},
                        kDeepest);
    }

    // What the piece adds, bordered by the chords between its corners.
    [[nodiscard]] bool addPiece(const BezierNet& net, const Corners& corners, int deeper)
    {
        if (!touches(boundsOf(net))) {
            angles_.beginPolygon();
            for (const Vec3& corner : corners)
                angles_.addCorner(corner);
            return true;
        }
        if (deeper == 0 || --splits_ < 0)
            return false;
        const auto [low, high] = split(net, Direction::U);
        const auto [lowLow, lowHigh] = split(low, Direction::V);
        const auto [highLow, highHigh] = split(high, Direction::V);
        const Vec3 centre = pointOf(highHigh.points.front());
        const Corners middles = {pointOf(highLow.points.front()), pointOf(highHigh.at(net.degreeU, 0)),
                                 pointOf(highHigh.at(0, net.degreeV)), pointOf(lowHigh.points.front())};
        // Between the chord that a neighbour knows and the two of the finer pieces.
        for (size_t k = 0; k < 4; ++k)
            angles_.addTriangle(corners[k], corners[(k + 1) % 4], middles[k]);
        return addPiece(lowLow, {corners[0], middles[0], centre, middles[3]}, deeper - 1) &&
               addPiece(highLow, {middles[0], corners[1], middles[1], centre}, deeper - 1) &&
               addPiece(highHigh, {centre, middles[1], corners[2], middles[2]}, deeper - 1) &&
               addPiece(lowHigh, {middles[3], centre, middles[2], corners[3]}, deeper - 1);
    }

    static constexpr int kDeepest = 7;
    int allowed_;
    int splits_;

    Vec3 eye_;
    double reach_;
    SolidAngles angles_;
};

namespace {

constexpr int kMostSplits = 2000;

}  // namespace

void ShellMesh::lookAll(const Vec3& eye, double reach) const
{
    look_ = Look{eye, reach, {}, false, 0};
    std::vector<Seen> all;
    int splits = kMostSplits;
    for (size_t k = 0; k < placed_.size(); ++k) {
        Proof proof(eye, reach, splits);
        const auto seen = proof.add(placed_[k]) ? proof.seen() : std::nullopt;
        if (!seen) {
            look_->failed = true;
            look_->failedAt = k;
            return;
        }
        splits -= seen->splits;
        all.push_back(*seen);
    }
    look_->seen = Totals<Seen>(all);
}

// At what was replaced. Where nothing could be shown, members behind those that it failed by make no
// difference.
void ShellMesh::lookAgain() const
{
    const Vec3 eye = look_->eye;
    const double reach = look_->reach;
    for (const size_t k : replaced_) {
        if (look_->failed && k > look_->failedAt)
            continue;
        if (look_->failed) {
            lookAll(eye, reach);
            return;
        }
        const int others = look_->seen.all().splits - look_->seen[k].splits;
        Proof proof(eye, reach, kMostSplits - others);
        const auto seen = proof.add(placed_[k]) ? proof.seen() : std::nullopt;
        if (seen) {
            look_->seen.set(k, *seen);
        } else {
            look_->failed = true;
            look_->failedAt = placed_.size();
        }
    }
}

bool ShellMesh::isOutside(const Vec3& eye, double radius) const
{
    const double reach = radius + proofMargin();
    if (!Proof(eye, reach, 0).touches(box())) {
        look_.reset();
        replaced_.clear();
        return true;
    }
    if (!look_ || look_->eye != eye || look_->reach != reach)
        lookAll(eye, reach);
    else
        lookAgain();
    replaced_.clear();
    return !look_->failed && SolidAngles::wholeTurns(look_->seen.all().turns) == 0;
}

}  // namespace knotspan
