// Matches one side: its rows follow a partner that stays, or meet it halfway.
#pragma once

#include "model/friends/friends.h"
#include "model/matching/moving_side.h"

namespace knotspan {

enum class MeetAt { partner, halfway };

// The partner's edge, in model space and in the parameters of the side (partnerOf()).
[[nodiscard]] Result<MovingSide> matchSide(MovingSide side, const NurbsSurface& partner, MeetAt meetAt,
                                           Continuity wanted, const FriendTolerances& tolerances);

// How well two surfaces along one edge fit, at many points: both in model space, edges at u = start.
struct EdgeFit {
    double gap = 0;
    double angleDeg = 0;
    double curvature = 0;          // largest difference of normal curvatures across the edge, 1/unit
    double relativeCurvature = 0;  // of a difference to the larger curvature there
};
[[nodiscard]] EdgeFit fitOf(const NurbsSurface& side, const NurbsSurface& partner,
                            const Partnering& partnering, int perSpan);

}  // namespace knotspan
