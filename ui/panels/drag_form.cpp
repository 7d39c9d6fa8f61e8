#include "ui/panels/drag_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>

namespace knotspan {

namespace {

// As the list of symmetries has them: planes across the model's axes come first.
enum class SymmetryRow { none, x, y, z, u, v };

SymmetryRow rowOf(const Symmetry& symmetry)
{
    switch (symmetry.kind) {
    case SymmetryKind::none:
        break;
    case SymmetryKind::plane:
        return symmetry.plane.normal.x != 0   ? SymmetryRow::x
               : symmetry.plane.normal.y != 0 ? SymmetryRow::y
                                              : SymmetryRow::z;
    case SymmetryKind::u:
        return SymmetryRow::u;
    case SymmetryKind::v:
        return SymmetryRow::v;
    }
    return SymmetryRow::none;
}

Symmetry symmetryOf(SymmetryRow row, double place)
{
    Symmetry symmetry;
    switch (row) {
    case SymmetryRow::none:
        break;
    case SymmetryRow::u:
        symmetry.kind = SymmetryKind::u;
        break;
    case SymmetryRow::v:
        symmetry.kind = SymmetryKind::v;
        break;
    default: {
        const int axis = static_cast<int>(row) - static_cast<int>(SymmetryRow::x);
        symmetry.kind = SymmetryKind::plane;
        symmetry.plane.normal = Vec3(0);
        symmetry.plane.normal[axis] = 1;
        symmetry.plane.point = Vec3(0);
        symmetry.plane.point[axis] = place;
    }
    }
    return symmetry;
}

}  // namespace

DragForm::DragForm(Document& document, Viewport& viewport, QWidget* parent)
    : ToolForm(document, viewport, tr("Dragging"), parent)
{
    axis_ = list("drag-axis", tr("Dra&g"), tr("Which way dragged control points go"),
                 {tr("freely, facing the eye"), tr("along X"), tr("along Y"), tr("along Z"),
                  tr("along the net's U"), tr("along the net's V"), tr("along the surface's normal")});
    eachItsOwn_ = check("each-its-own", tr("Each &point its own way"),
                        tr("Along U, V or the normal, let each control point go its own way, not all one"));
    gizmo_ = list("gizmo", tr("Gi&zmo"), tr("Which handles there are at what is selected"),
                  {tr("none"), tr("the model's axes"), tr("U, V and normal")});
    radius_ =
        number("falloff-radius", tr("&Falloff radius"),
               tr("How far control points around the selected ones follow, less and less; 0: none do"), {});
    shape_ = list("falloff-shape", tr("Falloff &shape"), tr("How the following fades out"),
                  {tr("smooth"), tr("sphere"), tr("linear"), tr("sharp"), tr("constant")});
    distance_ = list("falloff-distance", tr("&Measured"), tr("What the radius counts"),
                     {tr("in space"), tr("in steps along the net"), tr("in lengths along the net")});
    symmetry_ = list(
        "symmetry", tr("S&ymmetry"), tr("Let control points follow as mirror images"),
        {tr("none"), tr("across X"), tr("across Y"), tr("across Z"), tr("the net's U"), tr("the net's V")});
    place_ = number("symmetry-place", tr("Plane &at"), tr("Where the plane crosses its axis"), {-1e9});
    keepFriends_ = check("keep-friends", tr("&Keep friends"),
                         tr("Where surfaces meet smoothly, let both sides of the edge follow"));
    begin();
}

void DragForm::show(const ToolSettings& settings)
{
    const DragSettings& drag = settings.drag;
    axis_->setCurrentIndex(static_cast<int>(drag.axis));
    eachItsOwn_->setChecked(drag.eachItsOwn);
    gizmo_->setCurrentIndex(static_cast<int>(settings.gizmo));
    radius_->setValue(drag.falloff.radius);
    shape_->setCurrentIndex(static_cast<int>(drag.falloff.shape));
    distance_->setCurrentIndex(static_cast<int>(drag.falloff.distance));
    const SymmetryRow row = rowOf(drag.symmetry);
    symmetry_->setCurrentIndex(static_cast<int>(row));
    place_->setValue(glm::dot(drag.symmetry.plane.point, drag.symmetry.plane.normal));
    place_->setEnabled(drag.symmetry.kind == SymmetryKind::plane);
    keepFriends_->setChecked(settings.keepFriends);
    const bool counts = drag.falloff.distance == FalloffDistance::netSteps;
    radius_->setSuffix(counts ? tr(" steps") : units());
    place_->setSuffix(units());
    radius_->setSingleStep(counts ? 1 : stepLength());
    place_->setSingleStep(stepLength());
}

void DragForm::read(ToolSettings& settings) const
{
    settings.drag.axis = static_cast<DragAxis>(axis_->currentIndex());
    settings.drag.eachItsOwn = eachItsOwn_->isChecked();
    settings.gizmo = static_cast<GizmoFrame>(gizmo_->currentIndex());
    settings.drag.falloff = {radius_->value(), static_cast<FalloffShape>(shape_->currentIndex()),
                             static_cast<FalloffDistance>(distance_->currentIndex())};
    settings.drag.symmetry = symmetryOf(static_cast<SymmetryRow>(symmetry_->currentIndex()), place_->value());
    settings.keepFriends = keepFriends_->isChecked();
}

}  // namespace knotspan
