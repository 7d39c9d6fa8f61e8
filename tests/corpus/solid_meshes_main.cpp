// Of one file: how many closed shells OpenCASCADE finds in it, and whether our mesh of each is closed and
// within the deviation, a thousandth of its size or the given share of it. One line of JSON; the rest is for
// the program that asks (solid_meshes.h).
#include <iostream>

#include <nlohmann/json.hpp>

#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include "model/cad/occt_reading.h"
#include "model/mesh/deviation_measuring.h"
#include "model/mesh/tessellation.h"

namespace knotspan {
namespace {

TopoDS_Shape shapeIn(const std::string& path)
{
    const auto endsIn = [&](const std::string& end) {
        std::string last = path.size() >= end.size() ? path.substr(path.size() - end.size()) : std::string();
        for (char& c : last)
            c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return last == end;
    };
    if (endsIn(".brep") || endsIn(".brp")) {
        TopoDS_Shape shape;
        BRepTools::Read(shape, path.c_str(), BRep_Builder());
        return shape;
    }
    const auto transferred = [&](auto&& reader) {
        if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
            return TopoDS_Shape();
        reader.TransferRoots();
        return reader.OneShape();
    };
    return endsIn(".igs") || endsIn(".iges") ? transferred(IGESControl_Reader())
                                             : transferred(STEPControl_Reader());
}

nlohmann::json lookedAt(const TopoDS_Shape& shell, double share)
{
    const auto read = formats::withOpenCascade([&] {
        return formats::importOf({"shell", shell, nullptr, nullptr, {}, false}, {});
    });
    if (!read)
        return {{"problem", read.error().what}};
    const Scene& scene = read->scene;
    nlohmann::json result{{"faces", scene.objects().size()}};
    Box box;
    for (const auto& [id, object] : scene.objects())
        box.add(object->bounds());
    const double deviation = share * box.diagonal();
    const auto mesh = tessellate(scene, {.deviation = deviation});
    if (!mesh) {
        result["problem"] = mesh.error().what;
        return result;
    }
    const MeshTopology topology = topologyOf(mesh->mesh);
    const double measured = measuredDeviation(*mesh, scene, false, Threads::one).largest;
    result["triangles"] = mesh->mesh.triangles.size();
    result["boundary"] = topology.boundaryEdges;
    result["manifold"] = topology.isClosedManifold();
    result["bound"] = mesh->bound / deviation;
    result["measured"] = measured / deviation;
    result["volume"] = volumeOf(mesh->mesh);
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shell, properties);
    result["volume_by_opencascade"] = std::abs(properties.Mass());
    if (topology.boundaryEdges > 0 || mesh->bound > deviation || measured > mesh->bound + 1e-9 * deviation) {
        std::string notes;
        for (const std::string& note : read->notes)
            notes += note + " ";
        for (const std::string& note : mesh->notes)
            notes += note + " ";
        result["notes"] = notes;
    }
    return result;
}

nlohmann::json shellsIn(const TopoDS_Shape& shape, double share)
{
    nlohmann::json shells = nlohmann::json::array();
    TopTools_MapOfShape seen;
    for (TopExp_Explorer it(shape, TopAbs_SHELL); it.More(); it.Next()) {
        // Wherever it stands: an assembly has one of its parts many times.
        const TopoDS_Shape shell = it.Current().Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
        if (seen.Add(shell) && BRep_Tool::IsClosed(shell))
            shells.push_back(lookedAt(shell, share));
    }
    return shells;
}

}  // namespace
}  // namespace knotspan

int main(int argc, char** argv)
{
    Message::DefaultMessenger()->ChangePrinters().Clear();
    nlohmann::json result;
    try {
        const TopoDS_Shape shape = argc >= 2 ? knotspan::shapeIn(argv[1]) : TopoDS_Shape();
        result["shells"] = shape.IsNull() ? nlohmann::json::array()
                                          : knotspan::shellsIn(shape, argc == 3 ? std::atof(argv[2]) : 1e-3);
    } catch (const Standard_Failure& e) {
        result["error"] = e.GetMessageString();
    } catch (const std::exception& e) {
        result["error"] = e.what();
    }
    std::cout << result.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) << std::endl;
    return 0;
}
