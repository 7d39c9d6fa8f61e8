#include "model/trimming/trim_squares.h"

#include "model/trimming/trim_words.h"

namespace knotspan {

namespace {

using gpu::uint;
using gpu::vec2;

// What a piece says of a box in one band: whether it lies to its left, 0 or 1; TRIM_NEAR where it may run
// through it, or ends beside it.
uint sideOfPiece(const TrimWords& words, uint start, const TrimBox& box)
{
    gpu::TrimPiece piece = gpu::trimPieceEnds(words, start);
    const bool rises = piece.first.y <= piece.last.y;
    vec2 low = rises ? piece.first : piece.last;
    vec2 high = rises ? piece.last : piece.first;
    if (box.high.y < low.y || box.low.y > high.y)
        return 0;
    const float middle = box.low.y + (box.high.y - box.low.y) / 2;
    const uint left = middle >= low.y && middle < high.y ? 1 : 0;
    const float bottom = std::max(box.low.y, low.y);
    const float top = std::min(box.high.y, high.y);
    const bool isLine = gpu::trimIsLine(piece);
    if (isLine && high.y > low.y) {
        const vec2 corner = low;
        const float slope = (high.x - low.x) / (high.y - low.y);
        low = {corner.x + slope * (bottom - corner.y), bottom};
        high = {corner.x + slope * (top - corner.y), top};
    }
    float below = rises ? 0 : 1;
    float above = 1 - below;
    if (!isLine)
        gpu::trimHoldInner(words, piece);
    for (int step = 0; step < (isLine ? 0 : TRIM_STEPS); ++step) {
        if (box.high.x < std::min(low.x, high.x))
            return 0;
        if (box.low.x > std::max(low.x, high.x))
            return left;
        const float s = (below + above) / 2;
        const vec2 at = gpu::trimPlace(words, piece, s);
        if (bottom > at.y) {
            low = at;
            below = s;
        } else if (top < at.y) {
            high = at;
            above = s;
        } else {
            return TRIM_NEAR;
        }
    }
    if (box.high.x < std::min(low.x, high.x))
        return 0;
    return box.low.x > std::max(low.x, high.x) ? left : TRIM_NEAR;
}

// Of a box that lies in one band.
uint sideInBand(const TrimWords& words, uint record, uint band, const TrimBox& box)
{
    uint count = words.trimWord(band + 2);
    uint inside = count & 1U;
    count >>= 1U;
    if (count == 0)
        return 1 - inside;
    const uint cells = record + words.trimWord(band + 1);
    const uint cell = cells + 4 * gpu::trimEntry(words, cells, 4, count, box.high.x);
    if (box.high.x < gpu::trimNumber(words, cell))
        return 1 - inside;
    const uint pieces = words.trimWord(cell + 3);
    if (box.low.x > gpu::trimNumber(words, cell + 1))
        return (pieces & 2U) != 0 ? TRIM_INSIDE : TRIM_OUTSIDE;
    if (cell != cells && box.low.x <= gpu::trimNumber(words, cell - 3))
        return TRIM_NEAR;  // the cell before it, too
    inside = pieces & 1U;
    const uint list = record + words.trimWord(cell + 2);
    for (uint k = 0; k < pieces >> 2U; ++k) {
        const uint left = sideOfPiece(words, record + words.trimWord(list + k), box);
        if (left == TRIM_NEAR)
            return TRIM_NEAR;
        inside ^= left;
    }
    return 1 - inside;
}

// A KSQuad's squares, 16 << columns by 16 << rows.
struct Grid {
    uint columns = 0;
    uint rows = 0;
    std::vector<std::uint8_t> sides =
        std::vector<std::uint8_t>(size_t{TRIM_SQUARES} * TRIM_SQUARES, TRIM_NEAR);

