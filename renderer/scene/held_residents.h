// The residents as somebody looked at them last, and how they differ now.
#pragma once

#include "renderer/scene/packed_scene.h"

namespace knotspan {

class HeldResidents {
public:
    struct Difference {
        bool anew = false;  // other surfaces, or other knots: nothing of before holds
        std::vector<SurfaceChange> changes;

        [[nodiscard]] bool isEmpty() const { return !anew && changes.empty(); }
    };
    // Holds these from now on. Surfaces of changes are good while the residents are.
    Difference take(const std::vector<Resident>& residents);

    [[nodiscard]] const SceneObject& operator[](size_t index) const { return *held_[index]; }

private:
    std::vector<SharedObject> held_;
};

}  // namespace knotspan
