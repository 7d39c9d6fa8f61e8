#include "model/cad/step_writing.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_Representation.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>

#include "model/cad/occt_writing.h"
#include "model/cad/step_chunks.h"
#include "model/cad/step_styles.h"
#include "model/cad/step_texts.h"

namespace knotspan::formats {
namespace {

using Model = Handle(StepData_StepModel);

Handle(TCollection_HAsciiString) ascii(const std::string& text)
{
    return new TCollection_HAsciiString(text.c_str());
}

// The shells as the writer made them, one a face, in order.
struct WrittenShells {
    std::vector<Handle(StepShape_ShellBasedSurfaceModel)> shells;
    Handle(StepRepr_RepresentationContext) context;
};

WrittenShells shellsIn(const Model& model)
{
    WrittenShells written;
    for (int k = 1; k <= model->NbEntities(); ++k) {
        const auto representation = Handle(StepRepr_Representation)::DownCast(model->Value(k));
        if (representation.IsNull() || representation->Items().IsNull())
            continue;
        for (int item = 1; item <= representation->NbItems(); ++item) {
            const auto shell =
                Handle(StepShape_ShellBasedSurfaceModel)::DownCast(representation->ItemsValue(item));
            if (shell.IsNull())
                continue;
            written.shells.push_back(shell);
            written.context = representation->ContextOfItems();
        }
    }
    return written;
}

Handle(StepShape_ConnectedFaceSet) shellOf(const Handle(StepShape_ShellBasedSurfaceModel) & model)
{
    return Handle(StepShape_ConnectedFaceSet)::DownCast(model->SbsmBoundaryValue(1).Value());
}

Handle(StepShape_Face) faceOf(const Handle(StepShape_ShellBasedSurfaceModel) & model)
{
    const auto shell = shellOf(model);
    return shell.IsNull() || shell->NbCfsFaces() < 1 ? Handle(StepShape_Face)() : shell->CfsFacesValue(1);
}

Result<void> join(STEPControl_Writer& writer, const WrittenShells& written,
                  const std::vector<occt::ExportedFace>& faces)
{
    std::vector<Handle(StepShape_ConnectedFaceSet)> shells;
    std::vector<TopoDS_Face> originals;
    for (size_t k = 0; k < faces.size(); ++k) {
        shells.push_back(shellOf(written.shells[k]));
        originals.push_back(faces[k].face);
        if (shells.back().IsNull() || shells.back()->NbCfsFaces() < 1)
            return failure("OpenCASCADE could not write \"" + faces[k].name + "\" as STEP",
                           "Save the model as .knotspan instead");
    }
    return joinChunks(writer, shells, originals);
}

// Fails where the writer has left a face out.
Result<void> label(STEPControl_Writer& writer, const std::vector<occt::ExportedFace>& faces, StepTexts& texts)
{
    const Model model = writer.Model();
    const WrittenShells written = shellsIn(model);
    if (written.shells.size() != faces.size())
        return failure("OpenCASCADE left out " + std::to_string(faces.size() - written.shells.size()) +
                           " of " + std::to_string(faces.size()) + " surfaces",
                       "Save the model as .knotspan instead");
    if (auto joined = join(writer, written, faces); !joined)
        return joined;
    StepColours colours(writer.WS());
    for (size_t k = 0; k < faces.size(); ++k) {
        const Handle(StepShape_Face) face = faceOf(written.shells[k]);
        if (face.IsNull())
            return failure("OpenCASCADE could not write \"" + faces[k].name + "\" as STEP",
                           "Save the model as .knotspan instead");
        const auto name = ascii(texts.standInFor(faces[k].name));
        face->SetName(name);
        written.shells[k]->SetName(name);
        colours.add(face, faces[k].colour);
    }
    model->AddWithRefs(colours.representation(written.context));
    return {};
}

void nameProduct(const Model& model, const std::string& name)
{
    for (int k = 1; k <= model->NbEntities(); ++k) {
        const auto product = Handle(StepBasic_Product)::DownCast(model->Value(k));
        if (!product.IsNull()) {
            product->SetId(ascii(name));
            product->SetName(ascii(name));
        }
    }
}

void fillHeader(const Model& model)
{
    APIHeaderSection_MakeHeader header(model);
    header.SetDescriptionValue(1, ascii("NURBS surfaces"));
    header.SetName(ascii(kOurStepProduct));
    header.SetTimeStamp(ascii(""));
    header.SetAuthorValue(1, ascii(""));
    header.SetOrganizationValue(1, ascii(""));
    header.SetOriginatingSystem(ascii(kOurStepSystem));
    header.SetAuthorisation(ascii(""));
}

Result<void> print(const Model& model, const StepTexts& texts, const Handle(XSControl_WorkSession) & session,
                   const std::filesystem::path& path)
{
    StepData_StepWriter writer(model);
    writer.FloatWriter().SetFormat(kAllDigits);
    writer.SendModel(Handle(StepData_Protocol)::DownCast(session->Protocol()));
    return printTo(path, [&](std::ostream& out) {
        for (int k = 1; k <= writer.NbLines() && out; ++k)
            out << texts.replacedIn(writer.Line(k)->ToCString()) << '\n';
    });
}

TopoDS_Compound chunked(const occt::ExportedScene& scene)
{
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const occt::ExportedFace& face : scene.faces)
        builder.Add(compound, inChunks(face.face));
    return compound;
}

Result<void> writeAll(const occt::ExportedScene& scene, const std::string& unit,
                      const std::filesystem::path& path)
{
    if (auto large = requireExtent(scene, "STEP"); !large)
        return large;
    STEPControl_Controller::Init();  // which defines the parameters that the writer takes as it is made
    Interface_Static::SetCVal("write.step.unit", openCascadeUnit(unit, "INCH").c_str());
    Interface_Static::SetIVal("write.step.assembly", 0);
    Interface_Static::SetIVal("write.step.nonmanifold", 0);
    Interface_Static::SetIVal("write.surfacecurve.mode", 1);
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    STEPControl_Writer writer;
    writer.SetTolerance(scene.tolerance);
    const IFSelect_ReturnStatus status = writer.Transfer(chunked(scene), STEPControl_ShellBasedSurfaceModel);
    if (status != IFSelect_RetDone)
        return failure("OpenCASCADE could not turn the model into STEP", "Save it as .knotspan instead");
    const Model model = writer.Model();
    StepTexts texts;
    if (auto labelled = label(writer, scene.faces, texts); !labelled)
        return labelled;
    nameProduct(model, scene.faces.size() == 1 ? texts.standInFor(scene.faces[0].name) : kOurStepProduct);
    fillHeader(model);
    return print(model, texts, writer.WS(), path);
}

}  // namespace

Result<void> writeStep(const Scene& scene, const std::filesystem::path& path)
{
    return writeFaces(scene,
                      [&](const occt::ExportedScene& faces) { return writeAll(faces, scene.units(), path); });
}

}  // namespace knotspan::formats
