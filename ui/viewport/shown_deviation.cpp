#include "ui/viewport/shown_deviation.h"

#include <QTimer>

namespace knotspan {

namespace {

enum class Part { measured, reference };

template <class Object>
std::shared_ptr<const Object> shown(const std::shared_ptr<const Object>& object)
{
    if (object->visible)
        return object;
    auto copy = std::make_shared<Object>(*object);
    copy->visible = true;
    return copy;
}

// What of the scene is on that side. A reference that was named counts though it is hidden: so it does not
// cover the colours.
Scene partOf(const Scene& scene, const DeviationSettings& settings, Part part)
{
    const bool isMeasured = part == Part::measured;
    const std::set<ObjectId>& own = isMeasured ? settings.measured : settings.reference;
    const std::set<ObjectId>& other = isMeasured ? settings.reference : settings.measured;
    const bool nobodyNamed = own.empty() && other.empty();
    const auto belongs = [&](ObjectId id, bool isSurface) {
        if (!own.empty())
            return own.count(id) != 0 && (isMeasured || other.count(id) == 0);
        return other.count(id) == 0 && (!nobodyNamed || isSurface == isMeasured);
    };
    const bool hiddenToo = !isMeasured && !own.empty();
    Scene taken;
    taken.setUnits(scene.units());
    for (const auto& [id, object] : scene.objects())
        if ((hiddenToo || object->visible) && belongs(id, true))
            taken.exchange(id, shown(object));
    if (!isMeasured)
        for (const auto& [id, mesh] : scene.meshes())
            if ((hiddenToo || mesh->visible) && belongs(id, false))
                taken.exchangeMesh(id, shown(mesh));
    return taken;
}

}  // namespace

DeviationThread::DeviationThread(Scene measured, Scene reference, QObject* parent)
    : QThread(parent),
      measured_(std::move(measured)),
      reference_(std::move(reference))
{
}

DeviationThread::~DeviationThread()
{
    requestInterruption();
    wait();
}

void DeviationThread::run()
{
    found_ = deviationMap(measured_, reference_, 1, [this] { return isInterruptionRequested(); });
}

ShownDeviation::ShownDeviation(const Document& document, QObject* parent)
    : QObject(parent),
      document_(document)
{
    connect(&document_, &Document::sceneChanged, this, [this] { isStale_ = true; });
    connect(&document_, &Document::documentReplaced, this, [this] {
        settings_ = {};
        forget();
        Q_EMIT changed();
    });
}

ShownDeviation::~ShownDeviation() = default;

void ShownDeviation::setSettings(const DeviationSettings& settings)
{
    if (settings == settings_)
        return;
    settings_ = settings;
    forget();
    Q_EMIT changed();
}

void ShownDeviation::rest()
{
    if (map_ || thread_)
        forget();
}

SharedSurfaceNumbers ShownDeviation::follow()
{
    if (isStale_ && !thread_)
        measure();
    return map() != nullptr ? map()->distances : nullptr;
}

void ShownDeviation::forget()
{
    if (thread_)
        thread_->requestInterruption();
    isStale_ = true;
    map_.reset();
}

void ShownDeviation::measure()
{
    const Scene& scene = document_.scene();
    isStale_ = false;
    Scene measured = partOf(scene, settings_, Part::measured);
    Scene reference = partOf(scene, settings_, Part::reference);
    if (measured.objects().empty() || (reference.objects().empty() && reference.meshes().empty())) {
        map_ = knotspan::failure("There is nothing to compare",
                                 "Select surfaces, or show what they are to be compared with, and take both "
                                 "in the panel Measures");
        QTimer::singleShot(0, this, &ShownDeviation::changed);  // this is asked from within a picture
        return;
    }
    thread_ = std::make_unique<DeviationThread>(std::move(measured), std::move(reference));
    connect(thread_.get(), &QThread::finished, this, &ShownDeviation::takeResult);
    thread_->start(QThread::LowPriority);
}

// What an edit of a moment ago made stale is shown all the same: under the hand it is nearly right, and
// whatever shows it asks to follow() again. What other settings made stale is not.
void ShownDeviation::takeResult()
{
    const bool isOff = thread_->isInterruptionRequested();
    if (!isOff)
        map_ = thread_->found();
    thread_.reset();
    Q_EMIT changed();
}

QString ShownDeviation::failure() const
{
    return map_ && !*map_ ? QString::fromStdString(map_->error().sentence()) : QString();
}

}  // namespace knotspan
