#include "ui/transform_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>

namespace knotspan {

TransformDialog::TransformDialog(Document& document, Selection& selection, QWidget* parent)
    : MakingDialog(document, selection, tr("Move, turn, scale"), parent)
{
    setObjectName("transform-dialog");
    move_ = addVector("move", tr("&Move along"), tr("How far, along the model's axes; last of the three"));
    turn_ =
        addVector("turn", tr("&Turn about"),
                  tr("Degrees about the model's axes, by the right hand: first x, then y, then z"), false);
    scale_ = addVector("scale", tr("S&cale along"),
                       tr("How many times as large, along the model's axes; first of the three; below zero "
                          "mirrors"),
                       false);
    for (QDoubleSpinBox* box : turn_) {
        box->setDecimals(4);
        box->setSuffix(tr("°"));
        box->setSingleStep(15);
    }
    for (QDoubleSpinBox* box : scale_) {
        box->setSingleStep(0.1);
        box->setValue(1);
    }
    about_ = addChoice("about", tr("Ab&out"), tr("What stays where it is when turned and scaled"),
                       {tr("the centre of the selection"), tr("the model's origin")});
    finishLayout();
    followSelection();
}

QString TransformDialog::step(const TransformNumbers& numbers, int count) const
{
    const bool moves = numbers.translation != Vec3(0);
    const bool turns = numbers.degrees != Vec3(0);
    const bool scales = numbers.scale != Vec3(1);
    const QString objects = count == 1 ? tr("an object") : tr("%1 objects").arg(count);
    if (moves && !turns && !scales)
        return tr("Move %1").arg(objects);
    if (turns && !moves && !scales)
        return tr("Turn %1").arg(objects);
    if (scales && !moves && !turns)
        return tr("Scale %1").arg(objects);
    return tr("Transform %1").arg(objects);
}

Making TransformDialog::make() const
{
    const Selected objects = selectedObjects();
    if (objects.empty())
        return refusal(tr("Select what is to be moved: click it in the viewport."));
    TransformNumbers numbers{valueOf(move_), valueOf(turn_), valueOf(scale_), Vec3(0)};
    if (about_->currentIndex() == 0)
        numbers.pivot = centreOf(objects);
    const Result<Mat4> matrix = transformMatrix(numbers);
    if (!matrix)
        return refusal(matrix.error());
    if (*matrix == Mat4(1.0))
        return refusal(
            tr("These numbers leave everything where it is: give a distance, an angle or a scale."));
    Making making;
    for (const auto& [id, object] : objects) {
        Result<SceneObject> placed = moved(*object, *matrix);
        if (!placed)
            return refusal(placed.error());
        making.edit.set(id, std::make_shared<SceneObject>(*std::move(placed)));
        making.selected.insert(id);
    }
    const int count = static_cast<int>(objects.size());
    making.step = step(numbers, count);
    making.told = tr("Changes where the selected objects stand: %1. Their control points keep their own "
                     "coordinates.")
                      .arg(count);
    return making;
}

}  // namespace knotspan
