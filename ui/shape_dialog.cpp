#include "ui/shape_dialog.h"

#include <algorithm>

#include <QComboBox>
#include <QDoubleSpinBox>

#include "ui/scene_additions.h"

namespace knotspan {

namespace {

bool isAmong(ShapeKind kind, std::initializer_list<ShapeKind> kinds)
{
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

bool contains(const Box& box, const Vec3& point)
{
    for (int k = 0; k < 3; ++k)
        if (point[k] < box.low[k] || point[k] > box.high[k])
            return false;
    return true;
}

}  // namespace

ShapeDialog::ShapeDialog(Document& document, Selection& selection, QWidget* parent)
    : MakingDialog(document, selection, tr("Add a shape"), parent)
{
    setObjectName("shape-dialog");
    shape_ = addChoice("shape", tr("&Shape"), tr("What is added; each is exact"),
                       {tr("Plane"), tr("Cylinder"), tr("Cone"), tr("Sphere"), tr("Torus")});
    sizeU_ = addLength("size-u", tr("Length along &U"), tr("How long the rectangle is"));
    sizeV_ = addLength("size-v", tr("Length along &V"), tr("How wide the rectangle is"));
    radius_ =
        addLength("radius", tr("&Radius"),
                  tr("From the axis to the surface; of a cone at its base, of a torus to the tube's middle"));
    radiusAbove_ = addLength("radius-above", tr("Radius at the &top"),
                             tr("Of a cone at its upper end; 0 makes it pointed"));
    tube_ = addLength("tube", tr("Radius of the &tube"), tr("Half as thick as the tube of the torus is"));
    height_ = addLength("height", tr("&Height"), tr("Along the axis, from the base"));
    centre_ = addVector("centre", tr("&Centre"), tr("Where the shape stands"));
    axis_ = addChoice("axis", tr("A&xis"), tr("The axis of the model that the shape stands along"),
                      {tr("X"), tr("Y"), tr("Z")});
    shape_->setCurrentIndex(static_cast<int>(ShapeKind::sphere));
    axis_->setCurrentIndex(2);
    finishLayout();
    connect(shape_, &QComboBox::currentIndexChanged, this, &ShapeDialog::showWhatCounts);
    showWhatCounts();
}

ShapeKind ShapeDialog::kind() const
{
    return static_cast<ShapeKind>(shape_->currentIndex());
}

// Once for each size of scene: what was typed stays.
void ShapeDialog::offerNumbers()
{
    const double size = sceneSize();
    if (size == offered_)
        return;
    offered_ = size;
    for (QDoubleSpinBox* box : {sizeU_, sizeV_, radius_, height_})
        setQuietly(*box, size);
    setQuietly(*radiusAbove_, 0);
    setQuietly(*tube_, size / 4);
    const Box bounds = scene().bounds();
    setValue(centre_, bounds.isEmpty() || contains(bounds, Vec3(0)) ? Vec3(0) : bounds.centre());
}

// Of the boxes, those that count for what is chosen.
void ShapeDialog::showWhatCounts()
{
    using Kind = ShapeKind;
    const ShapeKind what = kind();
    for (QDoubleSpinBox* box : {sizeU_, sizeV_})
        showRow(box, what == Kind::plane);
    showRow(radius_, what != Kind::plane);
    showRow(radiusAbove_, what == Kind::cone);
    showRow(tube_, what == Kind::torus);
    showRow(height_, isAmong(what, {Kind::cylinder, Kind::cone}));
    setRowLabel(centre_,
                isAmong(what, {Kind::cylinder, Kind::cone}) ? tr("&Centre of the base") : tr("&Centre"));
}

Placement ShapeDialog::placement() const
{
    const int axis = axis_->currentIndex();
    Placement placement;
    placement.origin = valueOf(centre_);
    placement.axis = placement.direction = Vec3(0);
    placement.axis[axis] = 1;
    placement.direction[(axis + 1) % 3] = 1;
    return placement;
}

Result<NurbsSurface> ShapeDialog::surface() const
{
    const double radius = radius_->value();
    switch (kind()) {
    case ShapeKind::plane:
        return planeShape(placement(), sizeU_->value(), sizeV_->value());
    case ShapeKind::cylinder:
        return cylinderShape(placement(), radius, height_->value());
    case ShapeKind::cone:
        return coneShape(placement(), radius, radiusAbove_->value(), height_->value());
    case ShapeKind::sphere:
        return sphereShape(placement(), radius);
    case ShapeKind::torus:
        break;
    }
    return torusShape(placement(), radius, tube_->value());
}

Making ShapeDialog::make() const
{
    Result<NurbsSurface> made = surface();
    if (!made)
        return refusal(made.error());
    const QString steps[] = {tr("Add a plane"), tr("Add a cylinder"), tr("Add a cone"), tr("Add a sphere"),
                             tr("Add a torus")};
    SceneAdditions additions(scene());
    const std::string name = additions.addNamed(shape_->currentText(), *std::move(made));
    Making making;
    making.edit = additions.edit();
    making.selected = additions.ids();
    making.step = steps[static_cast<size_t>(kind())];
    making.told = tr("Adds \"%1\", of %2 control points.")
                      .arg(QString::fromStdString(name))
                      .arg(additions.controlPointCount());
    return making;
}

}  // namespace knotspan
