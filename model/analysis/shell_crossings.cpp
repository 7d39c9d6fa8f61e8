#include "model/analysis/shell_crossings.h"

#include <algorithm>
#include <array>
#include <limits>

#include <glm/geometric.hpp>

#include "model/analysis/bezier_curves.h"

namespace knotspan {

namespace {

// How far a net reaches in each of thirteen directions, both ways.
class Slabs {
public:
    explicit Slabs(const BezierNet& net)
    {
        low_.fill(std::numeric_limits<double>::infinity());
        high_.fill(-std::numeric_limits<double>::infinity());
        for (const Vec4& homogeneous : net.points) {
            const Vec3 p = pointOf(homogeneous);
            const std::array<double, kCount> along = {p.x,
                                                      p.y,
                                                      p.z,
                                                      p.x + p.y,
                                                      p.x - p.y,
                                                      p.x + p.z,
                                                      p.x - p.z,
                                                      p.y + p.z,
                                                      p.y - p.z,
                                                      p.x + p.y + p.z,
                                                      p.x + p.y - p.z,
                                                      p.x - p.y + p.z,
                                                      p.x - p.y - p.z};
            for (size_t k = 0; k < kCount; ++k) {
                low_[k] = std::min(low_[k], along[k]);
                high_[k] = std::max(high_[k], along[k]);
            }
        }
    }

    // False where some number is none.
    [[nodiscard]] bool areApart(const Slabs& other) const
    {
        for (size_t k = 0; k < kCount; ++k)
            if (low_[k] > other.high_[k] || other.low_[k] > high_[k])
                return true;
        return false;
    }
    [[nodiscard]] double size() const
    {
        return high_[0] - low_[0] + (high_[1] - low_[1]) + (high_[2] - low_[2]);
    }

private:
    static constexpr size_t kCount = 13;
    std::array<double, kCount> low_{};
    std::array<double, kCount> high_{};
};

// A part of a KSQuad; its quarters are made when they are asked for.
class Piece {
public:
    explicit Piece(BezierNet of) : net_(std::move(of)), slabs_(net_)
    {
        for (size_t k = 0; k < 4; ++k)
            corners_[k] = pointOf(net_.at(k % 2 == 0 ? 0 : net_.degreeU, k < 2 ? 0 : net_.degreeV));
    }

    [[nodiscard]] const Slabs& slabs() const { return slabs_; }
    [[nodiscard]] const std::vector<Piece>& quarters()
    {
        if (!quarters_.empty())
            return quarters_;
        const auto [low, high] = split(net_, Direction::U);
        for (const BezierNet* half : {&low, &high}) {
            auto [first, second] = split(*half, Direction::V);
            quarters_.emplace_back(std::move(first));
            quarters_.emplace_back(std::move(second));
        }
        return quarters_;
    }
    // Slabs, or a plane along one of both, keep them apart.
    [[nodiscard]] bool isApartFrom(const Piece& other) const
    {
        return slabs_.areApart(other.slabs_) || areApartAlong(across(), *this, other) ||
               areApartAlong(other.across(), *this, other);
    }
    [[nodiscard]] bool sharesCorner(const Piece& other, double margin) const
    {
        for (const Vec3& one : corners_)
            for (const Vec3& another : other.corners_)
                if (glm::dot(one - another, one - another) <= margin * margin)
                    return true;
        return false;
    }

private:
    // Across its diagonals.
    [[nodiscard]] Vec3 across() const
    {
        return glm::cross(corners_[3] - corners_[0], corners_[2] - corners_[1]);
    }
    [[nodiscard]] static bool areApartAlong(const Vec3& direction, const Piece& one, const Piece& other)
    {
        const auto [low, high] = one.reach(direction);
        const auto [otherLow, otherHigh] = other.reach(direction);
        return low > otherHigh || otherLow > high;
    }
    [[nodiscard]] std::pair<double, double> reach(const Vec3& direction) const
    {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const Vec4& point : net_.points) {
            const double along = glm::dot(direction, pointOf(point));
            low = std::min(low, along);
            high = std::max(high, along);
        }
        return {low, high};
    }

