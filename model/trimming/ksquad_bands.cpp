#include "model/trimming/ksquad_bands.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace knotspan {

namespace {

constexpr int kMostBandsAtWill = 16;  // for each piece, beyond those that must be

}  // namespace

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

KsQuadBands::KsQuadBands(std::vector<FloatPiece> pieces, const Toggles& left, bool startsInside)
    : pieces_(std::move(pieces)),
      left_(left),
      startsInside_(startsInside)
{
    makeBands();
}

// The mean number of pieces that a point in it looks at, times its height.
double KsQuadBands::Band::cost() const
{
    double sum = 0;
    for (const Cell& cell : cells)
        sum += static_cast<double>(cell.right - cell.left) * static_cast<double>(cell.pieces.size());
    return sum * static_cast<double>(top - bottom);
}

size_t KsQuadBands::Band::entries() const
{
    size_t sum = 1 + cells.size();
    for (const Cell& cell : cells)
        sum += cell.pieces.size();
    return sum;
}

// Bands where the left border asks for them, and then where they save most.
void KsQuadBands::makeBands()
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
        if (entries_ > kMostTrimEntries)
            return;
    }
    halve();
    std::sort(bands_.begin(), bands_.end(), [](const Band& x, const Band& y) { return x.bottom < y.bottom; });
}

void KsQuadBands::halve()
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

std::uint32_t KsQuadBands::mostPieces() const
{
    size_t most = 0;
    for (const Band& band : bands_)
        for (const Cell& cell : band.cells)
            most = std::max(most, cell.pieces.size());
    return static_cast<std::uint32_t>(most);
}

// Whether the left ends of a band are inside, at its middle height.
bool KsQuadBands::leftInside(const Band& band) const
{
    const float middle = band.bottom + (band.top - band.bottom) / 2;
    const auto crossed = std::upper_bound(left_.begin(), left_.end(), middle) - left_.begin();
    return startsInside_ != (crossed % 2 != 0);
}

std::optional<bool> KsQuadBands::uniform() const
{
    for (const Band& band : bands_)
        if (!band.cells.empty() || leftInside(band) != leftInside(bands_.front()))
            return std::nullopt;
    return leftInside(bands_.front());
}

std::vector<std::uint32_t> KsQuadBands::record() const
{
    std::vector<std::uint32_t> words{0};
    words.push_back(static_cast<std::uint32_t>(bands_.size()));
    size_t cellCount = 0;
    for (const Band& band : bands_)
        cellCount += band.cells.size();
    const size_t firstCell = 2 + 3 * bands_.size();
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
                  static_cast<std::uint32_t>(4 * cell.pieces.size() + (right ? 2 : 0) + (inside ? 1 : 0))})
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

// Of what may run in it.
KsQuadBands::Band KsQuadBands::made(float bottom, float top,
                                    const std::vector<std::uint32_t>& candidates) const
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
bool KsQuadBands::isOdd(const Cell& cell, const Band& band) const
{
    const float middle = band.bottom + (band.top - band.bottom) / 2;
    return std::count_if(
               cell.pieces.begin(), cell.pieces.end(),
               [&](std::uint32_t k) { return pieces_[k].lowY <= middle && middle < pieces_[k].highY; }) %
               2 !=
           0;
}

// A band's middle, or the end of a piece that is near it.
float KsQuadBands::middleOf(const Band& band) const
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

}  // namespace knotspan
