#include "model/formats/step_labels.h"

#include <algorithm>
#include <vector>

#include <Quantity_Color.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <Standard_Failure.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace knotspan::formats {
namespace {

std::optional<Colour> colourOf(const Handle(StepVisual_Colour) & colour)
{
    const auto within = [](double part) { return part >= 0 && part <= 1; };
    Colour ours;
    if (const auto rgb = Handle(StepVisual_ColourRgb)::DownCast(colour); !rgb.IsNull()) {
        ours = {rgb->Red(), rgb->Green(), rgb->Blue()};
    } else {
        Quantity_Color named;
        if (colour.IsNull() || !STEPConstruct_Styles::DecodeColor(colour, named))
            return std::nullopt;
        named.Values(ours.red, ours.green, ours.blue, Quantity_TOC_sRGB);
    }
    if (!within(ours.red) || !within(ours.green) || !within(ours.blue))
        return std::nullopt;
    return ours;
}

std::optional<Colour> colourOf(const STEPConstruct_Styles& styles,
                               const Handle(StepVisual_StyledItem) & style)
{
    Handle(StepVisual_Colour) surface;
    Handle(StepVisual_Colour) boundary;
    Handle(StepVisual_Colour) curve;
    Handle(StepVisual_Colour) rendered;
    double transparency = 0;
    Standard_Boolean isComponent = Standard_False;
    if (!styles.GetColors(style, surface, boundary, curve, rendered, transparency, isComponent))
        return std::nullopt;
    return colourOf(surface.IsNull() ? rendered : surface);
}

struct ColouredShape {
    TopoDS_Shape shape;
    Colour colour;
};

std::vector<ColouredShape> colouredShapes(const STEPControl_Reader& reader)
{
    std::vector<ColouredShape> found;
    STEPConstruct_Styles styles(reader.WS());
    if (!styles.LoadStyles())
        return found;
    const Handle(Transfer_TransientProcess) transferred = reader.WS()->TransferReader()->TransientProcess();
    for (int k = 1; k <= styles.NbStyles(); ++k) {
        const auto style = styles.Style(k);
        if (style.IsNull() || style->Item().IsNull())
            continue;
        const auto colour = colourOf(styles, style);
        const TopoDS_Shape shape = STEPConstruct::FindShape(transferred, style->Item());
        if (colour && !shape.IsNull())
            found.push_back({shape, *colour});
    }
    return found;
}

}  // namespace

StepLabels::StepLabels(const STEPControl_Reader& reader) : reader_(reader)
{
    try {
        std::vector<ColouredShape> shapes = colouredShapes(reader);
        // Solids before their faces: what is nearer to the face has the last word.
        std::stable_sort(shapes.begin(), shapes.end(), [](const ColouredShape& a, const ColouredShape& b) {
            return a.shape.ShapeType() < b.shape.ShapeType();
        });
        for (const ColouredShape& coloured : shapes)
            for (TopExp_Explorer it(coloured.shape, TopAbs_FACE); it.More(); it.Next())
                colours_[it.Current().TShape().get()] = coloured.colour;
    } catch (const Standard_Failure&) {
        colours_.clear();  // a model without its colours is better than none
    }
}

FaceLabel StepLabels::of(const TopoDS_Face& face) const
{
    FaceLabel label;
    if (const auto found = colours_.find(face.TShape().get()); found != colours_.end())
        label.colour = found->second;
    const Handle(Standard_Transient) entity =
        reader_.WS()->TransferReader()->EntityFromShapeResult(face.Located(TopLoc_Location()), 1);
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
    if (!item.IsNull() && !item->Name().IsNull())
        label.name = item->Name()->ToCString();
    if (label.name == "NONE")
        label.name.clear();
    return label;
}

}  // namespace knotspan::formats
