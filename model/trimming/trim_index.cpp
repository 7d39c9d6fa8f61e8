#include "model/trimming/trim_index.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "model/trimming/float_piece.h"
#include "shaders/shared/trimming.glsl"

namespace knotspan {

namespace {

constexpr size_t kMostEntries = size_t{1} << 21U;
constexpr int kMostBandsAtWill = 16;  // for each piece, beyond those that must be

struct Source {
    const std::vector<std::uint32_t>& words;

    [[nodiscard]] std::uint32_t trimWord(gpu::uint index) const { return words[index]; }
};

struct Cell {
    float left, right;
    std::vector<std::uint32_t> pieces;
};
struct Band {
    float bottom, top;
    std::vector<std::uint32_t> pieces;
    std::vector<Cell> cells;

    // The mean number of pieces that a point in it looks at, times its height.
    [[nodiscard]] double cost() const
    {
        double sum = 0;
        for (const Cell& cell : cells)
            sum += static_cast<double>(cell.right - cell.left) * static_cast<double>(cell.pieces.size());
        return sum * static_cast<double>(top - bottom);
    }
    [[nodiscard]] size_t entries() const
    {
        size_t sum = 1 + cells.size();
        for (const Cell& cell : cells)
            sum += cell.pieces.size();
        return sum;
    }
};

// Heights at which an odd number of curves begins or ends: increasing.
using Toggles = std::vector<float>;
void normalise(Toggles& toggles)
{
    std::sort(toggles.begin(), toggles.end());
    Toggles kept;
    for (const float at : toggles)
        if (!kept.empty() && kept.back() == at)
            kept.pop_back();
        else
            kept.push_back(at);
    toggles = std::move(kept);
}

class KsQuadIndex {
public:
    KsQuadIndex(std::vector<FloatPiece> pieces, const Toggles& left, bool startsInside)
        : pieces_(std::move(pieces)),
          left_(left),
          startsInside_(startsInside)
    {
    }

    // Bands where the left border asks for them, and then where they save most.
    void makeBands()
    {
        std::vector<float> bottoms{0.0F};
        for (const float at : left_)
            if (at > 0 && at < 1)
                bottoms.push_back(at);
        bottoms.push_back(1.0F);
        std::vector<std::uint32_t> byHeight(pieces_.size());
        for (std::uint32_t k = 0; k < pieces_.size(); ++k)
            byHeight[k] = k;
        std::sort(byHeight.begin(), byHeight.end(),
                  [&](auto x, auto y) { return pieces_[x].lowY < pieces_[y].lowY; });
        size_t next = 0;
        std::vector<std::uint32_t> running;
        for (size_t k = 0; k + 1 < bottoms.size(); ++k) {
            while (next < byHeight.size() && pieces_[byHeight[next]].lowY < bottoms[k + 1])
                running.push_back(byHeight[next++]);
            bands_.push_back(made(bottoms[k], bottoms[k + 1], running));
            running = bands_.back().pieces;
            entries_ += bands_.back().entries();
            if (entries_ > kMostEntries)
                return;
        }
        halve();
        std::sort(bands_.begin(), bands_.end(),
                  [](const Band& x, const Band& y) { return x.bottom < y.bottom; });
    }

    [[nodiscard]] size_t entries() const { return entries_; }
    [[nodiscard]] std::uint32_t mostPieces() const
    {
        size_t most = 0;
        for (const Band& band : bands_)
            for (const Cell& cell : band.cells)
                most = std::max(most, cell.pieces.size());
        return static_cast<std::uint32_t>(most);
    }

    // Whether the left ends of a band are inside, at its middle height.
    [[nodiscard]] bool leftInside(const Band& band) const
    {
        const float middle = band.bottom + (band.top - band.bottom) / 2;
        const auto crossed = std::upper_bound(left_.begin(), left_.end(), middle) - left_.begin();
        return startsInside_ != (crossed % 2 != 0);
    }

    [[nodiscard]] std::optional<bool> uniform() const
    {
        for (const Band& band : bands_)
            if (!band.cells.empty() || leftInside(band) != leftInside(bands_.front()))
                return std::nullopt;
        return leftInside(bands_.front());
    }

