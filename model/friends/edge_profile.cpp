#include "model/friends/edge_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/core/check.h"
#include "model/friends/scene_friends.h"
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
    Part(const SceneObject& object, const EdgePart& part) : object_(object), part_(part) {}

    [[nodiscard]] Place look(double parameter) const
    {
        const Vec2 at = parametersOn(object_, part_, parameter);
        const Vec2 way = wayAt(parameter);
        const SurfacePoint point = evaluate(object_.surface, at.x, at.y);
        const Mat4& m = object_.transform;
        return {Vec3(m * Vec4(point.position, 1)), Vec3(m * Vec4(way.x * point.du + way.y * point.dv, 0)),
                Vec3(m * Vec4(sign() * (way.y * point.du - way.x * point.dv), 0))};
    }
    [[nodiscard]] Vec3 at(double parameter) const { return look(parameter).at; }

    // 1 where the surface lies to the left of the way, seen in (u, v); else -1.
    [[nodiscard]] double sign() const
    {
        return !part_.trim && (part_.side == Side::startU || part_.side == Side::endV) ? -1 : 1;
    }

private:
    // The derivative of (u, v) by the parameter.
    [[nodiscard]] Vec2 wayAt(double parameter) const
    {
        if (part_.trim)
            return object_.trimLoops[part_.trim->loop].curves[part_.trim->curve].derivative(parameter);
        return part_.side == Side::startU || part_.side == Side::endU ? Vec2(0, 1) : Vec2(1, 0);
    }

    const SceneObject& object_;
    EdgePart part_;
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
    std::vector<double> parameters;
    for (int k = 0; k < samples; ++k)
        parameters.push_back(mixed(edge.a, double(k) / (samples - 1)));
    const auto next = std::lower_bound(parameters.begin(), parameters.end(), edge.worst);
    if (next != parameters.begin() && next != parameters.end() && *next != edge.worst)
        parameters.insert(next, edge.worst);
    std::vector<EdgeSample> profile;
    for (const double parameter : parameters) {
        const Place here = partA.look(parameter);
        const Place there = partB.look(nearest.parameter(here.at));
        profile.push_back({parameter, glm::length(there.at - here.at), angleBetween(here, there)});
    }
    return profile;
}

Vec3 normalOn(const SceneObject& object, const EdgePart& edge, double parameter)
{
    const Part part(object, edge);
    const Place place = part.look(parameter);
    return part.sign() * glm::cross(place.outward, place.along);
}

}  // namespace knotspan
