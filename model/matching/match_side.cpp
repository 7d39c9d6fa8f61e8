#include "model/matching/match_side.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <glm/geometric.hpp>

#include "model/matching/edge_first.h"
#include "model/matching/row_demands.h"

namespace knotspan {

namespace {

constexpr int kRounds = 11;           // of inserting knots where the tolerance is missed
constexpr int kHalvings = 4;          // before knots are thought to be what stands in the way
constexpr int kMostRows = 2000;       // of control points along the edge
constexpr double kMostBreakDeg = 90;  // rows that have to turn further would cross the edge
constexpr double kFoldDeg = 170;      // what people would say lies on itself
constexpr double kSameEdge = 1e-12;   // of the net's size: edges that are one already
// Of the tolerances, as what is measured at points may be a little more between them, and as Friends has to
// be certain within a number of steps.
constexpr double kAngleReserve = 0.8;
constexpr double kCurvatureReserve = 0.5;

// Curvatures below this count as much as this, as Friends has it.
double leastCurvature(const NurbsSurface& side, const NurbsSurface& partner)
{
    return 0.1 / std::max(side.bounds().diagonal(), partner.bounds().diagonal());
}

// How much the normal curvatures across the edge differ, of the larger one.
double relativeCurvature(const EdgeFrame& first, const EdgeFrame& second, double least)
{
    const double larger = std::max({std::abs(first.acrossAcross), std::abs(second.acrossAcross), least});
    return std::abs(first.acrossAcross - second.acrossAcross) / larger;
}

std::string numberText(double number)
{
    std::ostringstream text;
    text.precision(3);
    text << number;
    return text.str();
}

// Whether rows can mend the edge, and otherwise why not.
Result<void> requireFacing(const NurbsSurface& side, const NurbsSurface& partner,
                           const Partnering& partnering)
{
    double most = 0;
    for (const double v : sampleParameters(side.knotsV(), 8)) {
        const EdgeFrame beyond = turned(frameInto(partner, partnering(v)));
        const EdgeFrame into = frameInto(side, v);
        if (!beyond.regular || !into.regular)
            return failure("There is no tangent plane at a point of the edge",
                           "Pull the control points there apart, then match again");
        most = std::max(most, breakDeg(beyond, into));
    }
    if (most < kMostBreakDeg)
        return {};
    return failure(most > kFoldDeg ? "The surfaces fold back on each other along the edge"
                                   : "The surfaces meet at " + numberText(most) +
                                         " degrees, and only those that meet at less than 90 are matched",
                   "Pull the control points behind the edge until the surfaces meet at less, or ask for G0");
}

// The partner's edge with the side's weights at the ends, or the mean of both. It is linear in homogeneous
// points, so knots inserted later do not change it.
std::vector<ControlPoint> sharedRow(const std::vector<ControlPoint>& side, std::vector<ControlPoint> partner,
                                    MeetAt meetAt)
{
    const double sideWeights = side.front().weight + side.back().weight;
    const double partnerWeights = partner.front().weight + partner.back().weight;
    for (size_t k = 0; k < side.size(); ++k) {
        if (sideWeights != partnerWeights)
            partner[k].weight *= sideWeights / partnerWeights;
        if (meetAt == MeetAt::halfway) {
            const Vec4 sum = side[k].homogeneous() + partner[k].homogeneous();
            partner[k] = {Vec3(sum) / sum.w, 0.5 * sum.w};
        }
    }
    return partner;
}

class SideMatch {
public:
    SideMatch(MovingSide side, NurbsSurface partner, MeetAt meetAt, Continuity wanted,
              const FriendTolerances& tolerances)
        : side_(std::move(side)),
          partner_(std::move(partner)),
          meetAt_(meetAt),
          wanted_(wanted),
          share_(meetAt == MeetAt::halfway ? 0.5 : 1.0),
          tolerances_(tolerances),
          least_(leastCurvature(side_.before(), partner_))
    {
    }

