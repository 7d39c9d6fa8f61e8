// A scene is a value: ids and the immutable objects behind them. Copying it takes a snapshot, for undo, for
// saving on another thread and for the renderer; an equal pointer is an unchanged object.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "model/scene/scene_object.h"

namespace knotspan {

// Numbers an object for as long as its document lives; files and reports count from 0 in their order.
enum class ObjectId : std::uint32_t {};

class Scene {
public:
    using Objects = std::map<ObjectId, SharedObject>;

    [[nodiscard]] const Objects& objects() const { return objects_; }
    [[nodiscard]] SharedObject find(ObjectId id) const;  // null where there is none

    // Puts the object under the next free id.
    ObjectId add(SceneObject object);

    // Puts the object in the place of `id`; null removes it. Returns what stood there before (null: nothing
    // did).
    SharedObject exchange(ObjectId id, SharedObject object);

    // The name of the length unit that coordinates are in ("mm", "m", "in", ...); it scales nothing by
    // itself.
    [[nodiscard]] const std::string& units() const { return units_; }
    void setUnits(std::string units) { units_ = std::move(units); }

    [[nodiscard]] Box bounds() const;  // of the visible objects
    [[nodiscard]] std::vector<Vec3> controlPoints() const;  // of the visible objects, in model space
    [[nodiscard]] size_t ksQuadCount() const;
    [[nodiscard]] size_t controlPointCount() const;

    // Same ids and objects equal in value.
    [[nodiscard]] bool operator==(const Scene& other) const;

private:
    Objects objects_;
    std::string units_ = "mm";
    std::uint32_t nextId_ = 0;
};

}  // namespace knotspan
