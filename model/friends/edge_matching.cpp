#include "model/friends/edge_matching.h"

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "model/analysis/bezier_curves.h"
#include "model/friends/nearest_place.h"
#include "model/friends/piece_matching.h"

namespace knotspan {

MatchingLengths matchingLengths(const EdgeStrip& a, const EdgeStrip& b, double gap)
{
    MatchingLengths lengths;
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * std::max(a.reach, b.reach);
    lengths.gap = std::max(gap, rounding);
    lengths.reach = 3 * lengths.gap;
    lengths.shortest = std::min(10 * lengths.gap, std::min(a.length(), b.length()) / 2);
    lengths.slip = std::max(0.003 * lengths.gap, 4 * rounding);
    lengths.point = lengths.slip / 10;
    return lengths;
}

double MatchedPart::onB(double tau) const
{
    if (tau == 1.0)
        return toB;
    return fromB + factor * tau / (1 - tau + factor * tau) * (toB - fromB);
}

MatchedPart MatchedPart::between(double start, double end) const
{
    MatchedPart result = *this;
    result.fromA = onA(start);
    result.toA = onA(end);
    result.fromB = onB(start);
    result.toB = onB(end);
    // 1 - phi and phi are (1 - tau) and factor tau, divided by a weight: weights of the ends' quotient.
    const auto weight = [this](double tau) { return 1 - tau + factor * tau; };
    result.factor = weight(end) / weight(start);
    return result;
}

double gapAt(const EdgeStrip& a, const EdgeStrip& b, const MatchedPart& part, double tau)
{
    const Vec3 x = lookAt(a.pieces[part.pieceA].rows.at, part.onA(tau)).at;
    const Vec3 y = lookAt(b.pieces[part.pieceB].rows.at, part.onB(tau)).at;
    return glm::distance(x, y + (b.origin - a.origin));
}

namespace {

class Matching {
public:
    Matching(const EdgeStrip& a, const EdgeStrip& b, const MatchingLengths& lengths)
        : a_(a),
          b_(b),
          lengths_(lengths)
    {
    }

    std::vector<MatchedRun> runs() const
    {
        std::vector<MatchedRun> result;
        for (std::vector<MatchedPart>& chain : chains(allParts())) {
            MatchedRun run{std::move(chain)};
            trim(run);
            for (size_t k = 1; k < run.parts.size(); ++k)
                run.hasHole = run.hasHole || holeBetween(run.parts[k - 1], run.parts[k]) > 2 * lengths_.point;
            const double least = run.withinGap ? lengths_.shortest : 3 * lengths_.shortest;
            if (lengthOf(run) >= least)
                result.push_back(std::move(run));
        }
        return result;
    }

private:
    std::vector<MatchedPart> allParts() const
    {
        std::vector<MatchedPart> parts;
        const bool sameEdge = &a_ == &b_;
        for (size_t i = 0; i < a_.pieces.size(); ++i)
            for (size_t k = sameEdge ? i + 1 : 0; k < b_.pieces.size(); ++k) {
                const EdgePiece& x = a_.pieces[i];
                const EdgePiece& y = b_.pieces[k];
                if (plainlyApart(x, y, lengths_) || std::min(x.length, y.length) <= lengths_.point)
                    continue;
                for (MatchedPart part : matchPieces(x, shifted(y, b_.origin - a_.origin), lengths_)) {
                    part.pieceA = i;
                    part.pieceB = k;
                    parts.push_back(part);
                }
            }
        std::stable_sort(parts.begin(), parts.end(), [](const MatchedPart& x, const MatchedPart& y) {
            return x.pieceA != y.pieceA ? x.pieceA < y.pieceA : x.fromA < y.fromA;
        });
        return parts;
    }

    Vec3 placeA(const MatchedPart& part, double t) const
    {
        return lookAt(a_.pieces[part.pieceA].rows.at, t).at;
    }
    // What is left out of an edge between a place on one piece and one on this or a later piece.
    static double wayBetween(const EdgeStrip& strip, size_t piece, double t, size_t nextPiece, double nextT)
    {
        double length = 0;
        for (size_t k = piece; k <= nextPiece; ++k) {
            const double from = k == piece ? t : 0;
            const double to = k == nextPiece ? nextT : 1;
            if (from == to)
                continue;
            const std::vector<Vec4> left = part(strip.pieces[k].rows.at, from, to);
            for (size_t i = 0; i + 1 < left.size(); ++i)
                length += glm::distance(pointOf(left[i]), pointOf(left[i + 1]));
        }
        return length;
    }

