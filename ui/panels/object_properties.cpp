#include "ui/panels/object_properties.h"

#include <cmath>

#include <QMutexLocker>

#include "model/analysis/surface_bounds.h"

namespace knotspan {

ObjectProperties propertiesOf(const MeasuredObject& object, const std::function<bool()>& isOff)
{
    ObjectProperties found;
    if (object.surface) {
        found.area =
            trimmedArea(object.surface->surface, object.surface->trimLoops, object.surface->transform, isOff);
        if (!isOff())
            found.bounds =
                trimmedBounds(object.surface->surface, object.surface->trimLoops, object.surface->transform);
        return found;
    }
    for (const Vec3& vertex : object.mesh->mesh->vertices)
        found.bounds.add(transformed(vertex, object.mesh->transform));
    found.area.value = meshArea(*object.mesh->mesh, object.mesh->transform);
    return found;
}

PropertiesThread::PropertiesThread(MeasuredObjects objects, QObject* parent)
    : QThread(parent),
      objects_(std::move(objects))
{
}

PropertiesThread::~PropertiesThread()
{
    requestInterruption();
    wait();
}

std::map<ObjectId, ObjectProperties> PropertiesThread::done() const
{
    const QMutexLocker lock(&mutex_);
    return done_;
}

void PropertiesThread::run()
{
    const auto isOff = [this] { return isInterruptionRequested(); };
    for (const auto& [id, object] : objects_) {
        const ObjectProperties found = propertiesOf(object, isOff);
        if (isOff())
            return;
        const QMutexLocker lock(&mutex_);
        done_.emplace(id, found);
    }
}

}  // namespace knotspan
