// Objects from objects: mirrored, duplicated, moved by numbers. Only the transform changes, never the
// surface, so that nothing of the shape is rounded and trim loops stay right.
//
// A transform may mirror (determinant below zero). Then, as everywhere in Knotspan, the front of an object is
// the mirror image of its front: Sides::front, and outwards of a closed body, stay what they are seen from
// the object's own coordinates, though S_u x S_v of the points in model space turns over.
#pragma once

#include "model/geometry/nurbs_curve.h"
#include "model/scene/scene.h"

namespace knotspan {

struct MirrorPlane {
    Vec3 point{0};
    Vec3 normal{1, 0, 0};  // of any length
};
// Mirrored in the plane (model space); the name is kept. In a coordinate plane through the origin
// exact, and undone by doing it again to the bit. Refuses, with a sentence, a plane that is not finite or a
// normal of no length.
[[nodiscard]] Result<SceneObject> mirrored(const SceneObject& object, const MirrorPlane& plane);

// x -> pivot + translation + R S (x - pivot) in model space: first scaled along the axes of the model, then
// turned about x, then about y, then about z (degrees, by the right hand), then moved.
struct TransformNumbers {
    Vec3 translation{0};
    Vec3 degrees{0};
    Vec3 scale{1};  // below zero mirrors; not 0
    Vec3 pivot{0};
};
// As a matrix. Quarter turns are exact, and so is what is only moved, whatever the pivot. Refuses, with a
// sentence, numbers that are not finite and a scale of 0.
[[nodiscard]] Result<Mat4> transformMatrix(const TransformNumbers& numbers);

// `matrix` (affine, model space) after the object's own transform. Refuses what a file could not hold: a
// transform that is not finite or flattens the object.
[[nodiscard]] Result<SceneObject> moved(const SceneObject& object, const Mat4& matrix);

// The same object under a name that `scene` does not have: "Bow" becomes "Bow 2", "Bow 2" becomes "Bow 3". An
// object without a name stays without.
[[nodiscard]] SceneObject duplicated(const SceneObject& object, const Scene& scene);

// The object's iso-curve (nurbs_curve.h), in model space.
[[nodiscard]] Result<NurbsCurve> isoCurveInModel(const SceneObject& object, Direction across,
                                                 double parameter);

}  // namespace knotspan
