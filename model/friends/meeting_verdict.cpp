#include "model/friends/meeting_verdict.h"

#include <numbers>

#include "model/analysis/bezier_curves.h"
#include "model/friends/certain_maximum.h"
#include "model/friends/curvature_agreement.h"
#include "model/friends/meeting_forms.h"
#include "model/friends/nearest_place.h"

namespace knotspan {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

struct RowsPair {
    EdgeRows a;
    EdgeRows b;
};

// Both over the part, with one parameter, relative to a's origin.
RowsPair rowsOf(const EdgeStrip& a, const EdgeStrip& b, const MatchedPart& matched)
{
    RowsPair rows{part(a.pieces[matched.pieceA].rows, matched.fromA, matched.toA),
                  part(b.pieces[matched.pieceB].rows, matched.fromB, matched.toB)};
    const Vec3 by = b.origin - a.origin;
    for (auto* const row : {&rows.b.at, &rows.b.into, &rows.b.bend}) {
        for (Vec4& point : *row)
            point += Vec4(point.w * by, 0);
        if (matched.factor != 1.0)
            projective(*row, matched.factor);
    }
    rows.b.rational = rows.b.rational || matched.factor != 1.0;
    return rows;
}

// Which of two places on a piece are ends of the edge.
EdgeEnds endsOn(const EdgeStrip& strip, size_t piece, double from, double to)
{
    const auto isEnd = [&](double t) {
        return (piece == 0 && t == 0.0) || (piece + 1 == strip.pieces.size() && t == 1.0);
    };
    return {isEnd(from), isEnd(to)};
}

class Meeting {
public:
    Meeting(const EdgeStrip& a, const EdgeStrip& b, const MatchedRun& run, const MatchingLengths& lengths,
            const FriendTolerances& tolerances)
        : a_(a),
          b_(b),
          run_(run),
          lengths_(lengths),
          tolerances_(tolerances),
          noise_(64 * std::numeric_limits<double>::epsilon() * std::max(a.reach, b.reach))
    {
        for (const MatchedPart& matched : run.parts)
            rows_.push_back(rowsOf(a, b, matched));
    }

    FriendEdge measured()
    {
        FriendEdge edge = placed();
        CertainMaximum gap = gapMaximum();
        gap.bound += a_.deviation + b_.deviation;
        edge.gapMax = gap.bound;
        const CertainMaximum angle = angleMaximum();
        edge.angleMaxDeg = angle.attained * kDegrees;
        edge.angleBoundDeg = angle.bound * kDegrees;
        if (gap.attained > lengths_.gap)
            return judged(edge, Continuity::none, gap.part, gap.tau);
        if (gap.bound > lengths_.gap)
            return judged(edge, Continuity::undetermined, gap.part, gap.tau);
        if (edge.angleMaxDeg > tolerances_.angleDeg)
            return judged(edge, Continuity::g0, angle.part, angle.tau);
        if (edge.angleBoundDeg > tolerances_.angleDeg || run_.hasHole)
            return judged(edge, Continuity::undetermined, angle.part, angle.tau);
        const auto curvature = agreement(angle.bound);
        if (!curvature)
            return judged(edge, Continuity::g1, angle.part, angle.tau);
        edge.curvatureMax = curvature->difference;
        return judged(edge, curvature->certain ? Continuity::g2 : Continuity::g1, curvature->part,
                      curvature->tau);
    }

private:
    FriendEdge placed() const
    {
        FriendEdge edge;
        const MatchedPart& first = run_.parts.front();
        const MatchedPart& last = run_.parts.back();
        edge.reversed = first.toB < first.fromB;
        edge.a = a_.edge;
        edge.a.from = a_.pieces[first.pieceA].parameterAt(first.fromA);
        edge.a.to = a_.pieces[last.pieceA].parameterAt(last.toA);
        edge.b = b_.edge;
        edge.b.from = b_.pieces[first.pieceB].parameterAt(first.fromB);
        edge.b.to = b_.pieces[last.pieceB].parameterAt(last.toB);
        if (edge.reversed)
            std::swap(edge.b.from, edge.b.to);
        return edge;
    }

