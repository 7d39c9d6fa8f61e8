// How far two scenes are from being the same model: what a file lost that went out and came back.
//
// Objects are compared in order, placed (another transform of other control points that end in the same
// places is no difference) and in one unit of length. Formats that know no names or colours lose them; that
// is told apart from what must not happen.
#pragma once

#include <string>

#include "model/core/result.h"
#include "model/scene/scene.h"

namespace knotspan::formats {

struct SceneDifference {
    double controlPoints = 0;  // the largest gap, of the largest coordinate of that object
    double weights = 0;     // the largest change, of the weight; a factor common to all of a surface is none
    double knots = 0;       // the largest shift, of the largest knot of that surface and direction
    double trimCurves = 0;  // the same three of the curves that bound the faces, in (u, v)
    int names = 0;          // how many objects are called otherwise
    int colours = 0;        // how many have another colour, by more than 1e-3

    // Of all the model's numbers.
    [[nodiscard]] double largest() const;
};

// Compares `back` with what it should be. Fails with a sentence that names the object where one of the two
// has another number of objects, other degrees, other numbers of knots or control points, or other trim
// loops.
[[nodiscard]] Result<SceneDifference> differenceBetween(const Scene& scene, const Scene& back);

}  // namespace knotspan::formats
