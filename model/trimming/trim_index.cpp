#include "model/trimming/trim_index.h"

#include <algorithm>

#include "model/trimming/ksquad_bands.h"
#include "model/trimming/trim_squares.h"
#include "model/trimming/trim_words.h"

namespace knotspan {

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
            KsQuadBands ksquad(std::move(inside), left, region.startsInside());
            entries += ksquad.entries();
            if (entries > kMostTrimEntries)
                return failure("The trim loops are too intricate to be drawn");
            index.mostPieces_ = std::max(index.mostPieces_, ksquad.mostPieces());
            std::uint32_t& word = index.words_[a * countV + b];
            if (const auto uniform = ksquad.uniform()) {
                word = *uniform ? TRIM_INSIDE : TRIM_OUTSIDE;
            } else {
                word = static_cast<std::uint32_t>(index.words_.size());
                auto record = ksquad.record();
                addSquares(record);
                index.words_.insert(index.words_.end(), record.begin(), record.end());
            }
            left = std::move(passed);
            normalise(left);
        }
    }
    return index;
}

namespace {

KsQuadTrim classOfSide(std::uint32_t side)
{
    switch (side) {
    case TRIM_INSIDE:
        return KsQuadTrim::inside;
    case TRIM_OUTSIDE:
        return KsQuadTrim::outside;
    default:
        return KsQuadTrim::cut;
    }
}

}  // namespace

KsQuadTrim TrimIndex::classOf(std::uint32_t ksquad) const
{
    return classOfSide(words_[ksquad]);
}

KsQuadTrim TrimIndex::sideOf(std::uint32_t ksquad, const Vec2& place, const Vec2& reach) const
{
    if (const KsQuadTrim whole = classOf(ksquad); whole != KsQuadTrim::cut)
        return whole;
    const TrimBox box{gpu::vec2(place - reach), gpu::vec2(place + reach)};
    return classOfSide(sideOfBox(words_, words_[ksquad], box));
}

bool TrimIndex::contains(std::uint32_t ksquad, float x, float y) const
{
    return gpu::trimContains(TrimWords{words_}, ksquad, {x, y});
}

}  // namespace knotspan
