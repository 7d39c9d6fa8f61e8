#include "renderer/scene/curvature_range.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/ksquad.h"

namespace knotspan {

namespace {

constexpr size_t kSamples = 20000;  // of all surfaces together: some milliseconds
constexpr double kShare = 0.95;     // of the samples, which get different colours

SurfacePoint placed(SurfacePoint point, const glm::dmat3& turn)
{
    for (Vec3* derivative : {&point.du, &point.dv, &point.duu, &point.duv, &point.dvv})
        *derivative = turn * *derivative;
    return point;
}

// At four places inside each KSQuad, or of each so many-th.
std::vector<double> samplesOf(const SceneObject& object, CurvatureKind kind, size_t most)
{
    const NurbsSurface& surface = object.surface;
    const glm::dmat3 turn(object.transform);
    const std::vector<KsQuad> quads = ksQuads(surface);
    const size_t step = std::max<size_t>(1, 4 * quads.size() / std::max<size_t>(most, 1));
    std::vector<double> samples;
    for (size_t k = step / 2; k < quads.size(); k += step)
        for (const double u : {0.23, 0.71})
            for (const double v : {0.31, 0.79}) {
                const auto at = [](const KnotVector& knots, int span, double t) {
                    return knots[span] + t * (knots[span + 1] - knots[span]);
                };
                const SurfacePoint point = evaluate(surface, at(surface.knotsU(), quads[k].spanU, u),
                                                    at(surface.knotsV(), quads[k].spanV, v));
                if (const auto bent = curvature(placed(point, turn)))
                    samples.push_back(std::abs(figure(*bent, kind)));
            }
    return samples;
}

NumberRange rangeOf(const std::vector<std::vector<double>>& samples, double least)
{
    std::vector<double> all;
    for (const auto& some : samples)
        all.insert(all.end(), some.begin(), some.end());
    if (all.empty())
        return {-least, least};
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(all.size() - 1));
    std::nth_element(all.begin(), at, all.end());
    double reach = *at;
    if (!(reach > least))  // few places bend
        reach = std::max(least, *std::max_element(all.begin(), all.end()));
    return {-reach, reach};
}

}  // namespace

NumberRange CurvatureRange::of(const std::vector<Resident>& residents, const Look& look, double size,
                               const ResidentChanges* log)
{
    if (look.curvatureRange)
        return *look.curvatureRange;
    const HeldResidents::Difference difference = held_.take(residents, log);
    const bool anew = difference.anew || kind_ != look.curvature;
    if (!anew && difference.changes.empty())
        return range_;
    kind_ = look.curvature;
    const size_t most = kSamples / std::max<size_t>(residents.size(), 1);
    if (anew) {
        samples_.assign(residents.size(), {});
        for (size_t k = 0; k < residents.size(); ++k)
            samples_[k] = samplesOf(*residents[k].object, look.curvature, most);
    } else {
        for (const SurfaceChange& change : difference.changes)
            samples_[change.index] = samplesOf(*residents[change.index].object, look.curvature, most);
    }
    const double flat = size > 0 ? 1e-3 / size : 1;
    range_ = rangeOf(samples_, look.curvature == CurvatureKind::gauss ? flat * flat : flat);
    return range_;
}

}  // namespace knotspan
