// Trimmed surfaces of which closed forms say where a ray meets them and what loops leave there.
#pragma once

#include "tests/pixels/closed_forms.h"

namespace knotspan::testing {

struct Disc {
    Vec2 centre{0};
    double radius = 0;

    [[nodiscard]] bool has(const Vec2& place) const;
};

constexpr Disc kRim{{2, 1.5}, 1.4};
constexpr Disc kHole{{2.25, 1.75}, 0.6};
[[nodiscard]] std::vector<TrimLoop> loopsOf(const Disc& rim, const Disc& hole);

// 8 x 6 KSQuads over [0, 4] x [0, 3] in the plane z = 0, whose parameters are coordinates.
[[nodiscard]] SceneObject platter(std::vector<TrimLoop> loops);
// Whether rim and hole leave a place.
[[nodiscard]] bool onPlatter(const Vec3& place);
// All places of the whole surface that a ray meets, nearest first.
[[nodiscard]] std::vector<Vec3> metOnPlane(const Ray& ray);

// A cylinder around z of radius 1 and height 2, of eight rational arcs, with a hole that is round in its
// parameters.
constexpr Disc kWindow{{6.4, 0.5}, 0.35};
[[nodiscard]] SceneObject pipe();
[[nodiscard]] bool onPipe(const Vec3& place);
[[nodiscard]] std::vector<Vec3> metOnPipe(const Ray& ray);

}  // namespace knotspan::testing
