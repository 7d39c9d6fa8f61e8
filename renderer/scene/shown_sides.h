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
    std::uint64_t revision = 0;         // of ShownSides: another one with other tables; 0: nobody counts

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
    // Camera::projection(). `log`: of the residents; null: all are compared.
    [[nodiscard]] const SideTables& of(const std::vector<Resident>& residents, const CoincidentEdges& edges,
                                       const Camera& camera, double aspect, const Box& bounds,
                                       const ResidentChanges* log = nullptr);
    // Both sides of all that were not told otherwise.
    [[nodiscard]] static SideTables asTold(const std::vector<Resident>& residents);

private:
    // What the camera looks at from where, as far as it matters here.
    struct View {
        Camera camera;
        double cutOff = 0;

        [[nodiscard]] bool operator==(const View&) const = default;
    };
    // The shells of what is another object than before; nothing: all may be others.
    std::optional<std::vector<std::uint32_t>>
    follow(const std::vector<Resident>& residents, const CoincidentEdges& edges, const ResidentChanges* log);
    void makeTables(const std::vector<Resident>& residents);
    void showFrom(const View& view, std::uint32_t shell);

    Shells shells_;
    HeldResidents held_;
    std::optional<View> view_;  // that the tables are of
    std::uint64_t shellsSeen_ = 0;
    std::vector<Sides> told_;            // by surface
    std::vector<bool> open_;             // by shell: through trimmed surfaces one sees the inside
    std::vector<std::uint32_t> firsts_;  // by shell: its first surface that was told nothing, or none
    SideTables tables_;
};

}  // namespace knotspan
