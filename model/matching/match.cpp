#include "model/matching/match.h"

#include <algorithm>
#include <cmath>

#include "model/core/check.h"
#include "model/matching/edge_first.h"
#include "model/matching/edge_parameters.h"
#include "model/matching/match_side.h"

namespace knotspan {

namespace {

struct Edge {
    NurbsSurface surface;  // clamped, edge first, in its own space
    Mat4 transform;
    double from = 0;
    double to = 0;
    bool isWhole = false;

    [[nodiscard]] NurbsSurface inModel() const { return placed(surface, transform); }
};

Edge edgeOf(const PlacedSurface& placedSurface, const EdgePart& found, double gap)
{
    const EdgePart part = upToNearEnds(placedSurface, found, gap);
    return {edgeFirst(clamped(*placedSurface.surface), part.side), placedSurface.transform, part.from,
            part.to, isWholeSide(*placedSurface.surface, part)};
}

MatchedSurface matchedSurface(const MovingSide& side, Side where)
{
    MatchedSurface matched{edgeBack(side.result(), where),
                           where == Side::startU || where == Side::endU ? Direction::U : Direction::V,
                           side.firstRow(),
                           side.lastRow(),
                           side.measuredMove(),
                           side.boundedMove()};
    if (side.lastRow() >= side.firstRow() && (where == Side::endU || where == Side::endV)) {
        const int last = side.now().countU() - 1;
        matched.firstRow = last - side.lastRow();
        matched.lastRow = last - side.firstRow();
    }
    return matched;
}

// `edge` moves towards `other`.
Result<MovingSide> moved(const MatchRequest& request, const Edge& edge, const Edge& other, MeetAt meetAt)
{
    auto partner = partnerOf(other.inModel(), other.from, other.to, request.reversed, edge.surface.knotsV());
    if (!partner)
        return tl::unexpected(partner.error());
    return matchSide(MovingSide(edge.surface, edge.transform), *partner, meetAt, request.wanted,
                     request.tolerances);
}

Result<void> requireSides(const MatchRequest& request)
{
    if (request.edgeA.trim || request.edgeB.trim)
        return failure("The edge is a trim curve, and Match moves the sides of whole surfaces only",
                       "Choose an edge between surfaces that are not trimmed");
    return {};
}

Result<void> requirePossible(const MatchRequest& request, const Edge& a, const Edge& b)
{
    if (!(a.from < a.to) || !(b.from < b.to))
        return failure("The edges share no part of any length", "Choose edges that run together");
    const bool both = request.move == MatchSides::both;
    if (both && request.edgeA.surface == request.edgeB.surface)
        return failure("The two edges are of one surface, whose sides cannot both move",
                       "Choose one side to move");
    if ((request.move != MatchSides::b && !a.isWhole) || (request.move != MatchSides::a && !b.isWhole))
        return failure("Only a part of the edge that is to move runs along the other",
                       !a.isWhole && !b.isWhole ? "Pull control points near it by hand instead"
                       : both                   ? "Move only the side whose whole edge takes part"
                                                : "Move the other side");
    return {};
}

Result<void> requireReached(const MatchRequest& request, const EdgeFit& fit)
{
    const FriendTolerances& tolerances = request.tolerances;
    if (fit.gap > tolerances.gap)
        return failure("The edges do not close to less than the gap allowed", "Allow a larger gap");
    if (request.wanted >= Continuity::g1 && fit.angleDeg > tolerances.angleDeg)
        return failure("The two sides do not meet within the angle allowed", "Move one side only");
    if (request.wanted == Continuity::g2 && fit.relativeCurvature > tolerances.curvature)
        return failure("The curvatures of the two sides do not agree within what is allowed",
                       "Move one side only");
    return {};
}

}  // namespace

Result<MatchProposal> matchEdge(const MatchRequest& request)
{
    check(request.wanted == Continuity::g0 || request.wanted == Continuity::g1 ||
              request.wanted == Continuity::g2,
          "an edge is made G0, G1 or G2");
    if (auto sides = requireSides(request); !sides)
        return tl::unexpected(sides.error());
    const Edge a = edgeOf(request.a, request.edgeA, request.tolerances.gap);
    const Edge b = edgeOf(request.b, request.edgeB, request.tolerances.gap);
    if (auto possible = requirePossible(request, a, b); !possible)
        return tl::unexpected(possible.error());

    const MeetAt meetAt = request.move == MatchSides::both ? MeetAt::halfway : MeetAt::partner;
    MatchProposal proposal;
    NurbsSurface newA = a.inModel();
    NurbsSurface newB = b.inModel();
    if (request.move != MatchSides::b) {
        const auto side = moved(request, a, b, meetAt);
        if (!side)
            return tl::unexpected(side.error());
        proposal.a = matchedSurface(*side, request.edgeA.side);
        newA = side->now();
    }
    if (request.move != MatchSides::a) {
        const auto side = moved(request, b, a, meetAt);
        if (!side)
            return tl::unexpected(side.error());
        proposal.b = matchedSurface(*side, request.edgeB.side);
        newB = side->now();
    }

    // Seen from a side that moved: its whole edge takes part.
    const bool seenFromA = request.move == MatchSides::a;
    if (request.edgeA.surface == request.edgeB.surface) {
        const NurbsSurface& seam = seenFromA ? proposal.a->surface : proposal.b->surface;
        newA = edgeOf({&seam, request.a.transform}, request.edgeA, request.tolerances.gap).inModel();
        newB = edgeOf({&seam, request.b.transform}, request.edgeB, request.tolerances.gap).inModel();
    }
    const NurbsSurface& side = seenFromA ? newA : newB;
    const Edge& other = seenFromA ? b : a;
    auto partner = partnerOf(seenFromA ? newB : newA, other.from, other.to, request.reversed, side.knotsV());
    if (!partner)
        return tl::unexpected(partner.error());
    const bool byParameter = measuredGap(side, *partner, sameParameter(), 16) <= request.tolerances.gap;
    const EdgeFit fit =
        fitOf(side, *partner, byParameter ? sameParameter() : nearestParameter(side, *partner), 32);
    if (auto reached = requireReached(request, fit); !reached)
        return tl::unexpected(reached.error());
    proposal.gap = fit.gap;
    proposal.angleDeg = fit.angleDeg;
    proposal.curvature = fit.curvature;
    proposal.curvaturePart = fit.relativeCurvature;
    return proposal;
}

}  // namespace knotspan
