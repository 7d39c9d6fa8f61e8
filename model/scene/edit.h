// An edit is a set of objects to swap into a scene. Applying it leaves it holding its own inverse, so
// applying it again undoes it, and once more redoes it.
#pragma once

#include "model/scene/scene.h"

namespace knotspan {

class Edit {
public:
    // `object` is to stand under `id`; null: nothing is. The last word for an id counts.
    void set(ObjectId id, SharedObject object);

    void setMesh(ObjectId id, SharedMesh mesh);
    // The name alone: nothing is scaled.
    void setUnits(std::string units) { units_ = std::move(units); }

    [[nodiscard]] bool isEmpty() const { return objects_.empty() && meshes_.empty() && !units_; }

    // Swaps what it holds with the scene's.
    void applyTo(Scene& scene);

    // Joins `later`, which was applied after this one (both hold their inverses), into one edit: this one
    // then undoes both.
    void absorb(const Edit& later);

private:
    std::map<ObjectId, SharedObject> objects_;
    std::map<ObjectId, SharedMesh> meshes_;
    std::optional<std::string> units_;
};

// What makes `to` of `from`: objects that are equal stay the very same.
[[nodiscard]] Edit editBetween(const Scene& from, const Scene& to);

}  // namespace knotspan
