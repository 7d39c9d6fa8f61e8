#include "model/mesh/outlined_face.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

OutlinedFace::OutlinedFace(const PlacedSurface& placed, const TrimRegion& region)
    : surface_(placed.surface),
      transform_(placed.transform),
      trimmed_(region.isTrimmed()),
      arcs_(outlineOf(region)),
      evaluator_(std::make_unique<GridEvaluator<double>>(*placed.surface, SampleFields{})),
      found_(std::make_unique<GridSamples<double>>())
{
    constexpr double kFewest = 24;  // an arc
    for (std::uint32_t arc = 0; arc < arcs_.size(); ++arc) {
        const double end = arcs_[arc].end();
        const double steps = std::max(4.0, std::ceil(kFewest / end)) * end;
        std::vector<Sample> samples;
        for (double k = 0; k <= steps; ++k) {
            const double t = k == steps ? end : end * k / steps;
            samples.push_back({t, pointOn(arc, t)});
        }
        samples_.push_back(std::move(samples));
    }
}

std::array<SpanParameter, 2> OutlinedFace::parametersAt(const OutlinePlace& place) const
{
    return {SpanParameter{surface_->knotsU().spans()[static_cast<size_t>(place.a)], place.t.x},
            SpanParameter{surface_->knotsV().spans()[static_cast<size_t>(place.b)], place.t.y}};
}

Vec3 OutlinedFace::pointAt(const OutlinePlace& place) const
{
    const auto [u, v] = parametersAt(place);
    evaluator_->evaluateScattered({&u, 1}, {&v, 1}, *found_, Threads::one);
    return transformed(found_->origin() + found_->position(0, 0), transform_);
}

OutlinedFace::Nearest OutlinedFace::nearest(std::uint32_t arc, double from, double to,
                                            const Vec3& point) const
{
    Nearest best{from, glm::distance(pointOn(arc, from), point)};
    const auto consider = [&](double t, const Vec3& at) {
        if (const double distance = glm::distance(at, point); distance < best.distance)
            best = {t, distance};
    };
    const std::vector<Sample>& samples = samples_[arc];
    double step = samples[1].t - samples[0].t;
    for (const Sample& sample : samples)
        if (sample.t > from && sample.t < to)
            consider(sample.t, sample.point);
    consider(to, pointOn(arc, to));
    return nearestFrom(arc, std::max(from, best.t - step), std::min(to, best.t + step), best.t, point);
}

// Newton's method for the foot of the perpendicular, with tangents from differences. Where it does not get
// there, because pieces are much shorter than their neighbours, all of them are looked through.
OutlinedFace::Nearest OutlinedFace::nearestFrom(std::uint32_t arc, double from, double to, double guess,
                                                const Vec3& point) const
{
    bool settled = false;
    const Nearest found = descended(arc, from, to, guess, point, settled);
    return settled ? found : lookedThrough(arc, from, to, point, found);
}

OutlinedFace::Nearest OutlinedFace::descended(std::uint32_t arc, double from, double to, double guess,
                                              const Vec3& point, bool& settled) const
{
    constexpr int kSteps = 16;
    constexpr double kAskew = 1e-3;
    Nearest best{guess, glm::distance(pointOn(arc, guess), point)};
    const double width = 1e-4 * (to - from);
    double t = guess;
    settled = false;
    for (int k = 0; k < kSteps && width > 0 && !settled; ++k) {
        const double low = std::max(from, t - width);
        const double high = std::min(to, t + width);
        const Vec3 tangent = (pointOn(arc, high) - pointOn(arc, low)) / (high - low);
        const double squared = glm::dot(tangent, tangent);
        if (squared <= 0)
            break;
        const Vec3 away = point - pointOn(arc, t);
        const double next = std::clamp(t + glm::dot(away, tangent) / squared, from, to);
        if (const double distance = glm::distance(pointOn(arc, next), point); distance < best.distance)
            best = {next, distance};
        settled = std::abs(next - t) < 1e-11 * (1 + std::abs(t)) &&
                  (next == from || next == to ||
                   std::abs(glm::dot(away, tangent)) <= kAskew * glm::length(away) * std::sqrt(squared));
        t = next;
    }
    return best;
}

OutlinedFace::Nearest OutlinedFace::lookedThrough(std::uint32_t arc, double from, double to,
                                                  const Vec3& point, Nearest best) const
{
    constexpr double kPerPiece = 4;
    constexpr int kHalvings = 60;
    std::vector<double> places{from};
    for (double t = std::floor(from * kPerPiece + 1) / kPerPiece; t < to; t += 1 / kPerPiece)
        places.push_back(t);
    places.push_back(to);
    const auto distanceAt = [&](double t) { return glm::distance(pointOn(arc, t), point); };
    size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k < places.size(); ++k)
        if (const double distance = distanceAt(places[k]); distance < least) {
            least = distance;
            nearest = k;
        }
    // The golden section.
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double low = places[nearest > 0 ? nearest - 1 : 0];
    double high = places[std::min(nearest + 1, places.size() - 1)];
    for (int k = 0; k < kHalvings; ++k) {
        const double first = high - golden * (high - low);
        const double second = low + golden * (high - low);
        (distanceAt(first) < distanceAt(second) ? high : low) =
            distanceAt(first) < distanceAt(second) ? second : first;
    }
    for (const Nearest& found : {Nearest{places[nearest], least}, Nearest{low, distanceAt(low)}})
        if (found.distance < best.distance)
            best = found;
    // To the last digits, which the golden section has only half of.
    bool settled = false;
    const Nearest found = descended(arc, from, to, best.t, point, settled);
    return found.distance < best.distance ? found : best;
}

}  // namespace knotspan
