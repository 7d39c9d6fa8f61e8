// What the user has chosen: objects, control points of theirs, and what a click would take now.
// Viewport, panels and tools share one.
#pragma once

#include <optional>
#include <set>

#include <QObject>

#include "model/sculpting/point_selection.h"
#include "renderer/renderer.h"

namespace knotspan {

class Selection : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] const std::set<ObjectId>& objects() const { return objects_; }
    [[nodiscard]] bool contains(ObjectId id) const { return objects_.count(id) != 0; }
    // The one that came to the others last, or is alone; nothing where several came at once.
    [[nodiscard]] const std::optional<ObjectId>& latest() const { return latest_; }
    // Of the scene's meshes, which no tool takes.
    [[nodiscard]] const std::set<ObjectId>& meshes() const { return meshes_; }
    [[nodiscard]] const PointSelection& points() const { return points_; }
    // At most one of the two.
    [[nodiscard]] const std::optional<PickedControlPoint>& hovered() const { return hovered_; }
    [[nodiscard]] const std::optional<ObjectId>& hoveredObject() const { return hoveredObject_; }

    // Points of other objects are let go.
    void setObjects(std::set<ObjectId> objects, std::set<ObjectId> meshes = {});
    // Their objects become selected too.
    void setPoints(PointSelection points);
    void setHovered(const std::optional<PickedControlPoint>& point);
    void setHoveredObject(std::optional<ObjectId> object);
    void clear();

    // Lets go of what the scene no longer has or has locked, of points of hidden objects, and of points whose
    // net has another size: their indices name other points then.
    void keepOnly(const Scene& scene);

Q_SIGNALS:
    void changed();  // any of them

private:
    void noteLatest(const std::set<ObjectId>& before);

    std::set<ObjectId> objects_;
    std::optional<ObjectId> latest_;
    std::set<ObjectId> meshes_;
    PointSelection points_;
    std::optional<PickedControlPoint> hovered_;
    std::optional<ObjectId> hoveredObject_;
};

}  // namespace knotspan