    [[nodiscard]] std::vector<std::uint32_t> record() const
    {
        // Until it is known better (fillRows), any square may have a curve.
        std::vector<std::uint32_t> words(TRIM_ROWS, ~0U);
        words.push_back(static_cast<std::uint32_t>(bands_.size()));
        size_t cellCount = 0;
        for (const Band& band : bands_)
            cellCount += band.cells.size();
        const size_t firstCell = TRIM_ROWS + 1 + 3 * bands_.size();
        const size_t firstList = firstCell + 4 * cellCount;
        size_t lists = 0;
        for (const Band& band : bands_)
            for (const Cell& cell : band.cells)
                lists += cell.pieces.size();
        std::vector<std::uint32_t> starts;
        size_t at = firstList + lists;
        for (const FloatPiece& piece : pieces_) {
            starts.push_back(static_cast<std::uint32_t>(at));
            at += piece.words.size();
        }
        std::vector<std::uint32_t> cells;
        std::vector<std::uint32_t> listed;
        for (const Band& band : bands_) {
            bool inside = leftInside(band);
            for (const std::uint32_t word :
                 {bitsOf(band.bottom), static_cast<std::uint32_t>(firstCell + cells.size()),
                  static_cast<std::uint32_t>(2 * band.cells.size() + (inside ? 1 : 0))})
                words.push_back(word);
            for (const Cell& cell : band.cells) {
                const bool right = inside != isOdd(cell, band);
                for (const std::uint32_t word :
                     {bitsOf(cell.left), bitsOf(cell.right),
                      static_cast<std::uint32_t>(firstList + listed.size()),
                      static_cast<std::uint32_t>(4 * cell.pieces.size() + (right ? 2 : 0) +
                                                 (inside ? 1 : 0))})
                    cells.push_back(word);
                for (const std::uint32_t piece : cell.pieces)
                    listed.push_back(starts[piece]);
                inside = right;
            }
        }
        words.insert(words.end(), cells.begin(), cells.end());
        words.insert(words.end(), listed.begin(), listed.end());
        for (const FloatPiece& piece : pieces_)
            words.insert(words.end(), piece.words.begin(), piece.words.end());
        return words;
    }

private:
    // Of what may run in it.
    [[nodiscard]] Band made(float bottom, float top, const std::vector<std::uint32_t>& candidates) const
    {
        Band band{bottom, top, {}, {}};
        std::vector<Cell> parts;
        for (const std::uint32_t k : candidates) {
            const FloatPiece& piece = pieces_[k];
            if (piece.highY <= bottom || piece.lowY >= top)
                continue;
            band.pieces.push_back(k);
            // Nothing crosses a level piece, but above it all is otherwise than below.
            if (piece.lowY == piece.highY) {
                parts.push_back({piece.lowX, piece.highX, {k}});
                continue;
            }
            const auto [left, right] = piece.within(bottom, top);
            parts.push_back({left, right, {k}});
        }
        std::sort(parts.begin(), parts.end(), [](const Cell& x, const Cell& y) { return x.left < y.left; });
        for (Cell& part : parts) {
            if (band.cells.empty() || part.left > band.cells.back().right) {
                band.cells.push_back(std::move(part));
                continue;
            }
            band.cells.back().right = std::max(band.cells.back().right, part.right);
            band.cells.back().pieces.insert(band.cells.back().pieces.end(), part.pieces.begin(),
                                            part.pieces.end());
        }
        return band;
    }

    // Between the cells no curve runs: at any height of a band as many lie to the left.
    [[nodiscard]] bool isOdd(const Cell& cell, const Band& band) const
    {
        const float middle = band.bottom + (band.top - band.bottom) / 2;
        return std::count_if(
                   cell.pieces.begin(), cell.pieces.end(),
                   [&](std::uint32_t k) { return pieces_[k].lowY <= middle && middle < pieces_[k].highY; }) %
                   2 !=
               0;
    }

    // A band's middle, or the end of a piece that is near it.
    [[nodiscard]] float middleOf(const Band& band) const
    {
        const float middle = band.bottom + (band.top - band.bottom) / 2;
        float best = middle;
        float off = (band.top - band.bottom) / 4;
        for (const std::uint32_t k : band.pieces)
            for (const float end : {pieces_[k].lowY, pieces_[k].highY})
                if (std::abs(end - middle) < off) {
                    off = std::abs(end - middle);
                    best = end;
                }
        return best;
    }

    void halve()
    {
        constexpr double kCheap = 0.02;
        const size_t limit = entries_ + kMostBandsAtWill * pieces_.size() + 16;
        std::priority_queue<std::pair<double, size_t>> dearest;
        for (size_t k = 0; k < bands_.size(); ++k)
            dearest.push({bands_[k].cost(), k});
        while (!dearest.empty() && dearest.top().first > kCheap && entries_ < limit) {
            const auto [cost, k] = dearest.top();
            dearest.pop();
            const float middle = middleOf(bands_[k]);
            if (!(middle > bands_[k].bottom && middle < bands_[k].top))
                continue;
            Band lower = made(bands_[k].bottom, middle, bands_[k].pieces);
            Band upper = made(middle, bands_[k].top, bands_[k].pieces);
            if (lower.cost() + upper.cost() > 0.75 * cost)
                continue;
            entries_ += lower.entries() + upper.entries() - bands_[k].entries();
            bands_[k] = std::move(lower);
            bands_.push_back(std::move(upper));
            dearest.push({bands_[k].cost(), k});
            dearest.push({bands_.back().cost(), bands_.size() - 1});
        }
    }

