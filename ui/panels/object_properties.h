// What is measured of a whole object, and the thread that does it beside the window: many surfaces take
// longer than a hand waits.
#pragma once

#include <map>

#include <QMutex>
#include <QThread>

#include "model/analysis/trimmed_area.h"
#include "model/scene/scene.h"

namespace knotspan {

struct ObjectProperties {
    Box bounds;  // of the surface itself, or of the mesh's vertices; model space
    Area area;
};

// A surface or a mesh, whichever it is.
struct MeasuredObject {
    SharedObject surface;
    SharedMesh mesh;

    [[nodiscard]] bool operator==(const MeasuredObject&) const = default;
};
using MeasuredObjects = std::map<ObjectId, MeasuredObject>;

[[nodiscard]] ObjectProperties propertiesOf(const MeasuredObject& object, const std::function<bool()>& isOff);

class PropertiesThread : public QThread {
    Q_OBJECT

public:
    explicit PropertiesThread(MeasuredObjects objects, QObject* parent = nullptr);
    // Waits for the part of an object that is being measured.
    ~PropertiesThread() override;

    [[nodiscard]] const MeasuredObjects& objects() const { return objects_; }
    // Those that are done. From any thread.
    [[nodiscard]] std::map<ObjectId, ObjectProperties> done() const;

protected:
    void run() override;

private:
    MeasuredObjects objects_;
    mutable QMutex mutex_;
    std::map<ObjectId, ObjectProperties> done_;
};

}  // namespace knotspan
