#include "ui/mirror_dialog.h"

#include <QCheckBox>
#include <QComboBox>

#include "model/making/object_making.h"
#include "ui/scene_additions.h"

namespace knotspan {

MirrorDialog::MirrorDialog(Document& document, Selection& selection, QWidget* parent)
    : MakingDialog(document, selection, tr("Mirror"), parent)
{
    setObjectName("mirror-dialog");
    // In the order of the axes that they lie across.
    plane_ = addChoice(
        "plane", tr("&Plane"), tr("The plane that mirrors"),
        {tr("YZ: left and right change"), tr("XZ: front and back change"), tr("XY: above and below change")});
    through_ = addChoice("through", tr("&Through"), tr("Where the plane lies"),
                         {tr("the model's origin"), tr("the centre of the selection")});
    copy_ = addSwitch("copy", tr("Mirror &copies, and keep the objects"),
                      tr("Off: the objects themselves are mirrored"));
    copy_->setChecked(true);
    finishLayout();
    followSelection();
}

Making MirrorDialog::make() const
{
    const Selected objects = selectedObjects();
    if (objects.empty())
        return refusal(tr("Select what is to be mirrored: click it in the viewport."));
    MirrorPlane plane;
    plane.normal = Vec3(0);
    plane.normal[plane_->currentIndex()] = 1;
    if (through_->currentIndex() == 1)
        plane.point = centreOf(objects);
    const bool isCopy = copy_->isChecked();
    const int count = static_cast<int>(objects.size());
    SceneAdditions copies(scene());
    Making making;
    for (const auto& [id, object] : objects) {
        Result<SceneObject> image = mirrored(*object, plane);
        if (!image)
            return refusal(image.error());
        if (isCopy)
            copies.addCopy(*image);
        else
            making.edit.set(id, std::make_shared<SceneObject>(*std::move(image)));
        making.selected.insert(id);
    }
    if (isCopy) {
        making.edit = copies.edit();
        making.selected = copies.ids();
    }
    making.step = count == 1 ? (isCopy ? tr("Mirror a copy") : tr("Mirror an object"))
                             : (isCopy ? tr("Mirror %1 copies") : tr("Mirror %1 objects")).arg(count);
    making.told = isCopy ? tr("Adds mirrored copies and selects them: %1.").arg(count)
                         : tr("Mirrors the selected objects: %1.").arg(count);
    return making;
}

}  // namespace knotspan
