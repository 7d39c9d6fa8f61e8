// Friends: parts of edges that run together within a tolerance, and how smoothly their surfaces meet there.
//
// Verdicts come from Bernstein coefficients, subdivided until they are certain, never from samples. Degrees,
// directions, knots and parametrizations of the two sides may differ; one edge may meet several others, or
// its own surface (a seam).
//
// An edge is one whole side of a surface or, of a trimmed one, one curve of a trim loop. What is compared are
// points of both edges that are nearest to each other, to 0.6 % of the gap tolerance. Parts shorter than ten
// gap tolerances (or than half the shorter edge) do not count, so that edges which only share a corner do not
// meet; an edge no longer than three is a point: it neither meets anybody nor is it naked.
#pragma once

#include <memory>
#include <vector>

#include "model/friends/edge_part.h"

namespace knotspan {

enum class Continuity {
    none,  // further apart than the tolerance somewhere, though nowhere than three tolerances
    g0,    // they meet, with a kink or a cusp
    g1,    // tangent planes agree within the tolerance, and the surfaces run on, not back
    g2,    // and so do curvatures
    // No tangent plane all along or at a place within the edge, or subdivision could not decide. Where an
    // edge ends in a pole, the limit along it counts.
    undetermined,
};
[[nodiscard]] const char* continuityName(Continuity continuity);  // "none", "G0", "G1", "G2", "undetermined"
// From the worst on: none, undetermined, G0, G1, G2.
[[nodiscard]] int smoothnessRank(Continuity continuity);

struct FriendTolerances {
    double gap = 1e-3;      // model units
    double angleDeg = 0.1;  // between tangent planes
    // Between the normal curvatures across the edge, perpendicular to it, at each point: their difference to
    // the larger one, or to 1 / (10 times the larger surface's diagonal) where both are below that.
    double curvature = 0.01;
    [[nodiscard]] bool operator==(const FriendTolerances&) const = default;
};
// What other programs wrote need not be smoother than what they call smooth: half a degree.
[[nodiscard]] FriendTolerances defaultTolerances(bool imported);

// Its ends are within the gap tolerance, or no point of it is (`none`, from thirty gap tolerances' length
// on).
struct FriendEdge {
    EdgePart a;
    EdgePart b;
    bool reversed = false;  // b's parameter falls where a's rises
    // Guaranteed: what is true is never above; and, where a verdict depended on it, within 1 % of it.
    double gapMax = 0;
    double angleBoundDeg = 0;  // 180 where nothing can be guaranteed
    // Attained somewhere along the edge: what is true is never below.
    double angleMaxDeg = 0;
    // Largest difference of normal curvatures across the edge that was met, 1/unit; 0 where it is not G1.
    // Where curvatures have no limit at an edge's end, or could not be decided, the verdict stays G1.
    double curvatureMax = 0;
    Continuity continuity = Continuity::none;
    double worst = 0;  // a's parameter where what spoils the verdict is largest
    Vec3 worstPoint{0};
    [[nodiscard]] bool areFriends() const
    {
        return continuity >= Continuity::g1 && continuity <= Continuity::g2;
    }
    [[nodiscard]] bool operator==(const FriendEdge&) const = default;
};

// All pairs among surfaces, kept up to date.
class Friends {
public:
    explicit Friends(const std::vector<PlacedSurface>& surfaces = {},
                     const FriendTolerances& tolerances = {});
    ~Friends();
    Friends(Friends&&) noexcept;
    Friends& operator=(Friends&&) noexcept;

    using Change = SurfaceChange;
    // Looks again only at edges that moved and at what they met or meet now. The result is as if all were
    // made anew, to the bit. Each surface has as many edges as before.
    void update(const std::vector<Change>& changes);

    // By the surface and side of a, then of b, then by where on a; a is before b.
    [[nodiscard]] const std::vector<FriendEdge>& edges() const;
    // Parts of edges that nobody runs along, not even at three gap tolerances: what is listed as `none` is
    // not listed here again. Increasing.
    [[nodiscard]] const std::vector<EdgePart>& nakedEdges() const;
    // Edges that take no part only because the gap tolerance is so large: no longer than three of it, but
    // longer than 1e-9 of their surface. Increasing.
    [[nodiscard]] const std::vector<EdgePart>& shortEdges() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace knotspan
