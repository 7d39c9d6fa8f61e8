#include "model/cad/step_styles.h"

#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>

namespace knotspan::formats {

void StepColours::add(const Handle(StepRepr_RepresentationItem) & face, const Colour& colour)
{
    auto& assignment = assignments_[{colour.red, colour.green, colour.blue}];
    if (assignment.IsNull()) {
        const Handle(StepVisual_ColourRgb) rgb = new StepVisual_ColourRgb;
        rgb->Init(new TCollection_HAsciiString(""), colour.red, colour.green, colour.blue);
        assignment = styles_.MakeColorPSA(face, rgb, {}, {}, 0.0);
    }
    styledItems_.push_back(styles_.AddStyle(face, assignment, {}));
}

Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation)
    StepColours::representation(const Handle(StepRepr_RepresentationContext) & context) const
{
    const Handle(StepRepr_HArray1OfRepresentationItem) items =
        new StepRepr_HArray1OfRepresentationItem(1, static_cast<int>(styledItems_.size()));
    for (size_t k = 0; k < styledItems_.size(); ++k)
        items->SetValue(static_cast<int>(k) + 1, styledItems_[k]);
    const Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) representation =
        new StepVisual_MechanicalDesignGeometricPresentationRepresentation;
    representation->Init(new TCollection_HAsciiString(""), items, context);
    return representation;
}

}  // namespace knotspan::formats
