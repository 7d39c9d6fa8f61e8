// Faces with long boundaries, brought through OpenCASCADE's STEP writer in chunks: it asks at each edge for
// the extent of the face around it, which takes minutes for 10,000 edges.
#pragma once

#include <vector>

#include <STEPControl_Writer.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>

#include "model/core/result.h"

namespace knotspan::formats {

// A shell of the face, or of faces on its surface that have some of its edges each and share corners.
[[nodiscard]] TopoDS_Shell inChunks(const TopoDS_Face& face);

// Makes one face of those that the writer has made of each chunk, in the model that it wrote; `shells` and
// `faces` belong together one by one. Fails where an edge was left out.
[[nodiscard]] Result<void> joinChunks(STEPControl_Writer& writer,
                                      const std::vector<Handle(StepShape_ConnectedFaceSet)>& shells,
                                      const std::vector<TopoDS_Face>& faces);

}  // namespace knotspan::formats