    Result<MovingSide> run()
    {
        if (const auto refused = choosePartnering())
            return failure(*refused, "Choose one side to move");
        if (wanted_ == Continuity::g0) {
            moveEdge();
            return side_;
        }
        makeRoom();
        if (const auto facing = requireFacing(side_.before(), partner_, partnering_); !facing)
            return tl::unexpected(facing.error());
        for (int round = 0;; ++round) {
            moveEdge();
            const TargetFrames target = targetFrames();
            if (!moveRows(target))
                return failure("The row of control points behind the edge is too close to it to be turned",
                               "Pull that row away from the edge, then match again");
            const std::vector<double> knots = knotsToInsert(target, round < kHalvings);
            if (knots.empty())
                return side_;
            if (round == kRounds && isReached())
                return side_;
            const bool hopeless = round > kHalvings && wanted_ == Continuity::g2 && curvatureJumps();
            if (round == kRounds || hopeless ||
                side_.now().countV() + static_cast<int>(knots.size()) > kMostRows)
                return failure(whatIsLeft(),
                               wanted_ == Continuity::g2
                                   ? "Ask for G1, move the other side, or allow a larger difference"
                                   : "Move the other side, allow a larger angle, or ask for G0");
            side_.insertAlong(knots);
        }
    }

private:
    // Whether the edges go together by their parameters or by nearness, and whether the edge has to move.
    std::optional<std::string> choosePartnering()
    {
        partnering_ = sameParameter();
        const double gap = measuredGap(side_.now(), partner_, partnering_, 8);
        const double size = side_.now().bounds().diagonal();
        edgeMoves_ = gap > kSameEdge * size;
        if (edgeMoves_ && gap > tolerances_.gap) {
            const Partnering nearest = nearestParameter(side_.now(), partner_);
            if (measuredGap(side_.now(), partner_, nearest, 8) <= tolerances_.gap) {
                if (meetAt_ == MeetAt::halfway)
                    return "The edges run together but their parameters do not, so neither can meet the "
                           "other halfway";
                partnering_ = nearest;
                edgeMoves_ = false;
            }
        }
        if (edgeMoves_) {
            SameEdgeKnots both = withSameEdgeKnots(side_.now(), partner_);
            partner_ = both.partner;
            side_.raiseAlong(both.mover.degreeV());
            side_.insertAlong(missingKnots(side_.now().knotsV(), partner_.knotsV()));
        }
        return std::nullopt;
    }

    // So that the opposite edge stays where it is.
    void makeRoom()
    {
        const int rows = wanted_ == Continuity::g2 ? 3 : 2;
        if (wanted_ == Continuity::g2 && side_.now().degreeU() < 2)
            side_.raiseAcross(2);
        while (side_.now().countU() <= rows)
            side_.raiseAcross(side_.now().degreeU() + 1);
    }

    void moveEdge()
    {
        if (!edgeMoves_)
            return;
        // The partner has the knots of the start; what was inserted since does not change its curve.
        const NurbsSurface edge =
            withKnotsInserted(partner_, Direction::V, missingKnots(partner_.knotsV(), side_.now().knotsV()));
        side_.moveRow(0, sharedRow(rowOf(side_.now(), 0), rowOf(edge, 0), meetAt_));
    }

    TargetFrames targetFrames() const
    {
        return {side_.now(), partner_, partnering_,
                meetAt_ == MeetAt::halfway ? std::optional(side_.before()) : std::nullopt};
    }

    std::vector<double> parameters() const
    {
        return sampleParameters(side_.now().knotsV(), side_.now().degreeV() + 4);
    }

    bool anglesReached(const TargetFrames& target, double v) const
    {
        return breakDeg(frameInto(side_.now(), v), target.at(v)) <=
               share_ * kAngleReserve * tolerances_.angleDeg;
    }

    bool curvaturesReached(const TargetFrames& target, double v) const
    {
        return relativeCurvature(frameInto(side_.now(), v), target.at(v), least_) <=
               share_ * kCurvatureReserve * tolerances_.curvature;
    }

    template <class Reached>
    bool everywhere(const Reached& reached) const
    {
        const std::vector<double> tried = parameters();
        return std::all_of(tried.begin(), tried.end(), reached);
    }

    // Rows that are right already stay. False where the row behind the edge would come to lie before it, or
    // on it.
    bool moveRows(const TargetFrames& target)
    {
        const KnotVector& along = side_.now().knotsV();
        if (!everywhere([&](double v) { return anglesReached(target, v); })) {
            const auto demands = tangentDemands(side_.now(), target, parameters());
            const auto row = fittedRow(along, rowOf(side_.now(), 1), demands);
            if (!row)
                return false;
            side_.moveRow(1, *row);
            if (!requireFacing(side_.now(), partner_, partnering_))
                return false;
        }
        if (wanted_ == Continuity::g2 &&
            !everywhere([&](double v) { return curvaturesReached(target, v); })) {
            const auto demands = curvatureDemands(side_.now(), target, parameters());
            const auto row = fittedRow(along, rowOf(side_.now(), 2), demands);
            if (!row)
                return false;
            side_.moveRow(2, *row);
        }
        return true;
    }

