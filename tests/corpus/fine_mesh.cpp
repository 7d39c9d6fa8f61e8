#include "tests/corpus/fine_mesh.h"

#include <algorithm>

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IGESControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include "model/formats/format_list.h"

namespace knotspan::corpus {
namespace {

double diagonalOf(const TopoDS_Shape& shape)
{
    Bnd_Box box;
    BRepBndLib::Add(shape, box);
    return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

double slackOf(const TopoDS_Face& face)
{
    double slack = BRep_Tool::Tolerance(face);
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
        slack = std::max(slack, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
    return slack;
}

void take(const TopoDS_Face& face, FineMesh& mesh)
{
    const int number = mesh.faces++;
    mesh.slacks.push_back(slackOf(face));
    TopLoc_Location place;
    const Handle(Poly_Triangulation) made = BRep_Tool::Triangulation(face, place);
    if (made.IsNull() || made->NbTriangles() == 0) {
        mesh.unmeshed.push_back(number);
        return;
    }
    const auto corner = [&](int k) {
        const gp_Pnt point = made->Node(k).Transformed(place.Transformation());
        return Vec3(point.X(), point.Y(), point.Z());
    };
    for (int k = 1; k <= made->NbTriangles(); ++k) {
        int a = 0, b = 0, c = 0;
        made->Triangle(k).Get(a, b, c);
        mesh.triangles.push_back({{corner(a), corner(b), corner(c)}, number});
        for (const Vec3& point : mesh.triangles.back().corners)
            mesh.box.add(point);
    }
}

// Null where it cannot be read.
TopoDS_Shape transferred(XSControl_Reader&& reader, const std::filesystem::path& path)
{
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        return {};
    reader.TransferRoots();
    return reader.OneShape();
}

TopoDS_Shape shapeIn(const std::filesystem::path& path)
{
    const formats::Format* format = formats::find(path);
    if (format != nullptr && format->name == "STEP")
        return transferred(STEPControl_Reader(), path);
    if (format != nullptr && format->name == "IGES")
        return transferred(IGESControl_Reader(), path);
    TopoDS_Shape shape;
    BRepTools::Read(shape, path.c_str(), BRep_Builder());
    return shape;
}

Result<FineMesh> read(const std::filesystem::path& path, double fineness)
{
    const TopoDS_Shape shape = shapeIn(path);
    if (shape.IsNull())
        return failure("OpenCASCADE finds no shape");
    const BRepMesh_IncrementalMesh meshing(shape, fineness * diagonalOf(shape), Standard_False, 0.3);
    FineMesh mesh;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
        take(TopoDS::Face(it.Current()), mesh);
    if (mesh.triangles.empty())
        return failure("OpenCASCADE makes no triangles");
    return mesh;
}

}  // namespace

Result<FineMesh> fineMeshOf(const std::filesystem::path& path, double fineness)
{
    Message::DefaultMessenger()->ChangePrinters().Clear();
    try {
        return read(path, fineness);
    } catch (const Standard_Failure& e) {
        return failure(std::string("OpenCASCADE says: ") + e.GetMessageString());
    }
}

}  // namespace knotspan::corpus
