// What the user has chosen: objects, one of their control points, and the control point under the cursor.
// Viewport, panels and tools share one.
#pragma once

#include <optional>
#include <set>

#include <QObject>

#include "renderer/renderer.h"

namespace knotspan {

class Selection : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] const std::set<ObjectId>& objects() const { return objects_; }
    [[nodiscard]] bool contains(ObjectId id) const { return objects_.count(id) != 0; }
    [[nodiscard]] const std::optional<PickedControlPoint>& controlPoint() const { return controlPoint_; }
    [[nodiscard]] const std::optional<PickedControlPoint>& hovered() const { return hovered_; }

    void setObjects(std::set<ObjectId> objects);
    // Its object becomes selected too. Where `of`, the object as it is, is given, the point is let go as soon
    // as the object's net has another shape: its index then names another point.
    void setControlPoint(const std::optional<PickedControlPoint>& point, const SceneObject* of = nullptr);
    void setHovered(const std::optional<PickedControlPoint>& point);
    void clear();

    // Lets go of what the scene no longer has.
    void keepOnly(const Scene& scene);

Q_SIGNALS:
    void changed();  // any of the three

private:
    using NetShape = std::pair<int, int>;

    std::set<ObjectId> objects_;
    std::optional<PickedControlPoint> controlPoint_;
    std::optional<NetShape> net_;  // of its object
    std::optional<PickedControlPoint> hovered_;
};

}  // namespace knotspan
