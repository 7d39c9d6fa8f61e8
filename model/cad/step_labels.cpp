#include "model/cad/step_labels.h"

#include <algorithm>
#include <vector>

#include <Quantity_Color.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "model/cad/step_writing.h"

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

// Nothing where a writer only filled the place.
std::string meaningful(const Handle(TCollection_HAsciiString) & text)
{
    const std::string name = text.IsNull() ? "" : text->ToCString();
    const bool blank = name.find_first_not_of(' ') == std::string::npos;
    const bool filled =
        name == "NONE" || name == kOurStepProduct || name.starts_with("Open CASCADE STEP translator");
    return blank || filled ? std::string() : name;
}

std::string productName(const Handle(StepBasic_ProductDefinition) & definition)
{
    if (definition->Formation().IsNull() || definition->Formation()->OfProduct().IsNull())
        return {};
    const Handle(StepBasic_Product) product = definition->Formation()->OfProduct();
    const std::string name = meaningful(product->Name());
    return name.empty() ? meaningful(product->Id()) : name;
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

StepLabels::StepLabels(const STEPControl_Reader& reader) : entities_(reader.WS())
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

ShapeName StepLabels::name(const TopoDS_Shape& shape) const
{
    ShapeName name;
    for (const Handle(Standard_Transient) & entity : entities_.of(shape)) {
        if (const auto definition = Handle(StepBasic_ProductDefinition)::DownCast(entity);
            !definition.IsNull())
            name.product = productName(definition);
        else if (const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
                 !item.IsNull() &&
                 name.item.empty())  // a body's own name, not those of the places it stands in
            name.item = meaningful(item->Name());
    }
    return name;
}

std::optional<Colour> StepLabels::colour(const TopoDS_Face& face) const
{
    const auto found = colours_.find(face.TShape().get());
    return found == colours_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace knotspan::formats
