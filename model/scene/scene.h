// A scene is a value: ids and the immutable objects behind them. Copying it takes a snapshot, for undo, for
// saving on another thread and for the renderer; an equal pointer is an unchanged object.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/mesh_object.h"
#include "model/scene/scene_object.h"

namespace knotspan {

// Numbers an object for as long as its document lives; files and reports count from 0 in their order.
enum class ObjectId : std::uint32_t {};

class Scene {
public:
    using Objects = std::map<ObjectId, SharedObject>;
    using Meshes = std::map<ObjectId, SharedMesh>;

    Scene() = default;
    Scene(const Scene&) = default;
    // Costs what the two differ by, where one came from the other by a few exchanges.
    Scene& operator=(const Scene& other);
    Scene(Scene&& other) noexcept;
    Scene& operator=(Scene&& other) noexcept;
    ~Scene() = default;

    [[nodiscard]] const Objects& objects() const { return objects_; }
    [[nodiscard]] SharedObject find(ObjectId id) const;  // null where there is none

    // Puts the object under the next free id.
    ObjectId add(SceneObject object);

    // Puts the object in the place of `id`; null removes it. Returns what stood there before (null: nothing
    // did).
    SharedObject exchange(ObjectId id, SharedObject object);

    // The meshes that are looked at and compared with. They have ids of their own among the objects'.
    [[nodiscard]] const Meshes& meshes() const { return meshes_; }
    ObjectId addMesh(MeshObject mesh);
    SharedMesh exchangeMesh(ObjectId id, SharedMesh mesh);  // as above

    // Where this scene came from `earlier` by few exchanges: the ids exchanged since, each at least once.
    // Nothing: nobody knows; compare all. Costs the same however many objects there are. Knows of surfaces
    // only.
    [[nodiscard]] std::optional<std::vector<ObjectId>> changedSince(const Scene& earlier) const;

    // The name of the length unit that coordinates are in ("mm", "m", "in", ...); it scales nothing by
    // itself.
    [[nodiscard]] const std::string& units() const { return units_; }
    void setUnits(std::string units) { units_ = std::move(units); }

    [[nodiscard]] Box bounds() const;                       // of the visible objects and meshes
    // All that is visible is inside their hull: control points, and the corners of the meshes' boxes.
    [[nodiscard]] std::vector<Vec3> hullPoints() const;
    [[nodiscard]] size_t ksQuadCount() const;
    [[nodiscard]] size_t controlPointCount() const;

    // Same ids; objects and meshes equal in value.
    [[nodiscard]] bool operator==(const Scene& other) const;

private:
    // An exchange: the scene before it had that version.
    struct Exchange {
        std::uint64_t before = 0;
        ObjectId id{};
    };

    Objects objects_;
    Meshes meshes_;
    std::uint64_t version_ = 0;          // scenes of one version have the same objects; 0: none
    std::array<Exchange, 32> latest_{};  // the last exchanges, oldest first from nextExchange_ on
    std::uint32_t nextExchange_ = 0;
    std::string units_ = "mm";
    std::uint32_t nextId_ = 0;
};

}  // namespace knotspan
