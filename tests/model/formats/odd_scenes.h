// Scenes with what exchange formats find hard, each under a name.
#pragma once

#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace knotspan::testing {

struct OddScene {
    std::string name;
    Scene scene;
};

// Degrees 1 to 15, knots of full multiplicity, unclamped, uneven, far from zero; weights over six orders;
// closed surfaces, poles; objects far away, large, small, thin; transforms, hidden objects.
[[nodiscard]] std::vector<OddScene> oddSurfaces();

// Faces with loops: of lines, arcs, splines; along sides, over poles and seams, with holes.
[[nodiscard]] std::vector<OddScene> trimmedScenes();

// A wavy surface with random weights from 10^-orders to 10^orders, the same for the same arguments.
[[nodiscard]] NurbsSurface wavySurface(const KnotVector& u, const KnotVector& v, double orders,
                                       const Vec3& at = Vec3(0.0), double size = 10);
[[nodiscard]] Scene sceneOf(const NurbsSurface& surface);

}  // namespace knotspan::testing
