// The residents as somebody looked at them last, and how they differ now.
#pragma once

#include "renderer/scene/packed_scene.h"
#include "renderer/scene/resident_changes.h"

namespace knotspan {

class HeldResidents {
public:
    struct Difference {
        bool anew = false;  // other surfaces, knots or trim loops: nothing of before holds
        std::vector<SurfaceChange> changes;

        [[nodiscard]] bool isEmpty() const { return !anew && changes.empty(); }
    };
    // Holds these from now on. Surfaces of changes are good while the residents are. `log`: of these
    // residents; null: all are compared.
    Difference take(const std::vector<Resident>& residents, const ResidentChanges* log = nullptr);

    [[nodiscard]] const SceneObject& operator[](size_t index) const { return *held_[index]; }

private:
    Difference takeLogged(const std::vector<Resident>& residents, std::span<const std::uint32_t> changed);

    std::vector<SharedObject> held_;
    ResidentChanges::Moment seen_ = 0;  // of the log
};

}  // namespace knotspan