    FriendEdge judged(FriendEdge edge, Continuity continuity, size_t number, double tau) const
    {
        const MatchedPart& matched = run_.parts[number];
        const EdgePiece& piece = a_.pieces[matched.pieceA];
        edge.continuity = continuity;
        edge.worst = piece.parameterAt(matched.onA(tau));
        edge.worstPoint = a_.origin + lookAt(piece.rows.at, matched.onA(tau)).at;
        return edge;
    }

    CertainMaximum gapMaximum() const
    {
        std::vector<FormPiece> pieces;
        for (size_t k = 0; k < rows_.size(); ++k)
            pieces.push_back({gapForm(rows_[k].a.at, rows_[k].b.at), k});
        return certainMaximum(
            std::move(pieces), lengths_.gap, 0.01 * lengths_.gap,
            [](const Vec4& figures) { return glm::length(Vec3(figures)) / figures.w; }, gapBound);
    }

    CertainMaximum angleMaximum()
    {
        std::vector<FormPiece> pieces;
        size_t pole = rows_.size();
        for (size_t k = 0; k < rows_.size(); ++k) {
            const MatchedPart& matched = run_.parts[k];
            const Vectors a =
                normalForm(rows_[k].a, endsOn(a_, matched.pieceA, matched.fromA, matched.toA), noise_);
            const Vectors b =
                normalForm(rows_[k].b, endsOn(b_, matched.pieceB, matched.fromB, matched.toB), noise_);
            if (a.empty() || b.empty())
                pole = std::min(pole, k);
            else
                pieces.push_back({angleForm(a, b), k});
        }
        CertainMaximum result{0, std::numbers::pi, 0, 0};
        if (!pieces.empty()) {
            const double limit = tolerances_.angleDeg / kDegrees;
            result = certainMaximum(std::move(pieces), limit, 0.01 * limit, angleAt, angleBound);
        }
        if (pole < rows_.size()) {
            result.bound = std::numbers::pi;
            if (result.attained <= tolerances_.angleDeg / kDegrees) {
                result.part = pole;
                result.tau = vanishingEnd(rows_[pole]);
            }
        }
        return result;
    }

    // The end of a part where a normal is shorter than at its other one.
    static double vanishingEnd(const RowsPair& rows)
    {
        const auto lengthAt = [](const EdgeRows& side, bool last) {
            const size_t k = last ? side.at.size() - 1 : 0;
            const size_t next = last ? k - 1 : 1;
            const Vec3 here = pointOf(side.at[k]);
            return glm::length(
                glm::cross(pointOf(side.at[next]) - here, Vec3(side.into[k]) - side.into[k].w * here));
        };
        const auto shareOfLast = [&](const EdgeRows& side) {
            return lengthAt(side, true) / (lengthAt(side, false) + lengthAt(side, true));
        };
        const double shares[] = {shareOfLast(rows.a), shareOfLast(rows.b)};
        return std::min(shares[0], shares[1]) < std::min(1 - shares[0], 1 - shares[1]) ? 1 : 0;
    }

    std::optional<CurvatureAgreement> agreement(double angle) const
    {
        const auto formOf = [this](size_t k, double from, double to) {
            return curvatureForm(part(rows_[k].a, from, to), part(rows_[k].b, from, to), noise_);
        };
        const double size = std::max(a_.size, b_.size);
        return curvatureAgreement(rows_.size(), formOf, {tolerances_.curvature, 0.1 / size, angle});
    }

    const EdgeStrip& a_;
    const EdgeStrip& b_;
    const MatchedRun& run_;
    const MatchingLengths& lengths_;
    const FriendTolerances& tolerances_;
    const double noise_;
    std::vector<RowsPair> rows_;
};

}  // namespace

FriendEdge meetingOf(const EdgeStrip& a, const EdgeStrip& b, const MatchedRun& run,
                     const MatchingLengths& lengths, const FriendTolerances& tolerances)
{
    return Meeting(a, b, run, lengths, tolerances).measured();
}

}  // namespace knotspan