    // Without reserve.
    bool isReached() const
    {
        const EdgeFit fit = fitOf(side_.now(), partner_, partnering_, 16);
        return meetAt_ == MeetAt::partner && fit.angleDeg <= tolerances_.angleDeg &&
               (wanted_ != Continuity::g2 || fit.relativeCurvature <= tolerances_.curvature);
    }

    // Where knots are to be inserted: in the middles of spans in which the tolerance is missed somewhere.
    // Where halving does not help, as the partner's tangent planes turn with a jerk at one of its knots, rows
    // may turn there too.
    std::vector<double> knotsToInsert(const TargetFrames& target, bool halvingHelped) const
    {
        const KnotVector& along = side_.now().knotsV();
        std::vector<double> wanted;
        for (const double v : sampleParameters(along, 16)) {
            const bool turnsWrong = !anglesReached(target, v);
            if (!turnsWrong && (wanted_ != Continuity::g2 || curvaturesReached(target, v)))
                continue;
            const int span = along.findSpan(v);
            const double middle = 0.5 * (along[span] + along[span + 1]);
            const double end = v < middle ? along[span] : along[span + 1];
            const double knot = turnsWrong && !halvingHelped && mayTurnAt(end) ? end : middle;
            if (std::find(wanted.begin(), wanted.end(), knot) == wanted.end())
                wanted.push_back(knot);
        }
        return wanted;
    }

    // An inner knot of the partner's at which the side may become less smooth along the edge.
    bool mayTurnAt(double knot) const
    {
        const auto count = [knot](const KnotVector& knots) {
            return std::count(knots.values().begin(), knots.values().end(), knot);
        };
        const KnotVector& along = side_.now().knotsV();
        return knot > along.domainStart() && knot < along.domainEnd() && count(partner_.knotsV()) > 0 &&
               count(along) < along.degree();
    }

    // Whether what is asked for differs between the two sides of an inner knot.
    bool curvatureJumps() const
    {
        const TargetFrames target = targetFrames();
        const KnotVector& along = side_.now().knotsV();
        const double step = 1e-9 * (along.domainEnd() - along.domainStart());
        return std::any_of(along.spans().begin() + 1, along.spans().end(), [&](int span) {
            return relativeCurvature(target.at(along[span] - step), target.at(along[span] + step), least_) >
                   tolerances_.curvature;
        });
    }

    std::string whatIsLeft() const
    {
        const EdgeFit fit = fitOf(side_.now(), partner_, partnering_, 16);
        if (fit.angleDeg > tolerances_.angleDeg)
            return "The angle across the edge falls to " + numberText(fit.angleDeg) +
                   " degrees at best, above " + numberText(tolerances_.angleDeg);
        if (curvatureJumps())
            return "The curvature of a surface jumps along the edge, at a knot where it is only tangent "
                   "continuous";
        return "The curvatures across the edge stay " + numberText(100 * fit.relativeCurvature) +
               " % apart at best, above " + numberText(100 * tolerances_.curvature) + " %";
    }

    MovingSide side_;
    NurbsSurface partner_;
    MeetAt meetAt_;
    Continuity wanted_;
    double share_;
    FriendTolerances tolerances_;
    double least_;
    Partnering partnering_;
    bool edgeMoves_ = true;
};

}  // namespace

Result<MovingSide> matchSide(MovingSide side, const NurbsSurface& partner, MeetAt meetAt, Continuity wanted,
                             const FriendTolerances& tolerances)
{
    return SideMatch(std::move(side), partner, meetAt, wanted, tolerances).run();
}

EdgeFit fitOf(const NurbsSurface& side, const NurbsSurface& partner, const Partnering& partnering,
              int perSpan)
{
    EdgeFit fit;
    const double least = leastCurvature(side, partner);
    for (const double v : sampleParameters(side.knotsV(), perSpan)) {
        const EdgeFrame into = frameInto(side, v);
        const EdgeFrame beyond = turned(frameInto(partner, partnering(v)));
        fit.gap = std::max(fit.gap, glm::length(into.point - beyond.point));
        fit.angleDeg = std::max(fit.angleDeg, breakDeg(into, beyond));
        if (!into.regular || !beyond.regular)
            continue;
        fit.curvature = std::max(fit.curvature, std::abs(into.acrossAcross - beyond.acrossAcross));
        fit.relativeCurvature = std::max(fit.relativeCurvature, relativeCurvature(into, beyond, least));
    }
    return fit;
}

}  // namespace knotspan
