#include "model/mesh/deviation_measuring.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace knotspan {

// By the regions of the triangle's plane that its corners and edges are nearest to (Ericson, Real-Time
// Collision Detection, 5.1.5).
double distanceToTriangle(const Vec3& point, const std::array<Vec3, 3>& triangle)
{
    const auto& [a, b, c] = triangle;
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const auto onSegment = [&](const Vec3& from, const Vec3& along) {
        const double squared = glm::dot(along, along);
        const double t = squared > 0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0.0;
        return glm::distance(point, from + t * along);
    };
    const Vec3 normal = glm::cross(ab, ac);
    const double squared = glm::dot(normal, normal);
    const Vec3 ap = point - a;
    const double v = glm::dot(glm::cross(ap, ac), normal);
    const double w = glm::dot(glm::cross(ab, ap), normal);
    // The plane of three points in a line is nothing but rounding.
    constexpr double kFlat = 1e-16;
    const bool hasPlane = squared > kFlat * glm::dot(ab, ab) * glm::dot(ac, ac);
    if (hasPlane && v >= 0 && w >= 0 && v + w <= squared)
        return std::abs(glm::dot(ap, normal)) / std::sqrt(squared);
    return std::min({onSegment(a, ab), onSegment(a, ac), onSegment(b, c - b)});
}

DeviationSampler::DeviationSampler(const NurbsSurface& surface, const Mat4& transform, bool angles,
                                   Threads threads)
    : transform_(transform),
      angles_(angles),
      threads_(threads),
      evaluator_(surface, {.derivatives = angles ? 1 : 0, .normals = angles})
{
}

const std::vector<Vec3>& DeviationSampler::places()
{
    static const std::vector<Vec3> kPlaces = [] {
        std::vector<Vec3> places{{1.0 / 3, 1.0 / 3, 1.0 / 3}};
        for (int k = 0; k < 3; ++k) {
            const auto rotated = [&](double x, double y, double z) {
                Vec3 place;
                place[k] = x;
                place[(k + 1) % 3] = y;
                place[(k + 2) % 3] = z;
                return place;
            };
            places.push_back(rotated(2.0 / 3, 1.0 / 6, 1.0 / 6));
            places.push_back(rotated(1.0 / 6, 5.0 / 12, 5.0 / 12));
            for (const double t : {0.25, 0.5, 0.75})
                places.push_back(rotated(0, t, 1 - t));
        }
        return places;
    }();
    return kPlaces;
}

void DeviationSampler::add(const std::array<Vec3, 3>& triangle, std::span<const SpanParameter> u,
                           std::span<const SpanParameter> v)
{
    triangles_.push_back(triangle);
    u_.insert(u_.end(), u.begin(), u.end());
    v_.insert(v_.end(), v.begin(), v.end());
    if (u_.size() > 1U << 16U)
        look();
}

MeshDeviation DeviationSampler::result()
{
    look();
    return found_;
}

void DeviationSampler::look()
{
    if (u_.empty())
        return;
    evaluator_.evaluateScattered(u_, v_, samples_, threads_);
    const glm::dmat3 toNormals = glm::transpose(glm::inverse(glm::dmat3(transform_)));
    const size_t perTriangle = places().size();
    for (size_t k = 0; k < u_.size(); ++k) {
        const std::array<Vec3, 3>& triangle = triangles_[k / perTriangle];
        const int column = static_cast<int>(k);
        const Vec3 point = transformed(samples_.origin() + samples_.position(0, column), transform_);
        found_.largest = std::max(found_.largest, distanceToTriangle(point, triangle));
        if (!angles_)
            continue;
        const Vec3 flat = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
        const Vec3 normal = toNormals * samples_.normal(0, column);
        const double angle =
            std::atan2(glm::length(glm::cross(flat, normal)), std::abs(glm::dot(flat, normal)));
        found_.largestAngle = std::max(found_.largestAngle, glm::degrees(angle));
    }
    triangles_.clear();
    u_.clear();
    v_.clear();
}

namespace {

// Of the outlines' own curves from the edges that stand for them.
double measuredAlongChords(const Tessellation& tessellation, const Scene& scene)
{
    double largest = 0;
    for (size_t first = 0; first < tessellation.chords.size();) {
        const ObjectId object = tessellation.chords[first].object;
        std::vector<SpanParameter> u;
        std::vector<SpanParameter> v;
        size_t end = first;
        for (; end < tessellation.chords.size() && tessellation.chords[end].object == object; ++end)
            for (const auto& place : tessellation.chords[end].places) {
                u.push_back(place[0]);
                v.push_back(place[1]);
            }
        const SharedObject of = scene.find(object);
        const GridEvaluator<double> evaluator(of->surface, {});
        GridSamples<double> samples;
        evaluator.evaluateScattered(u, v, samples, Threads::one);
        const size_t perChord = tessellation.chords[first].places.size();
        for (size_t k = 0; k < u.size(); ++k) {
            const auto& ends = tessellation.chords[first + k / perChord].vertices;
            const Vec3& a = tessellation.mesh.vertices[ends[0]];
            const Vec3& b = tessellation.mesh.vertices[ends[1]];
            const Vec3 point =
                transformed(samples.origin() + samples.position(0, static_cast<int>(k)), of->transform);
            largest = std::max(largest, distanceToTriangle(point, {a, b, b}));
        }
        first = end;
    }
    return largest;
}

}  // namespace

MeshDeviation measuredDeviation(const Tessellation& tessellation, const Scene& scene, bool angles,
                                Threads threads)
{
    MeshDeviation result;
    const auto include = [&](const MeshDeviation& found) {
        result.largest = std::max(result.largest, found.largest);
        result.largestAngle = std::max(result.largestAngle, found.largestAngle);
    };
    std::optional<DeviationSampler> sampler;
    std::optional<ObjectId> object;
    const std::vector<Vec3>& places = DeviationSampler::places();
    std::vector<SpanParameter> u(places.size());
    std::vector<SpanParameter> v(places.size());
    for (size_t p = 0; p < tessellation.patches.size(); ++p) {
        const MeshPatch& patch = tessellation.patches[p];
        if (object != patch.object) {
            if (sampler)
                include(sampler->result());
            object = patch.object;
            const SharedObject of = scene.find(patch.object);
            sampler.emplace(of->surface, of->transform, angles, threads);
        }
        for (size_t k = patch.firstTriangle; k < tessellation.endOf(p); ++k) {
            const Triangle& triangle = tessellation.mesh.triangles[k];
            const TriangleParameters& t = tessellation.parameters[k];
            for (size_t place = 0; place < places.size(); ++place) {
                const Vec3& share = places[place];
                const Vec2 at = share.x * t[0] + share.y * t[1] + share.z * t[2];
                u[place] = {patch.quad.spanU, std::clamp(at.x, 0.0, 1.0)};
                v[place] = {patch.quad.spanV, std::clamp(at.y, 0.0, 1.0)};
            }
            sampler->add({tessellation.mesh.vertices[triangle[0]], tessellation.mesh.vertices[triangle[1]],
                          tessellation.mesh.vertices[triangle[2]]},
                         u, v);
        }
    }
    if (sampler)
        include(sampler->result());
    result.largest = std::max(result.largest, measuredAlongChords(tessellation, scene));
    return result;
}

}  // namespace knotspan
