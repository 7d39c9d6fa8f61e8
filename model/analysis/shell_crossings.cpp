#include "model/analysis/shell_crossings.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "model/analysis/shell_pieces.h"

namespace knotspan {

namespace {

struct KsQuadPlace {
    std::uint32_t surface = 0;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    bool fresh = false;
    bool hasJoint = false;  // others end within its sides
    Box box;
    std::vector<std::uint32_t> corners{};  // on the border: groups' owners, those within its sides too
};

// `quads` are all of the surface.
void addCorners(std::vector<KsQuadPlace>& quads, std::uint32_t surface, const CoincidentEdges& edges)
{
    const BorderNumbers& numbers = edges.numbers()[surface];
    for (std::uint32_t k = 0; k < numbers.borderCount(); ++k) {
        KsQuadPlace& quad = quads[numbers.sideName(k) / 4 - numbers.firstKsquad];
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

// Whether KSQuad (a, b) is another than it was; where nothing was, it is.
bool isFresh(const ShellPart& now, const ShellPart* before, std::uint32_t a, std::uint32_t b)
{
    return before == nullptr || !now.isSameAt(a, b, *before);
}

// Around those KSQuads.
Box changedBox(const ShellPart& now, const ShellPart* before)
{
    if (before == nullptr)
        return now.box();
    Box box;
    for (std::uint32_t a = 0; a < now.spansU(); ++a)
        for (std::uint32_t b = 0; b < now.spansV(); ++b)
            if (isFresh(now, before, a, b))
                box.add(now.box(a, b));
    return box;
}

// The KSQuads of a surface that come near what changed.
template <class Test>
void addQuads(std::vector<KsQuadPlace>& quads, std::uint32_t surface, const ShellCrossings::Body& body,
              const Box& changed, const Test& isFreshAt)
{
    const ShellPart& part = *body.parts[surface];
    std::vector<KsQuadPlace> all;
    for (std::uint32_t a = 0; a < part.spansU(); ++a)
        for (std::uint32_t b = 0; b < part.spansV(); ++b)
            all.push_back({surface, a, b, false, false, part.box(a, b), {}});
    addCorners(all, surface, body.edges);
    for (KsQuadPlace& quad : all)
        if (meet(quad.box, changed)) {
            quad.fresh = isFreshAt(quad.a, quad.b);
            quads.push_back(std::move(quad));
        }
}

using Place = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // surface, a, b
struct CutPiece {
    std::shared_ptr<const ShellPart> part;
    std::unique_ptr<Piece> piece;
};
using CutPieces = std::map<Place, CutPiece>;

class Sweep {
public:
    // `cut`: pieces that may be at hand already.
    Sweep(std::vector<KsQuadPlace> quads, const ShellCrossings::Parts& parts, double margin, CutPieces cut)
        : quads_(std::move(quads)),
          pieces_(quads_.size()),
          parts_(parts),
          margin_(margin),
          cut_(std::move(cut))
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
            if (quads_.size() > kFew)
                pieces_[k].reset();
        }
        return true;
    }

    // The pieces of a small sweep; of a large one none.
    [[nodiscard]] CutPieces takePieces()
    {
        CutPieces taken;
        for (size_t k = 0; k < quads_.size(); ++k)
            if (pieces_[k] != nullptr && quads_.size() <= kFew)
                taken[placeOf(k)] = {parts_[quads_[k].surface], std::move(pieces_[k])};
        return taken;
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
        return !areApart(piece(k), piece(l));
    }

    [[nodiscard]] Piece& piece(size_t k)
    {
        const KsQuadPlace& quad = quads_[k];
        if (pieces_[k] != nullptr)
            return *pieces_[k];
        if (const auto cut = cut_.find(placeOf(k)); cut != cut_.end() && isStill(cut->second, quad))
            pieces_[k] = std::move(cut->second.piece);
        else
            pieces_[k] = std::make_unique<Piece>(parts_[quad.surface]->net(quad.a, quad.b));
        return *pieces_[k];
    }
    [[nodiscard]] Place placeOf(size_t k) const { return {quads_[k].surface, quads_[k].a, quads_[k].b}; }
    [[nodiscard]] bool isStill(const CutPiece& cut, const KsQuadPlace& quad) const
    {
        const ShellPart& part = *parts_[quad.surface];
        return cut.part.get() == &part || part.isSameAt(quad.a, quad.b, *cut.part);
    }

    static constexpr size_t kFew = 1024;

    std::vector<KsQuadPlace> quads_;
    std::vector<std::unique_ptr<Piece>> pieces_;
    const ShellCrossings::Parts& parts_;
    double margin_;
    CutPieces cut_;
};

}  // namespace

struct ShellCrossings::Kept {
    CutPieces pieces;
};

// The surfaces that it has not seen so, or not in this shell; now it has.
std::vector<ShellCrossings::Fresh> ShellCrossings::noteChanged(const Body& body)
{
    const auto now = std::make_shared<const Indices>(body.surfaces);
    std::vector<Fresh> changed;
    std::shared_ptr<const Indices> same;  // the last one that was found to be the same shell
    for (const std::uint32_t surface : body.surfaces) {
        Seen& seen = seen_[surface];
        const bool sameShell = seen.shell != nullptr && (seen.shell == same || *seen.shell == body.surfaces);
        if (sameShell)
            same = seen.shell;
        if (!sameShell || seen.part != body.parts[surface])
            changed.push_back({surface, sameShell ? seen.part : nullptr});
        seen = {body.parts[surface], now};
    }
    return changed;
}

bool ShellCrossings::look(const Body& body)
{
    seen_.resize(body.parts.size());
    return sweep(body, noteChanged(body));
}

bool ShellCrossings::lookAgain(const Body& body, const Indices& changed)
{
    if (gaveUp_.count(body.surfaces.front()) != 0)
        return look(body);
    std::vector<Fresh> fresh;
    for (const std::uint32_t surface : changed)
        fresh.push_back({surface, std::exchange(seen_[surface].part, body.parts[surface])});
    return sweep(body, std::move(fresh));
}

bool ShellCrossings::sweep(const Body& body, std::vector<Fresh> fresh)
{
    std::sort(fresh.begin(), fresh.end(),
              [](const Fresh& one, const Fresh& other) { return one.surface < other.surface; });
    const auto find = [&](std::uint32_t surface) {
        const auto found =
            std::lower_bound(fresh.begin(), fresh.end(), surface,
                             [](const Fresh& one, std::uint32_t wanted) { return one.surface < wanted; });
        return found != fresh.end() && found->surface == surface ? &*found : nullptr;
    };
    // What crossed somebody is looked at as a whole, because it may no longer do so.
    std::erase_if(crossing_, [&](const auto& pair) {
        Fresh* const both[] = {find(pair.first), find(pair.second)};
        for (Fresh* one : both)
            if (one != nullptr)
                one->before = nullptr;
        return both[0] != nullptr || both[1] != nullptr;
    });
    Box changed;
    for (const Fresh& one : fresh)
        changed.add(changedBox(*body.parts[one.surface], one.before.get()));
    std::vector<KsQuadPlace> quads;
    body.mesh.visitWhere([&](const Box& box) { return meet(box, changed); },
                         [&](size_t member) {
                             const std::uint32_t surface = body.surfaces[member];
                             const Fresh* const one = find(surface);
                             addQuads(quads, surface, body, changed, [&](std::uint32_t a, std::uint32_t b) {
                                 return one != nullptr &&
                                        isFresh(*body.parts[surface], one->before.get(), a, b);
                             });
                         });
    if (kept_ == nullptr)
        kept_ = std::make_shared<Kept>();
    Sweep sweep(std::move(quads), body.parts, body.mesh.margin(), std::move(kept_->pieces));
    const bool ran = sweep.run(crossing_);
    kept_->pieces = sweep.takePieces();
    if (!ran) {
        for (const Fresh& one : fresh)
            seen_[one.surface] = {};
        gaveUp_.insert(body.surfaces.front());
        return false;
    }
    gaveUp_.erase(body.surfaces.front());
    return std::none_of(crossing_.begin(), crossing_.end(), [&](const auto& pair) {
        return std::binary_search(body.surfaces.begin(), body.surfaces.end(), pair.first) &&
               std::binary_search(body.surfaces.begin(), body.surfaces.end(), pair.second);
    });
}

}  // namespace knotspan
