#include "model/cad/iges_writing.h"

#include <map>
#include <tuple>

#include <BRepToIGES_BREntity.hxx>
#include <IGESBasic_Name.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESGraph_Color.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSAlgo.hxx>
#include <XSAlgo_AlgoContainer.hxx>

#include "model/cad/iges_faces.h"
#include "model/cad/occt_writing.h"
#include "model/files/text_file.h"

namespace knotspan::formats {
namespace {

Handle(TCollection_HAsciiString) text(const std::string& bytes)
{
    return new TCollection_HAsciiString(bytes.c_str());
}

// A colour is written once, however many faces have it.
class Colours {
public:
    [[nodiscard]] const Handle(IGESGraph_Color) & of(const Colour& colour)
    {
        auto& entity = entities_[{colour.red, colour.green, colour.blue}];
        if (entity.IsNull()) {
            entity = new IGESGraph_Color;
            entity->Init(colour.red * 100, colour.green * 100, colour.blue * 100, {});  // percent
        }
        return entity;
    }

private:
    std::map<std::tuple<double, double, double>, Handle(IGESGraph_Color)> entities_;
};

void fillHeader(const Handle(IGESData_IGESModel) & model, double tolerance)
{
    IGESData_GlobalSection header = model->GlobalSection();
    header.SetSendName(text("Knotspan model"));
    header.SetFileName(text(""));
    header.SetSystemId(text(kOurIgesSystem));
    header.SetInterfaceVersion(text("Knotspan"));
    header.SetReceiveName(text(""));
    header.SetDate(text(""));
    header.SetLastChangeDate(text(""));
    header.SetAuthorName(text(""));
    header.SetCompanyName(text(""));
    header.SetResolution(tolerance / header.UnitValue());
    model->SetGlobalSection(header);
}

Result<void> add(const occt::ExportedFace& face, IGESControl_Writer& writer, BRepToIGES_BREntity& maker,
                 Colours& colours)
{
    const Handle(IGESData_IGESEntity) entity = igesFace(face.face, maker);
    if (entity.IsNull())
        return failure("OpenCASCADE could not write \"" + face.name + "\" as IGES",
                       "Save the model as .knotspan instead");
    entity->InitColor(colours.of(face.colour));
    const Handle(IGESBasic_Name) name = new IGESBasic_Name;
    name->Init(1, text(nameIn(face.name)));
    entity->AddProperty(name);
    writer.AddEntity(entity);
    return {};
}

Result<void> writeAll(const occt::ExportedScene& scene, const std::string& unit,
                      const std::filesystem::path& path)
{
    if (auto large = requireExtent(scene, "IGES"); !large)
        return large;
    IGESControl_Writer writer(openCascadeUnit(unit, "IN").c_str(), 0);
    XSAlgo::AlgoContainer()->PrepareForTransfer();
    BRepToIGES_BREntity maker;
    maker.SetTransferProcess(writer.TransferProcess());
    maker.SetModel(writer.Model());
    Colours colours;
    for (const occt::ExportedFace& face : scene.faces)
        if (auto added = add(face, writer, maker, colours); !added)
            return added;
    writer.ComputeModel();
    fillHeader(writer.Model(), scene.tolerance);
    IGESData_IGESWriter lines(writer.Model());
    lines.FloatWriter().SetFormat(kAllDigits);
    lines.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
    return printTo(path, [&](std::ostream& out) { (void)lines.Print(out); });
}

}  // namespace

Result<void> writeIges(const Scene& scene, const std::filesystem::path& path)
{
    return writeFaces(scene,
                      [&](const occt::ExportedScene& faces) { return writeAll(faces, scene.units(), path); });
}

}  // namespace knotspan::formats
