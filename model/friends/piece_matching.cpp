#include "model/friends/piece_matching.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "model/analysis/bezier_curves.h"
#include "model/friends/meeting_forms.h"
#include "model/friends/nearest_place.h"

namespace knotspan {

ShiftedPiece shifted(const EdgePiece& piece, const Vec3& by)
{
    ShiftedPiece result{piece.rows.at, piece.samples};
    for (Vec4& point : result.curve)
        point += Vec4(point.w * by, 0);
    for (Vec3& sample : result.samples)
        sample += by;
    return result;
}

bool plainlyApart(const EdgePiece& a, const EdgePiece& b, const MatchingLengths& lengths)
{
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::max(a.box.low[axis], b.box.low[axis]) <=
              std::min(a.box.high[axis], b.box.high[axis]) + lengths.reach))
            return true;
    // Chords of parts that run together differ by 2 reach at most, and lie within both cones of tangents.
    if (std::min(a.length, b.length) < lengths.shortest)
        return false;
    const double between = std::acos(std::min(1.0, std::abs(glm::dot(a.axis, b.axis))));
    const double angle = std::min(between - a.spread - b.spread, std::numbers::pi / 2);
    return angle > 0 &&
           2 * lengths.reach < lengths.shortest * std::sin(angle) * std::cos(std::min(a.spread, b.spread));
}

namespace {

// A place on a, and the nearest one on b.
struct Joint {
    double s = 0;
    double t = 0;
    double distance = 0;
};

class Walk {
public:
    Walk(const EdgePiece& a, const ShiftedPiece& b, const MatchingLengths& lengths)
        : a_(a.rows.at),
          aSamples_(a.samples),
          b_(b),
          isClosed_(glm::distance(pointOf(b.curve.front()), pointOf(b.curve.back())) <= lengths.point),
          lengths_(lengths)
    {
    }

    std::vector<MatchedPart> parts()
    {
        std::vector<Joint> joints = {jointAt(0), jointAt(1)};
        for (const double end : {0.0, 1.0}) {
            const Vec3 point = pointOf(end == 0.0 ? b_.curve.front() : b_.curve.back());
            const NearestPlace place = snapped(a_, nearestPlace(a_, aSamples_, point));
            if (place.distance <= lengths_.reach && place.t > 0.0 && place.t < 1.0)
                joints.push_back({place.t, end, place.distance});
        }
        std::sort(joints.begin(), joints.end(),
                  [](const Joint& x, const Joint& y) { return x.s != y.s ? x.s < y.s : x.t < y.t; });
        for (size_t k = 0; k + 1 < joints.size(); ++k)
            between(joints[k], joints[k + 1], 0);
        return std::move(found_);
    }

private:
    // At an end where it is as good as there.
    [[nodiscard]] NearestPlace snapped(const std::vector<Vec4>& curve, NearestPlace place) const
    {
        const Vec3 at = lookAt(curve, place.t).at;
        if (glm::distance(at, pointOf(curve.front())) <= lengths_.point)
            place.t = 0;
        else if (glm::distance(at, pointOf(curve.back())) <= lengths_.point)
            place.t = 1;
        return place;
    }

    [[nodiscard]] Joint jointAt(double s) const
    {
        const NearestPlace place = snapped(b_.curve, nearestPlace(b_.curve, b_.samples, lookAt(a_, s).at));
        return {s, place.t, place.distance};
    }

    // Where b begins and ends in one point, the nearest place there may be either.
    [[nodiscard]] Joint turned(Joint joint, bool isHigh) const
    {
        if (!isClosed_ || (joint.t != 0.0 && joint.t != 1.0))
            return joint;
        const Vec3 slope = lookAt(a_, joint.s).slope;
        const auto runsAlong = [&](double t) { return glm::dot(slope, lookAt(b_.curve, t).slope) > 0; };
        // b rises towards its end or from its start, or falls from its end or towards its start.
        const bool atEnd = runsAlong(1) == isHigh;
        const bool atStart = runsAlong(0) != isHigh;
        if (atEnd != atStart)
            joint.t = atEnd ? 1 : 0;
        return joint;
    }

