#include "ui/tools/probes.h"

namespace knotspan {

std::optional<ProbedPlace> probed(const Scene& scene, const Probe& probe)
{
    const SharedObject object = scene.find(probe.object);
    if (!object)
        return std::nullopt;
    const double u = object->surface.knotsU().inDomain(probe.u);
    const double v = object->surface.knotsV().inDomain(probe.v);
    return ProbedPlace{object->name, u, v, measuresAt(object->surface, object->transform, u, v),
                       object->bounds().diagonal()};
}

void Probes::pin(ObjectId object, double u, double v)
{
    if (pins_.size() == kMostPins)
        pins_.erase(pins_.begin());
    pins_.push_back({object, u, v, ++lastNumber_});
    Q_EMIT changed();
}

void Probes::unpin(const std::set<int>& numbers)
{
    if (std::erase_if(pins_, [&](const Probe& pin) { return numbers.count(pin.number) != 0; }) > 0)
        Q_EMIT changed();
}

void Probes::clear()
{
    lastNumber_ = 0;
    if (pins_.empty() && !live_)
        return;
    pins_.clear();
    live_.reset();
    Q_EMIT changed();
}

void Probes::setLive(std::optional<Probe> probe)
{
    if (probe == live_)
        return;
    live_ = probe;
    Q_EMIT changed();
}

void Probes::keepOnly(const Scene& scene)
{
    const auto isGone = [&](const Probe& probe) { return scene.find(probe.object) == nullptr; };
    size_t gone = std::erase_if(pins_, isGone);
    if (live_ && isGone(*live_)) {
        live_.reset();
        ++gone;
    }
    if (gone > 0)
        Q_EMIT changed();
}

}  // namespace knotspan
