// Objects that are to join a scene: under ids and names that it does not have.
#pragma once

#include <set>

#include <QString>

#include "model/scene/edit.h"

namespace knotspan {

class SceneAdditions {
public:
    explicit SceneAdditions(const Scene& scene) : numbered_(scene) {}

    void add(SceneObject object);
    // Under the first of "Sphere 1", "Sphere 2", ... that is free, which is returned.
    std::string addNamed(const QString& kind, NurbsSurface surface);
    // Under a name of its own: "Bow 2" where there is a "Bow".
    void addCopy(const SceneObject& object);

    [[nodiscard]] const Edit& edit() const { return edit_; }
    [[nodiscard]] const std::set<ObjectId>& ids() const { return ids_; }
    [[nodiscard]] int controlPointCount() const;

private:
    Scene numbered_;  // hands out ids, and knows the names
    Edit edit_;
    std::set<ObjectId> ids_;
};

}  // namespace knotspan