    void between(const Joint& from, const Joint& to, int depth)
    {
        const Joint low = turned(from, false);
        const Joint high = turned(to, true);
        if (!(low.s < high.s) || looks_ >= kMostLooks)
            return;
        ++looks_;
        const std::vector<Vec4> curve = part(a_, low.s, high.s);
        if (const auto fitted = fit(low, high, curve)) {
            if (fitted->second)
                found_.push_back(fitted->first);
            return;
        }
        const Joint middle = jointAt(low.s + (high.s - low.s) / 2);
        // Nearest to all of it is one end of b, which it runs towards or away from.
        if (low.t == high.t && middle.t == low.t && (low.t == 0.0 || low.t == 1.0))
            return;
        const Vec3 centre = lookAt(a_, middle.s).at;
        double radius = 0;
        for (const Vec4& point : curve)
            radius = std::max(radius, glm::distance(pointOf(point), centre));
        // The distance changes no faster than the place.
        if (!(middle.distance <= lengths_.reach + radius) || radius < lengths_.shortest / 32 || depth > 40)
            return;
        between(low, middle, depth + 1);
        between(middle, high, depth + 1);
    }

    // The projective map through both ends and the middle, where what it matches is nearest; and whether that
    // is within reach all along. Nothing where it is neither that nor beyond reach all along.
    [[nodiscard]] std::optional<std::pair<MatchedPart, bool>> fit(const Joint& low, const Joint& high,
                                                                  const std::vector<Vec4>& curve) const
    {
        const bool within = low.distance <= lengths_.reach && high.distance <= lengths_.reach;
        const bool beyond = low.distance > lengths_.reach && high.distance > lengths_.reach;
        if (low.t == high.t || (!within && !beyond) || low.distance > 2 * lengths_.reach)
            return std::nullopt;
        std::vector<Vec4> other = part(b_.curve, low.t, high.t);
        const double chordA = glm::distance(pointOf(curve.front()), pointOf(curve.back()));
        const double chordB = glm::distance(pointOf(other.front()), pointOf(other.back()));
        if (!(chordB >= chordA / 4 - lengths_.slip))
            return std::nullopt;
        MatchedPart result{0, 0, low.s, high.s, low.t, high.t, 1};
        const Vec3 middle = lookAt(curve, 0.5).at;
        const NearestPlace place = nearestFrom(other, middle, 0.5);
        if (place.t < 0.02 || place.t > 0.98)
            return std::nullopt;
        const double away = glm::distance(lookAt(other, place.t).at, lookAt(other, 0.5).at);
        if (away > lengths_.point) {
            result.factor = place.t / (1 - place.t);
            projective(other, result.factor);
        }
        for (const double tau : {0.25, 0.5, 0.75})
            if (!(slipAt(curve, other, tau) <= lengths_.slip))
                return std::nullopt;
        if (!(slipBound(curve, other) <= 2 * lengths_.slip))
            return std::nullopt;
        const Form form = gapForm(curve, other);
        if (within ? gapBound(form) <= lengths_.reach * (1 + 1e-9) : leastGap(form) > lengths_.reach)
            return std::pair(result, within);
        return std::nullopt;
    }

    // How far along b the point at tau is from the nearest one, to first order.
    [[nodiscard]] static double slipAt(const std::vector<Vec4>& a, const std::vector<Vec4>& b, double tau)
    {
        const CurvePoint y = lookAt(b, tau);
        return std::abs(glm::dot(lookAt(a, tau).at - y.at, y.slope)) / glm::length(y.slope);
    }

    const std::vector<Vec4>& a_;
    const std::array<Vec3, kEdgeSamples>& aSamples_;
    const ShiftedPiece& b_;
    bool isClosed_;
    const MatchingLengths& lengths_;
    // Only edges that go back and forth within the tolerance need more; what is not looked at is not matched.
    static constexpr int kMostLooks = 1000;
    int looks_ = 0;
    std::vector<MatchedPart> found_;
};

}  // namespace

std::vector<MatchedPart> matchPieces(const EdgePiece& a, const ShiftedPiece& b,
                                     const MatchingLengths& lengths)
{
    return Walk(a, b, lengths).parts();
}

}  // namespace knotspan
