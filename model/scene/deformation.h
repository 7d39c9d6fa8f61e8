// What `--deform` does to a model between two frames: the same work as a drag, without the hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace knotspan {

enum class Deformation { none, point, all };

[[nodiscard]] const std::vector<std::string>& deformationNames();
[[nodiscard]] std::optional<Deformation> findDeformation(const std::string& name);

// How `all` moves a control point at `place` of the model along z: by
// amplitude (sin(phase + time) - sin(phase)), phase = phasePerUnit (place.x + place.y) - phaseAtZero.
struct Wave {
    double amplitude = 0;
    double phasePerUnit = 0;
    double phaseAtZero = 0;
    double time = 0;

    [[nodiscard]] bool operator==(const Wave&) const = default;

    [[nodiscard]] double distanceAt(const Vec3& place) const;
};
// Nothing where the model is at rest.
[[nodiscard]] std::optional<Wave> waveAt(const Scene& rest, Deformation deformation, int frame);

// `rest` at the given frame: control points moved along z by a wave of 1 % of the model's size; frame 0 is
// the model at rest. `point` moves one control point in the middle of the first visible object; `all` moves
// every one, those at one place alike, so that what was joined stays joined.
[[nodiscard]] Scene deformed(const Scene& rest, Deformation deformation, int frame);

// Whether what lies along what may have changed since the scene before, or is known not to have.
enum class Joins { anew, kept };

// The same, with the wave left to the device where it can move control points by itself.
struct DeformedScene {
    Scene scene;
    std::optional<Wave> wave;
    Joins joins = Joins::anew;
};
[[nodiscard]] DeformedScene deformedFor(bool wavesOnDevice, const Scene& rest, Deformation deformation,
                                        int frame);

}  // namespace knotspan