    [[nodiscard]] uint across() const { return uint{TRIM_SQUARES} << columns; }
    [[nodiscard]] uint up() const { return uint{TRIM_SQUARES} << rows; }
    [[nodiscard]] std::uint8_t& at(uint x, uint y) { return sides[size_t{y} * across() + x]; }
    [[nodiscard]] double nearShare() const
    {
        return static_cast<double>(std::count(sides.begin(), sides.end(), TRIM_NEAR)) /
               static_cast<double>(sides.size());
    }
    [[nodiscard]] uint words() const { return across() * up() / TRIM_SQUARES; }
    // From x and y on, so many squares along each.
    [[nodiscard]] TrimBox box(uint x, uint y, uint size) const
    {
        constexpr float kGrown = 1e-5F;  // no point of a square may fall into another one by rounding
        const vec2 square = 1.0F / vec2(across(), up());
        return {vec2(x, y) * square - kGrown, vec2(x + size, y + size) * square + kGrown};
    }
};

// By fours: most squares are far from curves together.
void fill(Grid& grid, const std::vector<std::uint32_t>& record, uint x, uint y, uint size)
{
    const uint side = sideOfBox(record, 0, grid.box(x, y, size));
    if (side == TRIM_NEAR && size > 1) {
        for (const uint k : {0U, 1U, 2U, 3U})
            fill(grid, record, x + size / 2 * (k & 1U), y + size / 2 * (k >> 1U), size / 2);
        return;
    }
    for (uint row = y; row < y + size; ++row)
        for (uint column = x; column < x + size; ++column)
            grid.at(column, row) = static_cast<std::uint8_t>(side);
}

// Of those near curves, halves.
Grid doubled(Grid& coarse, const std::vector<std::uint32_t>& record, bool alongU)
{
    Grid fine;
    fine.columns = coarse.columns + (alongU ? 1 : 0);
    fine.rows = coarse.rows + (alongU ? 0 : 1);
    fine.sides.resize(size_t{fine.across()} * fine.up());
    for (uint y = 0; y < fine.up(); ++y)
        for (uint x = 0; x < fine.across(); ++x) {
            const std::uint8_t side = coarse.at(alongU ? x / 2 : x, alongU ? y : y / 2);
            fine.at(x, y) =
                side == TRIM_NEAR ? static_cast<std::uint8_t>(sideOfBox(record, 0, fine.box(x, y, 1))) : side;
        }
    return fine;
}

// What fewer squares can say of the same, half as many along each side that has more than 16.
Grid halved(Grid& fine)
{
    Grid coarse;
    coarse.columns = std::max(fine.columns, 1U) - 1;
    coarse.rows = std::max(fine.rows, 1U) - 1;
    coarse.sides.assign(size_t{coarse.across()} * coarse.up(), std::uint8_t{0xff});
    for (uint y = 0; y < fine.up(); ++y)
        for (uint x = 0; x < fine.across(); ++x) {
            std::uint8_t& side =
                coarse.at(x >> (fine.columns - coarse.columns), y >> (fine.rows - coarse.rows));
            side = side == 0xff || side == fine.at(x, y) ? fine.at(x, y) : std::uint8_t{TRIM_NEAR};
        }
    return coarse;
}

Grid gridFor(const std::vector<std::uint32_t>& record)
{
    constexpr double kNear = 0.125;   // of a KSQuad: fewer squares near curves hardly pay
    constexpr size_t kMostWords = 4;  // for each of the record
    Grid grid;
    fill(grid, record, 0, 0, TRIM_SQUARES);
    while (grid.nearShare() > kNear && 2 * grid.words() <= kMostWords * record.size()) {
        const bool canU = grid.columns < TRIM_MOST_DOUBLINGS;
        const bool canV = grid.rows < TRIM_MOST_DOUBLINGS;
        if (!canU && !canV)
            break;
        Grid alongU = canU ? doubled(grid, record, true) : Grid();
        Grid alongV = canV ? doubled(grid, record, false) : Grid();
        const bool isU = canU && (!canV || alongU.nearShare() < alongV.nearShare() ||
                                  (alongU.nearShare() == alongV.nearShare() && grid.columns <= grid.rows));
        grid = isU ? std::move(alongU) : std::move(alongV);
    }
    return grid;
}

}  // namespace

gpu::uint sideOfBox(const std::vector<std::uint32_t>& words, gpu::uint record, TrimBox box)
{
    const TrimWords source{words};
    const uint bands = words[record + 1];
    const uint entries = record + 2;
    const TrimBox whole = box;
    uint side = TRIM_NEAR;
    const uint first = gpu::trimEntry(source, entries, 3, bands, box.low.y);
    for (uint k = first; k < bands; ++k) {
        const uint band = entries + 3 * k;
        const float next = k + 1 == bands ? 1 : gpu::trimNumber(source, band + 3);
        box.low.y = std::max(whole.low.y, gpu::trimNumber(source, band));
        box.high.y = std::min(whole.high.y, next);
        const uint here = sideInBand(source, record, band, box);
        if (here == TRIM_NEAR || (k > first && here != side))
            return TRIM_NEAR;
        side = here;
        if (next > whole.high.y)
            break;
    }
    return side;
}

void addSquares(std::vector<std::uint32_t>& record)
{
    Grid grid = gridFor(record);
    record.front() = grid.columns | grid.rows << 3U | static_cast<std::uint32_t>(record.size()) << 6U;
    for (;; grid = halved(grid)) {
        for (size_t k = 0; k < grid.sides.size(); k += TRIM_SQUARES) {
            std::uint32_t word = 0;
            for (uint square = 0; square < TRIM_SQUARES; ++square)
                word |= std::uint32_t{grid.sides[k + square]} << (2 * square);
            record.push_back(word);
        }
        if (grid.columns + grid.rows == 0)
            return;
    }
}

}  // namespace knotspan
