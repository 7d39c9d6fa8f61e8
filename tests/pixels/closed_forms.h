// Surfaces whose points, normals and curvatures are known in closed form, as a ray meets them: what pictures
// that judge surfaces are held against.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/analysis/curvature.h"
#include "model/scene/scene.h"
#include "renderer/frame.h"

namespace knotspan::testing {

struct ClosedPoint {
    Vec3 position{};
    Vec3 normal{};  // unit, as S_u x S_v
    Curvature curvature;
};

struct ClosedForm {
    std::string name;
    Scene scene;  // one object
    // f = 0 on the surface, its gradient, and the principal curvatures by the gradient's direction.
    std::function<double(const Vec3&)> f;
    std::function<Vec3(const Vec3&)> gradient;
    std::function<std::pair<double, double>(const Vec3&)> bends;
    std::function<bool(const Vec3&)> isThere;  // of points with f = 0
    double side = 1;                           // -1: S_u x S_v runs against the gradient
};

// A sphere with its two poles, a torus, a cylinder without lids and a saddle z = x y / 2; one of them is
// placed.
[[nodiscard]] std::vector<ClosedForm> closedForms();

// The eye's ray through a pixel's centre.
struct Ray {
    Vec3 from{};
    Vec3 along{};  // unit
};
[[nodiscard]] Ray rayThrough(const Frame& frame, double x, double y);

// Where the ray meets it first; nothing: nowhere.
[[nodiscard]] std::optional<ClosedPoint> firstMet(const ClosedForm& form, const Ray& ray);

}  // namespace knotspan::testing
