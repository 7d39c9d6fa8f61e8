// Surfaces that run along each other in all the ways that borders can, and the same surface told otherwise.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "model/analysis/border_curves.h"
#include "model/scene/scene.h"

namespace knotspan::testing {

// The same points with u run the other way, with u and v exchanged, and of one degree more along u.
[[nodiscard]] NurbsSurface reversedU(const NurbsSurface& surface);
[[nodiscard]] NurbsSurface exchanged(const NurbsSurface& surface);
[[nodiscard]] NurbsSurface elevatedU(const NurbsSurface& surface);

// A rational surface of 3 x 2 KSQuads over [0, 3] x [0, 2] whose border v = 2 curves in space.
[[nodiscard]] NurbsSurface curvedSheet();
// What lies on the other side of that border: from `start` to `end` of it, u along it, border v = 0 on it.
[[nodiscard]] NurbsSurface neighbourOf(const NurbsSurface& sheet, double start, double end, const Vec3& away);

struct Joined {
    std::string name;
    std::vector<NurbsSurface> surfaces;
};
// T-joints, three along one edge, partial overlaps, knots inserted, degrees, directions.
[[nodiscard]] std::vector<Joined> joinedSurfaces();
// Three rows of surfaces along one curve, cut at random, some told otherwise.
[[nodiscard]] Joined randomRows(std::mt19937& random);

// A torus cut into surfaces that meet in T-joints, some of them told with another degree or direction.
[[nodiscard]] Scene torusWithTJoints();

[[nodiscard]] std::vector<PlacedSurface> placed(const std::vector<NurbsSurface>& surfaces);
[[nodiscard]] std::vector<PlacedSurface> placed(const Scene& scene);

}  // namespace knotspan::testing