    BezierNet net_;
    Slabs slabs_;
    std::array<Vec3, 4> corners_{};
    std::vector<Piece> quarters_;
};

// `splits` are those that it may still take.
bool areApart(const Piece& a, const Piece& b, int& splits)
{
    if (a.isApartFrom(b))
        return true;
    if (--splits < 0)
        return false;
    const bool cutA = a.slabs().size() > b.slabs().size();
    Piece cut = cutA ? a : b;
    for (const Piece& quarter : cut.quarters())
        if (!areApart(quarter, cutA ? b : a, splits))
            return false;
    return true;
}

constexpr int kSplits = 200;

// Of KSQuads beside each other, or of one KSQuad alone: all quarters that have no corner in common.
bool areApartButForCorners(Piece& a, Piece& b, double margin)
{
    for (const Piece& one : a.quarters())
        for (const Piece& other : b.quarters()) {
            int splits = kSplits;
            if (!one.slabs().areApart(other.slabs()) && !one.sharesCorner(other, margin) &&
                !areApart(one, other, splits))
                return false;
        }
    return true;
}

struct KsQuadPlace {
    std::uint32_t surface = 0;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    bool fresh = false;
    bool hasJoint = false;  // others end within its sides
    Box box;
    std::vector<std::uint32_t> corners{};  // on the border: groups' owners, those within its sides too
};

void addCorners(std::vector<KsQuadPlace>& quads, size_t first, std::uint32_t surface,
                const CoincidentEdges& edges)
{
    const BorderNumbers& numbers = edges.numbers()[surface];
    for (std::uint32_t k = 0; k < numbers.borderCount(); ++k) {
        KsQuadPlace& quad = quads[first + numbers.sideName(k) / 4 - numbers.firstKsquad];
        for (const std::uint32_t corner : numbers.cornersOf(k))
            quad.corners.push_back(edges.corners().ownerOf(corner));
        const CoincidentEdge* edge = edges.edgeAlong(numbers.firstBorder + k);
        if (edge == nullptr)
            continue;
        const auto along = std::find_if(edge->members.begin(), edge->members.end(),
                                        [&](const auto& one) { return one.side == numbers.firstBorder + k; });
        for (const EdgeCut& cut : edge->cuts)
            if (along->isWithin(cut.at)) {
                quad.corners.push_back(cut.corner);
                quad.hasJoint = true;
            }
    }
}

bool areNeighbours(const KsQuadPlace& one, const KsQuadPlace& other)
{
    const auto near = [](std::uint32_t x, std::uint32_t y) { return std::max(x, y) - std::min(x, y) <= 1; };
    if (one.surface == other.surface && near(one.a, other.a) && near(one.b, other.b))
        return true;
    return std::find_first_of(one.corners.begin(), one.corners.end(), other.corners.begin(),
                              other.corners.end()) != one.corners.end();
}

bool meet(const Box& one, const Box& other)
{
    for (int axis = 0; axis < 3; ++axis)
        if (one.low[axis] > other.high[axis] || other.low[axis] > one.high[axis])
            return false;
    return true;
}

class Sweep {
public:
    Sweep(std::vector<KsQuadPlace> quads, const ShellCrossings::Parts& parts, double margin)
        : quads_(std::move(quads)),
          pieces_(quads_.size()),
          parts_(parts),
          margin_(margin)
    {
        std::sort(quads_.begin(), quads_.end(), [](const KsQuadPlace& one, const KsQuadPlace& other) {
            return one.box.low.x < other.box.low.x;
        });
    }

