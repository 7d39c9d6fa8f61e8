// Which side of each surface is shown: what its object was told (model/scene/sides.h); else, of a closed body
// that the camera looks at from outside only the outside, and of all others both.
#pragma once

#include "model/analysis/shells.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/held_residents.h"

namespace knotspan {

// In two parts, so that a body that is torn open and closed again changes one number of the device's.
struct SideTables {
    std::vector<float> sides;           // by surface, as gpu::SurfaceView has them; the last ones known
    std::vector<std::uint32_t> shells;  // by surface: the number of its shell's first one
    std::vector<std::uint32_t> shown;   // by that number: 1 where only the outside is shown

    // As shownSide() of scene.glsl.
    [[nodiscard]] float shownSide(size_t surface) const
    {
        return sides[surface] * static_cast<float>(shown[shells[surface]]);
    }
    [[nodiscard]] bool anyShownAlone() const;
};

class ShownSides {
public:
    // By resident. `edges` are those of the residents; `bounds` sets the depth range, as in
    // Camera::projection().
    [[nodiscard]] const SideTables& of(const std::vector<Resident>& residents, const CoincidentEdges& edges,
                                       const Camera& camera, double aspect, const Box& bounds);
    // Both sides of all that were not told otherwise.
    [[nodiscard]] static SideTables asTold(const std::vector<Resident>& residents);

private:
    // Whether something is another object than before.
    bool follow(const std::vector<Resident>& residents, const CoincidentEdges& edges);

    Shells shells_;
    HeldResidents held_;
    std::optional<Camera> camera_;  // that the tables are of
    double cutOff_ = 0;
    SideTables tables_;
};

}  // namespace knotspan
