#include "ui/measuring_thread.h"

#include <new>

#include <QMutexLocker>

namespace knotspan {

MeasuringThread::MeasuringThread(Scene scene, PathMeasurementRequest request, QObject* parent)
    : QThread(parent),
      scene_(std::move(scene)),
      request_(std::move(request))
{
}

MeasuringThread::~MeasuringThread()
{
    cancel();
    wait();
}

MeasuringThread::State MeasuringThread::state() const
{
    const QMutexLocker lock(&mutex_);
    return state_;
}

void MeasuringThread::fail(const std::string& sentence)
{
    const QMutexLocker lock(&mutex_);
    state_.failure = sentence;
}

void MeasuringThread::publish(const PathMeasurement& measurement)
{
    {
        const QMutexLocker lock(&mutex_);
        state_.rows = measurement.rows();
        state_.rowsDone = measurement.rowsDone();
        state_.viewsDone = measurement.viewsDone();
        state_.views = measurement.views();
    }
    Q_EMIT progressed();
}

void MeasuringThread::run()
{
    try {
        measure();
    } catch (const std::bad_alloc&) {
        fail(tr("The memory is full. Close other programs, or open a smaller model.").toStdString());
    }
}

void MeasuringThread::measure()
{
    const auto renderer = Renderer::create();
    if (!renderer)
        return fail(renderer.error().sentence());
    {
        const QMutexLocker lock(&mutex_);
        state_.device = (*renderer)->deviceInfo();
    }
    PathMeasurement measurement(**renderer, scene_, request_);
    publish(measurement);
    bool more = true;
    while (more && !isInterruptionRequested()) {
        const std::pair before(measurement.rowsDone(), measurement.viewsDone());
        more = measurement.step();
        if (std::pair(measurement.rowsDone(), measurement.viewsDone()) != before)
            publish(measurement);
    }
}

}  // namespace knotspan
