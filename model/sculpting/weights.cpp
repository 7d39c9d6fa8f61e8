#include "model/sculpting/weights.h"

#include "model/sculpting/with_points.h"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "model/core/check.h"

namespace knotspan {

namespace {

std::string text(double value)
{
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.6g", value);
    return buffer;
}

// The bounds themselves, where rounding led past them.
double settled(double weight)
{
    constexpr double kRounding = 1e-12;
    if (weight < kLeastWeight && weight >= kLeastWeight * (1 - kRounding))
        return kLeastWeight;
    if (weight > kMostWeight && weight <= kMostWeight * (1 + kRounding))
        return kMostWeight;
    return weight;
}

SharedObject objectOf(const Scene& scene, ObjectId id, const SelectedPoints& selected)
{
    SharedObject object = scene.find(id);
    check(object && netSizeOf(object->surface) == selected.net, "selected control points are the scene's");
    return object;
}

template <class NewWeight>
Result<SharedObject> withNewWeights(const SharedObject& object, const SelectedPoints& selected,
                                    const NewWeight& newWeight)
{
    std::vector<ControlPoint> points = object->surface.controlPoints();
    bool changes = false;
    for (const ControlPointIndex index : selected.points) {
        double& weight = points[selected.net.place(index)].weight;
        const double wanted = settled(newWeight(weight));
        if (!(wanted >= kLeastWeight && wanted <= kMostWeight))
            return failure("A weight would be " + text(wanted),
                           "Choose weights from " + text(kLeastWeight) + " to " + text(kMostWeight));
        changes = changes || wanted != weight;
        weight = wanted;
    }
    if (!changes)
        return object;
    return withPoints(*object, std::move(points));
}

template <class NewWeight>
Result<Edit> editOf(const Scene& scene, const PointSelection& selection, const NewWeight& newWeight)
{
    Edit edit;
    for (const auto& [id, selected] : selection.objects()) {
        const SharedObject object = objectOf(scene, id, selected);
        auto changed = withNewWeights(object, selected, newWeight);
        if (!changed)
            return tl::unexpected(changed.error());
        if (*changed != object)
            edit.set(id, *std::move(changed));
    }
    return edit;
}

}  // namespace

Result<Edit> withWeights(const Scene& scene, const PointSelection& selection, double weight)
{
    return editOf(scene, selection, [weight](double) { return weight; });
}

Result<Edit> withWeightsScaled(const Scene& scene, const PointSelection& selection, double factor)
{
    return editOf(scene, selection, [factor](double weight) { return weight * factor; });
}

FactorRange factorRange(const Scene& scene, const PointSelection& selection)
{
    FactorRange range{0, std::numeric_limits<double>::max()};
    for (const auto& [id, selected] : selection.objects()) {
        const SharedObject object = objectOf(scene, id, selected);
        for (const ControlPointIndex index : selected.points) {
            const double weight = object->surface.controlPoint(index.i, index.j).weight;
            range.low = std::max(range.low, kLeastWeight / weight);
            range.high = std::min(range.high, kMostWeight / weight);
        }
    }
    return range;
}

}  // namespace knotspan
