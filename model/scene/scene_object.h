// One object of a scene: a surface and how it stands in the model. Immutable once it is in a Scene.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/geometry/nurbs_surface.h"
#include "model/geometry/trim_loop.h"
#include "model/scene/sides.h"

namespace knotspan {

// sRGB, each part 0 to 1.
struct Colour {
    double red = 0.72;
    double green = 0.74;
    double blue = 0.78;

    [[nodiscard]] bool operator==(const Colour&) const = default;
};

struct SceneObject {
    std::string name;  // UTF-8, may be empty
    Colour colour;
    Mat4 transform{1.0};  // object to model space, affine and invertible
    bool visible = true;
    NurbsSurface surface;
    std::vector<TrimLoop> trimLoops;
    Sides sides = Sides::automatic;
    bool locked = false;  // shown, but no hand takes or changes it

    [[nodiscard]] bool operator==(const SceneObject&) const = default;

    // The box around the transformed control points, in model space.
    [[nodiscard]] Box bounds() const { return transformed(surface.bounds(), transform); }
};

using SharedObject = std::shared_ptr<const SceneObject>;

}  // namespace knotspan
