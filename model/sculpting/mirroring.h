// Live symmetry: who follows as the mirror image of whom.
#pragma once

#include <map>

#include <glm/mat3x3.hpp>

#include "model/sculpting/falloff.h"

namespace knotspan {

using Mat3 = glm::dmat3;

// Through `point`, in model space; `normal` of any length but 0.
struct SymmetryPlane {
    Vec3 point{0, 0, 0};
    Vec3 normal{1, 0, 0};

    [[nodiscard]] bool operator==(const SymmetryPlane&) const = default;
};

[[nodiscard]] Vec3 mirrored(const Vec3& place, const SymmetryPlane& plane);
// What takes a direction to its mirror image. Exact for planes x, y or z = c.
[[nodiscard]] Mat3 reflectionIn(const SymmetryPlane& plane);

enum class SymmetryKind {
    none,
    plane,  // partners stand at each other's mirror images
    u,      // (i, j) and (countU - 1 - i, j) of one net, wherever they stand
    v,      // (i, j) and (i, countV - 1 - j)
};

struct Symmetry {
    SymmetryKind kind = SymmetryKind::none;
    SymmetryPlane plane;
    // How far a partner may stand from the mirror image, in model units; 0: a millionth of the objects' size.
    double tolerance = 0;

    [[nodiscard]] bool operator==(const Symmetry&) const = default;
};

// A control point that goes along as another one's image: what that one moves by is multiplied by `image`.
struct MirrorFollower {
    ControlPointIndex index;
    Follower of;
    ObjectId ofObject{};
    Mat3 image{1.0};
};

struct MirrorFollowers {
    std::map<ObjectId, std::vector<MirrorFollower>> objects;  // in the order of comesBefore()
    size_t withoutPartner = 0;                                // followers that have no image
};

// The images of `followers`, in their objects and, by plane, in `others`. Of several that a point could be
// the image of it follows the one with the largest share. By u or v the image keeps what a movement has
// along v (or u) and along the surface's normal there, and turns what it has along u (or v).
[[nodiscard]] MirrorFollowers mirrorFollowersOf(const Scene& scene, const Followers& followers,
                                                const Symmetry& symmetry,
                                                const std::set<ObjectId>& others = {});

}  // namespace knotspan