    // Adds all pairs of surfaces that may cross; false: there were so many that it gave up.
    [[nodiscard]] bool run(std::set<std::pair<std::uint32_t, std::uint32_t>>& crossing)
    {
        constexpr size_t kMany = 64;
        for (size_t k = 0; k < quads_.size(); ++k) {
            // Along x each one meets those that begin before it ends.
            for (size_t l = k + 1; l < quads_.size() && quads_[l].box.low.x <= quads_[k].box.high.x; ++l) {
                if ((!quads_[k].fresh && !quads_[l].fresh) || !meet(quads_[k].box, quads_[l].box))
                    continue;
                const auto pair = std::minmax(quads_[k].surface, quads_[l].surface);
                if (crossing.count(pair) == 0 && mayCross(k, l))
                    crossing.insert(pair);
                if (crossing.size() > kMany)
                    return false;
            }
            pieces_[k].reset();
        }
        return true;
    }

private:
    [[nodiscard]] bool mayCross(size_t k, size_t l)
    {
        const bool neighbours = areNeighbours(quads_[k], quads_[l]);
        // Where others end within a side the quarters' corners do not lie together.
        if (neighbours && (quads_[k].hasJoint || quads_[l].hasJoint))
            return false;
        if (neighbours)
            return !areApartButForCorners(piece(k), piece(l), margin_);
        int splits = kSplits;
        return !areApart(piece(k), piece(l), splits);
    }

    [[nodiscard]] Piece& piece(size_t k)
    {
        const KsQuadPlace& quad = quads_[k];
        if (pieces_[k] == nullptr)
            pieces_[k] = std::make_unique<Piece>(parts_[quad.surface]->net(quad.a, quad.b));
        return *pieces_[k];
    }

    std::vector<KsQuadPlace> quads_;
    std::vector<std::unique_ptr<Piece>> pieces_;
    const ShellCrossings::Parts& parts_;
    double margin_;
};

}  // namespace

// What was known of surfaces that changed. Returns the box around them.
Box ShellCrossings::dropChanged(const std::vector<std::uint32_t>& shell, const Parts& parts)
{
    seen_.resize(parts.size());
    fresh_.assign(parts.size(), 0);
    const auto now = std::make_shared<const std::vector<std::uint32_t>>(shell);
    Box changed;
    for (const std::uint32_t surface : shell) {
        Seen& seen = seen_[surface];
        const bool fresh = seen.part != parts[surface] || *seen.shell != shell;
        seen = {parts[surface], now};
        if (!fresh)
            continue;
        fresh_[surface] = 1;
        changed.add(parts[surface]->box());
    }
    std::erase_if(crossing_,
                  [this](const auto& pair) { return fresh_[pair.first] != 0 || fresh_[pair.second] != 0; });
    return changed;
}

bool ShellCrossings::lookAgain(const std::vector<std::uint32_t>& shell, const Parts& parts,
                               const CoincidentEdges& edges, double margin)
{
    const Box changed = dropChanged(shell, parts);
    std::vector<KsQuadPlace> quads;
    for (const std::uint32_t surface : shell) {
        const ShellPart& part = *parts[surface];
        if (!meet(part.box(), changed))
            continue;
        const size_t first = quads.size();
        for (std::uint32_t a = 0; a < part.spansU(); ++a)
            for (std::uint32_t b = 0; b < part.spansV(); ++b)
                quads.push_back({surface, a, b, fresh_[surface] != 0, false, part.box(a, b)});
        addCorners(quads, first, surface, edges);
    }
    if (!Sweep(std::move(quads), parts, margin).run(crossing_)) {
        for (const std::uint32_t surface : shell)
            if (fresh_[surface] != 0)
                seen_[surface] = {};
        return false;
    }
    return std::none_of(crossing_.begin(), crossing_.end(), [&](const auto& pair) {
        return std::binary_search(shell.begin(), shell.end(), pair.first) &&
               std::binary_search(shell.begin(), shell.end(), pair.second);
    });
}

}  // namespace knotspan
