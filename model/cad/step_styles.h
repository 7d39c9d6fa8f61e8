// The colours of faces in a STEP file that is written.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include <STEPConstruct_Styles.hxx>
#include <StepRepr_RepresentationContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>

#include "model/scene/scene_object.h"

namespace knotspan::formats {

class StepColours {
public:
    explicit StepColours(const Handle(XSControl_WorkSession) & session) : styles_(session) {}

    void add(const Handle(StepRepr_RepresentationItem) & face, const Colour& colour);

    // All of them, for the model; there must be one.
    [[nodiscard]] Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation)
        representation(const Handle(StepRepr_RepresentationContext) & context) const;

private:
    STEPConstruct_Styles styles_;
    std::vector<Handle(StepRepr_RepresentationItem)> styledItems_;
    // A colour is written once, however many faces have it.
    std::map<std::tuple<double, double, double>, Handle(StepVisual_PresentationStyleAssignment)> assignments_;
};

}  // namespace knotspan::formats