    std::vector<FloatPiece> pieces_;
    const Toggles& left_;
    bool startsInside_;
    std::vector<Band> bands_;
    size_t entries_ = 0;
};

// The squares of a KSQuad's rows, by fours: most are far from curves together.
void fillRows(std::vector<std::uint32_t>& words, std::uint32_t ksquad, std::uint32_t x, std::uint32_t y,
              std::uint32_t size)
{
    constexpr float kGrown = 1e-5F;  // no point of a square may fall into another one by rounding
    const float half = static_cast<float>(size) / (2 * TRIM_ROWS);
    const gpu::vec2 middle =
        gpu::vec2(static_cast<float>(x), static_cast<float>(y)) / static_cast<float>(TRIM_ROWS) + half;
    const gpu::uint side = gpu::trimSide(Source{words}, ksquad, middle, gpu::vec2(half + kGrown));
    if (side == TRIM_NEAR) {
        if (const std::uint32_t part = size / 2; part > 0)
            for (const std::uint32_t k : {0U, 1U, 2U, 3U})
                fillRows(words, ksquad, x + part * (k & 1U), y + part * (k >> 1U), part);
        return;
    }
    for (std::uint32_t row = y; row < y + size; ++row)
        for (std::uint32_t square = x; square < x + size; ++square)
            words[words[ksquad] + row] ^= (TRIM_NEAR ^ side) << (2 * square);
}

}  // namespace

Result<TrimIndex> TrimIndex::create(const TrimRegion& region)
{
    TrimIndex index;
    const auto countU = static_cast<size_t>(region.countU());
    const auto countV = static_cast<size_t>(region.countV());
    index.ksquads_ = static_cast<std::uint32_t>(countU * countV);
    // No record starts at a place that is also a verdict.
    index.words_.assign(std::max(index.ksquads_, TRIM_RECORDS), TRIM_INSIDE);
    if (!region.isTrimmed())
        return index;
    std::vector<std::vector<const RegionPiece*>> pieces(countU * countV);
    for (const auto& chain : region.chains())
        for (const RegionPiece& piece : chain)
            pieces[static_cast<size_t>(piece.a) * countV + static_cast<size_t>(piece.b)].push_back(&piece);
    size_t entries = 0;
    for (size_t b = 0; b < countV; ++b) {
        Toggles left;
        for (size_t a = 0; a < countU; ++a) {
            std::vector<FloatPiece> inside;
            Toggles passed = left;
            for (const RegionPiece* piece : pieces[a * countV + b]) {
                FloatPiece made(*piece);
                if ((made.lowY == made.highY && (made.lowY == 0 || made.lowY == 1)) ||
                    (made.lowX == 1 && a + 1 == countU))
                    continue;
                passed.insert(passed.end(), {made.lowY, made.highY});
                if (made.highX == 0)
                    left.insert(left.end(), {made.lowY, made.highY});
                else
                    inside.push_back(std::move(made));
            }
            normalise(left);
            KsQuadIndex ksquad(std::move(inside), left, region.startsInside());
            ksquad.makeBands();
            entries += ksquad.entries();
            if (entries > kMostEntries)
                return failure("The trim loops are too intricate to be drawn");
            index.mostPieces_ = std::max(index.mostPieces_, ksquad.mostPieces());
            std::uint32_t& word = index.words_[a * countV + b];
            if (const auto uniform = ksquad.uniform()) {
                word = *uniform ? TRIM_INSIDE : TRIM_OUTSIDE;
            } else {
                word = static_cast<std::uint32_t>(index.words_.size());
                const auto record = ksquad.record();
                index.words_.insert(index.words_.end(), record.begin(), record.end());
                fillRows(index.words_, static_cast<std::uint32_t>(a * countV + b), 0, 0, TRIM_ROWS);
            }
            left = std::move(passed);
            normalise(left);
        }
    }
    return index;
}

KsQuadTrim TrimIndex::classOf(std::uint32_t ksquad) const
{
    switch (words_[ksquad]) {
    case TRIM_INSIDE:
        return KsQuadTrim::inside;
    case TRIM_OUTSIDE:
        return KsQuadTrim::outside;
    default:
        return KsQuadTrim::cut;
    }
}

KsQuadTrim TrimIndex::sideOf(std::uint32_t ksquad, const Vec2& place, const Vec2& reach) const
{
    const gpu::uint side = gpu::trimSide(Source{words_}, ksquad, gpu::vec2(place), gpu::vec2(reach));
    return side == TRIM_NEAR     ? KsQuadTrim::cut
           : side == TRIM_INSIDE ? KsQuadTrim::inside
                                 : KsQuadTrim::outside;
}

bool TrimIndex::contains(std::uint32_t ksquad, float x, float y) const
{
    return gpu::trimContains(Source{words_}, ksquad, {x, y});
}

}  // namespace knotspan
