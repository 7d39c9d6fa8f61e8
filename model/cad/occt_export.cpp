#include "model/cad/occt_export.h"

#include <algorithm>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "model/cad/occt_export_wires.h"
#include "model/cad/occt_spline.h"
#include "model/files/length_units.h"

namespace knotspan::occt {
namespace {

Result<TopoDS_Face> faceOf(const SceneObject& object, double scale)
{
    const auto spline = splineOf(object, scale);
    if (!spline)
        return tl::unexpected(spline.error());
    if (object.trimLoops.empty())
        return BRepBuilderAPI_MakeFace(*spline, Precision::Confusion()).Face();  // all of it
    TopoDS_Face face;
    BRep_Builder().MakeFace(face, *spline, Precision::Confusion());
    const std::vector<TrimLoop> loops =
        withBorder(object.trimLoops, object.surface.knotsU(), object.surface.knotsV());
    if (auto added = addWires(face, loops, object.bounds().diagonal() * scale); !added)
        return tl::unexpected(added.error().at('"' + object.name + '"'));
    return face;
}

double edgeToleranceOf(const TopoDS_Face& face)
{
    double tolerance = Precision::Confusion();
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
        tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
    return tolerance;
}

}  // namespace

Result<ExportedScene> exported(const Scene& scene)
{
    if (scene.objects().empty())
        return failure("There is nothing to write: the model has no surfaces", "Add a surface first");
    const double known = formats::millimetresIn(scene.units());
    const double scale = known > 0 ? known : 1;
    ExportedScene result;
    BRep_Builder builder;
    builder.MakeCompound(result.compound);
    for (const auto& [unused, object] : scene.objects()) {
        std::string name = object->name;
        if (name.empty())
            name = "Face " + std::to_string(result.faces.size() + 1);
        auto face = faceOf(*object, scale);
        if (!face)
            return tl::unexpected(face.error());
        builder.Add(result.compound, *face);
        result.tolerance = std::max(result.tolerance, edgeToleranceOf(*face));
        result.faces.push_back({*face, name, object->colour, object->bounds().diagonal() * scale});
    }
    return result;
}

}  // namespace knotspan::occt