    // Of a or of b, whichever is longer; infinite where `next` does not go on from `last`.
    double holeBetween(const MatchedPart& last, const MatchedPart& next) const
    {
        constexpr double kNone = std::numeric_limits<double>::infinity();
        const bool reversed = last.toB < last.fromB;
        if (reversed != (next.toB < next.fromB) || next.pieceA < last.pieceA)
            return kNone;
        if (reversed ? next.pieceB > last.pieceB : next.pieceB < last.pieceB)
            return kNone;
        const double onA = wayBetween(a_, last.pieceA, last.toA, next.pieceA, next.fromA);
        const double onB = reversed ? wayBetween(b_, next.pieceB, next.fromB, last.pieceB, last.toB)
                                    : wayBetween(b_, last.pieceB, last.toB, next.pieceB, next.fromB);
        return std::max(onA, onB);
    }
    bool follows(const MatchedPart& last, const MatchedPart& next) const
    {
        return holeBetween(last, next) <= 4 * lengths_.slip;
    }

    std::vector<std::vector<MatchedPart>> chains(const std::vector<MatchedPart>& parts) const
    {
        std::vector<std::vector<MatchedPart>> result;
        for (const MatchedPart& part : parts) {
            const auto found = std::find_if(result.begin(), result.end(),
                                            [&](const auto& chain) { return follows(chain.back(), part); });
            if (found == result.end())
                result.push_back({part});
            else
                found->push_back(part);
        }
        return result;
    }

    double lengthOf(const MatchedRun& run) const
    {
        constexpr int kSteps = 4;
        double length = 0;
        for (const MatchedPart& part : run.parts)
            for (int k = 0; k < kSteps; ++k)
                length += glm::distance(placeA(part, part.onA(static_cast<double>(k) / kSteps)),
                                        placeA(part, part.onA(static_cast<double>(k + 1) / kSteps)));
        return length;
    }

    // The first place of the part that is within the gap tolerance, from its start or backwards from its end.
    std::optional<double> firstWithin(const MatchedPart& part, bool backwards) const
    {
        constexpr int kSteps = 8;
        constexpr double kRounding = 1e-9;
        const auto within = [&](double tau) {
            return gapAt(a_, b_, part, tau) <= (1 - kRounding) * lengths_.gap;
        };
        for (int k = 0; k <= kSteps; ++k) {
            const auto at = [&](int step) {
                return static_cast<double>(backwards ? kSteps - step : step) / kSteps;
            };
            if (!within(at(k)))
                continue;
            if (k == 0)
                return at(0);
            double outside = at(k - 1);
            double inside = at(k);
            for (int step = 0; step < 40; ++step) {
                const double middle = (outside + inside) / 2;
                (within(middle) ? inside : outside) = middle;
            }
            return inside;
        }
        return std::nullopt;
    }

    // Leaves out ends that are beyond the tolerance, where something within it remains.
    void trim(MatchedRun& run) const
    {
        std::vector<MatchedPart>& parts = run.parts;
        size_t first = 0;
        std::optional<double> start;
        while (first < parts.size() && !(start = firstWithin(parts[first], false)))
            ++first;
        run.withinGap = start.has_value();
        if (!run.withinGap)
            return;
        size_t last = parts.size() - 1;
        std::optional<double> end;
        while (!(end = firstWithin(parts[last], true)))
            --last;
        if (first == last) {
            parts = {parts[first].between(*start, *end)};
            return;
        }
        parts[last] = parts[last].between(0, *end);
        parts[first] = parts[first].between(*start, 1);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(last) + 1, parts.end());
        parts.erase(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(first));
    }

    const EdgeStrip& a_;
    const EdgeStrip& b_;
    const MatchingLengths& lengths_;
};

}  // namespace

std::vector<MatchedRun> matchedRuns(const EdgeStrip& a, const EdgeStrip& b, const MatchingLengths& lengths)
{
    return Matching(a, b, lengths).runs();
}

}  // namespace knotspan
