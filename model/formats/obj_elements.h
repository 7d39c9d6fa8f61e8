// The free-form curves and surfaces of an OBJ file: what their statements say, and the surface or curve that
// this is, exactly.
#pragma once

#include <cstdint>

#include "model/geometry/nurbs_surface.h"
#include "model/geometry/trim_loop.h"

namespace knotspan::formats {

// `cstype` and `deg`, which hold until they are stated again.
struct ObjBasis {
    bool rational = false;  // else weights are ignored
    bool bezier = false;    // else B-spline
    int degreeU = 0;
    int degreeV = 0;
};

// A part of a trimming curve in a loop; the end may be below the start: the part is run backwards.
struct ObjTrim {
    double start = 0;
    double end = 1;
    size_t curve = 0;  // counted from 0
};

struct ObjLoop {
    bool outer = true;
    std::vector<ObjTrim> trims;
};

// What stands between `surf` or `curv2` and `end`.
struct ObjElement {
    int line = 0;
    ObjBasis basis;
    double startU = 0, endU = 1, startV = 0, endV = 1;  // of surfaces
    std::vector<std::uint32_t> points;                  // counted from 0; u runs fastest
    std::vector<double> parametersU;                    // knots, or where Bezier pieces meet
    std::vector<double> parametersV;
    std::vector<ObjLoop> loops;
};

// The surface over the range that the element states, which is cut out where it is smaller than the knots'.
// Several Bezier pieces become one surface. Refuses, with a sentence, what is no surface.
[[nodiscard]] Result<NurbsSurface> surfaceOf(const ObjElement& element,
                                             const std::vector<ControlPoint>& vertices);

[[nodiscard]] Result<TrimCurve> trimCurveOf(const ObjElement& element,
                                            const std::vector<TrimPoint>& parameterPoints);

// The loops in which the surface lies to the left of every curve, whichever way the file runs them. Where
// there is a hole but no outer loop, that is the surface's own border. Refuses curves that were refused, and
// parts that a curve does not have.
[[nodiscard]] Result<std::vector<TrimLoop>> trimLoopsOf(const std::vector<ObjLoop>& loops,
                                                        const std::vector<Result<TrimCurve>>& curves,
                                                        const NurbsSurface& surface);

}  // namespace knotspan::formats
