// From OpenCASCADE's faces to our surfaces, exactly wherever the type of the surface allows.
//
// Only model/formats includes this: OpenCASCADE's macros break other libraries' headers.
#pragma once

#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "model/geometry/nurbs_surface.h"

namespace knotspan::occt {

// Where a parameter of OpenCASCADE's surface lies on ours: its circles run by angle, ours by a rational
// function of it; and the u of a reversed face runs backwards.
struct ParameterMap {
    enum class Kind { shift, angle };
    Kind kind = Kind::shift;
    double start = 0;  // OpenCASCADE's parameters at the ends of our domain
    double end = 1;
    double ourStart = 0;  // our parameter at `start`; differs for shifted periodic knots
    int spans = 1;        // angle: arcs of equal length between start and end
    bool backwards = false;

    [[nodiscard]] double operator()(double theirs) const;
    [[nodiscard]] double derivative(double theirs) const;
};

struct ParameterRange {
    double startU, endU, startV, endV;
};

struct ConvertedSurface {
    NurbsSurface surface;
    ParameterMap u;
    ParameterMap v;
    Handle(Geom_Surface) original;  // whose parameters u and v take; for planes not always the face's own
    bool approximated = false;      // to the tolerance, instead of exactly
    double difference = 0;          // the largest distance measured between `surface` and `original`
    bool mapsHold = true;           // whether u and v really tell where a parameter went: checked by points
};

// The part of `surface` inside `range`. `tolerance` (a length) is used only for types that no B-spline equals
// (offset surfaces, for one). Fails with a sentence where our own surface refuses the result. May also throw
// Standard_Failure.
[[nodiscard]] Result<ConvertedSurface> toNurbs(const Handle(Geom_Surface) & surface,
                                               const ParameterRange& range, double tolerance);

// Whether a face's surface is bounded to the rectangle of (u, v) around its boundary (other programs trim
// faces out of surfaces that go far beyond them), or a B-spline surface is taken over as it is.
enum class Extent { face, whole };

// The same for a face: its location applied, and turned, where it is reversed, so that S_u x S_v points out
// of the solid.
[[nodiscard]] Result<ConvertedSurface> toNurbs(const TopoDS_Face& face, Extent extent);

}  // namespace knotspan::occt
