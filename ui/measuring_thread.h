// Measures paths beside the window: on a thread of its own, with a renderer of its own, because a driver may
// compile shaders for seconds, and on a snapshot of the scene, so that the model may be edited meanwhile.
#pragma once

#include <QMutex>
#include <QString>
#include <QThread>

#include "renderer/measurement/path_measurement.h"

namespace knotspan {

class MeasuringThread : public QThread {
    Q_OBJECT

public:
    MeasuringThread(Scene scene, PathMeasurementRequest request, QObject* parent = nullptr);
    // Waits for the frame that is being drawn.
    ~MeasuringThread() override;

    // Acts before the next frame.
    void cancel() { requestInterruption(); }

    // What there is so far. From any thread.
    struct State {
        std::vector<PathRow> rows;
        size_t rowsDone = 0;
        size_t viewsDone = 0;  // of the next row
        size_t views = 1;
        std::optional<DeviceInfo> device;
        std::string failure;  // a sentence: nothing could be measured
    };
    [[nodiscard]] State state() const;

Q_SIGNALS:
    void progressed();

protected:
    void run() override;

private:
    void measure();
    void publish(const PathMeasurement& measurement);
    void fail(const std::string& sentence);

    Scene scene_;
    PathMeasurementRequest request_;
    mutable QMutex mutex_;
    State state_;
};

}  // namespace knotspan
