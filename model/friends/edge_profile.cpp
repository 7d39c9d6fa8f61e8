#include "model/friends/edge_profile.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/core/check.h"
#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

struct Place {
    Vec3 at;
    Vec3 along;    // by the parameter of the edge
    Vec3 outward;  // across it, out of the surface
};

// One edge's part in model space.
class Part {
public:
    Part(const SceneObject& object, const EdgePart& part) : object_(object), part_(part)
    {
        const bool atEnd = part.side == Side::endU || part.side == Side::endV;
        const KnotVector& across = alongV() ? object.surface.knotsU() : object.surface.knotsV();
        fixed_ = atEnd ? across.domainEnd() : across.domainStart();
        outwards_ = atEnd ? 1 : -1;
    }

    [[nodiscard]] Place look(double parameter) const
    {
        const SurfacePoint point = alongV() ? evaluate(object_.surface, fixed_, parameter)
                                            : evaluate(object_.surface, parameter, fixed_);
        const Vec3 along = alongV() ? point.dv : point.du;
        const Vec3 across = alongV() ? point.du : point.dv;
        const Mat4& m = object_.transform;
        return {Vec3(m * Vec4(point.position, 1)), Vec3(m * Vec4(along, 0)),
                Vec3(m * Vec4(outwards_ * across, 0))};
    }
    [[nodiscard]] Vec3 at(double parameter) const { return look(parameter).at; }

private:
    [[nodiscard]] bool alongV() const { return part_.side == Side::startU || part_.side == Side::endU; }

    const SceneObject& object_;
    EdgePart part_;
    double fixed_ = 0;
    double outwards_ = 1;
};

double mixed(const EdgePart& part, double t)
{
    return t == 1 ? part.to : part.from + t * (part.to - part.from);
}

// Finds nearest points of a part: the nearest of its samples, then the least distance beside that.
class NearestOn {
public:
    NearestOn(const Part& part, const EdgePart& range) : part_(part), range_(range)
    {
        for (int k = 0; k <= kSamples; ++k)
            points_.push_back(part.at(mixed(range, double(k) / kSamples)));
    }

    [[nodiscard]] double parameter(const Vec3& wanted) const
    {
        int best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= kSamples; ++k) {
            const double distance = glm::length(points_[static_cast<size_t>(k)] - wanted);
            if (distance < least) {
                least = distance;
                best = k;
            }
        }
        const auto distanceAt = [&](double t) { return glm::length(part_.at(mixed(range_, t)) - wanted); };
        double low = std::max(best - 1, 0) / double(kSamples);
        double high = std::min(best + 1, kSamples) / double(kSamples);
        constexpr double kGolden = 0.6180339887498949;
        for (int step = 0; step < 36; ++step) {
            const double left = high - kGolden * (high - low);
            const double right = low + kGolden * (high - low);
            if (distanceAt(left) <= distanceAt(right))
                high = right;
            else
                low = left;
        }
        const double found = (low + high) / 2;
        const double end = found < 0.5 ? 0 : 1;  // whose own point may be nearer than what the search says
        return mixed(range_, distanceAt(end) <= distanceAt(found) ? end : found);
    }

private:
    static constexpr int kSamples = 64;
    const Part& part_;
    const EdgePart& range_;
    std::vector<Vec3> points_;
};

std::optional<double> angleBetween(const Place& a, const Place& b)
{
    const auto across = [&](const Vec3& direction) {
        const Vec3 tangent = glm::normalize(a.along);
        return direction - tangent * glm::dot(direction, tangent);
    };
    const Vec3 out = across(a.outward);
    const Vec3 in = across(-b.outward);
    const double sine = glm::length(glm::cross(out, in));
    const double cosine = glm::dot(out, in);
    const double scale = glm::length(out) * glm::length(in);
    if (!(scale > 1e-24 * (glm::length(a.outward) * glm::length(b.outward))) || !std::isfinite(sine + cosine))
        return {};
    return glm::degrees(std::atan2(sine, cosine));
}

}  // namespace

std::vector<EdgeSample> edgeProfile(const SceneObject& a, const SceneObject& b, const FriendEdge& edge,
                                    int samples)
{
    check(samples >= 2, "a profile has two ends");
    const Part partA(a, edge.a);
    const Part partB(b, edge.b);
    const NearestOn nearest(partB, edge.b);
    std::vector<EdgeSample> profile;
    for (int k = 0; k < samples; ++k) {
        const double parameter = mixed(edge.a, double(k) / (samples - 1));
        const Place here = partA.look(parameter);
        const Place there = partB.look(nearest.parameter(here.at));
        profile.push_back({parameter, glm::length(there.at - here.at), angleBetween(here, there)});
    }
    return profile;
}

Vec3 normalOn(const SceneObject& object, const EdgePart& part, double parameter)
{
    const Place place = Part(object, part).look(parameter);
    const bool swapped = part.side == Side::startU || part.side == Side::endV;
    return (swapped ? -1.0 : 1.0) * glm::cross(place.outward, place.along);
}

}  // namespace knotspan
