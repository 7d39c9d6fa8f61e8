// Points, directions, boxes and transforms of the model: always double; float begins at the GPU's border.
#pragma once

#include <limits>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace knotspan {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat4 = glm::dmat4;  // column-major, applied to column vectors

// An axis-aligned box; empty until a point is added.
struct Box {
    Vec3 low{std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool isEmpty() const { return !(low.x <= high.x); }
    [[nodiscard]] Vec3 centre() const { return low + (high - low) * 0.5; }
    [[nodiscard]] Vec3 size() const { return high - low; }
    [[nodiscard]] double diagonal() const;  // 0 for an empty box

    void add(const Vec3& point);
    void add(const Box& box);
};

// The smallest box around the transformed corners of `box`.
[[nodiscard]] Box transformed(const Box& box, const Mat4& transform);

// The point `transform` takes `point` to. The transform is affine.
[[nodiscard]] Vec3 transformed(const Vec3& point, const Mat4& transform);

}  // namespace knotspan
