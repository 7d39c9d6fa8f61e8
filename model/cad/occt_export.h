// What the writers of STEP, IGES and BREP share: the objects of a scene as OpenCASCADE's faces.
#pragma once

#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>

#include "model/scene/scene.h"

namespace knotspan::occt {

struct ExportedFace {
    TopoDS_Face face;
    std::string name;  // UTF-8, never empty
    Colour colour;
    double size = 0;  // the diagonal of the box around its control points
};

struct ExportedScene {
    std::vector<ExportedFace> faces;  // in the order of the scene, hidden ones too
    TopoDS_Compound compound;         // of all faces
    double tolerance = 0;             // how exactly edges lie on faces, at worst
};

// Every object as a face of its own, in model space, lengths in millimetres (the scene's, where its unit is
// none we know). Fails with a sentence that names the object.
[[nodiscard]] Result<ExportedScene> exported(const Scene& scene);

}  // namespace knotspan::occt
