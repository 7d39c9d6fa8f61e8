// Duplicate, Mirror and Move, turn, scale, driven through their boxes and buttons: the document, one undo
// step, the preview.
#include <QCheckBox>
#include <QStatusBar>

#include <glm/geometric.hpp>

#include "tests/ui/making_harness.h"
#include "ui/curves_dialog.h"
#include "ui/mirror_dialog.h"
#include "ui/shape_dialog.h"
#include "ui/transform_dialog.h"

namespace knotspan::testing {

namespace {

double difference(const Vec3& a, const Vec3& b)
{
    return glm::distance(a, b);
}

}  // namespace

TEST(Duplicate, CopiesTheSelectedObjectsInPlaceAndSelectsTheCopies)
{
    MakingWindow opened("nine-16");
    EXPECT_FALSE(opened.window.action("object.duplicate")->isEnabled());
    opened.select(2);
    const std::set<ObjectId> originals = opened.window.selection().objects();
    opened.window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&opened.window));
    QTest::keyClick(&opened.window, Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(opened.steps(), 1);
    EXPECT_EQ(opened.window.document().undoText(), "Duplicate 2 objects");
    EXPECT_EQ(opened.scene().objects().size(), opened.start.objects().size() + 2);
    const std::set<ObjectId> copies = opened.window.selection().objects();
    ASSERT_EQ(copies.size(), 2U);
    auto original = originals.begin();
    for (const ObjectId id : copies) {
        const SceneObject& copy = *opened.scene().find(id);
        const SceneObject& of = *opened.scene().find(*original++);
        EXPECT_EQ(copy.surface, of.surface);
        EXPECT_EQ(copy.transform, of.transform);
        EXPECT_NE(copy.name, of.name);
    }
    EXPECT_NE(opened.window.statusBar()->currentMessage().indexOf("same place"), -1);
    opened.expectUndone();
}

TEST(MirrorDialog, MirrorsCopiesInEachPlaneThroughTheOriginExactly)
{
    MakingWindow opened("nine-16");
    opened.select(2);
    opened.bringUp<MirrorDialog>("object.mirror");
    for (int axis = 0; axis < 3; ++axis) {
        opened.select(2);
        opened.choose("plane", (axis + 1) % 3);
        opened.choose("plane", axis);
        opened.expectOneStep("Mirror 2 copies");
        ASSERT_EQ(opened.scene().objects().size(), opened.start.objects().size() + 2);
        const SceneObject& of = *opened.start.objects().begin()->second;
        const SceneObject& copy = *opened.scene().find(*opened.window.selection().objects().begin());
        EXPECT_EQ(copy.surface, of.surface);
        Vec3 mirroredPoint = transformed(of.surface.controlPoints().front().position, of.transform);
        mirroredPoint[axis] = -mirroredPoint[axis];
        EXPECT_EQ(transformed(copy.surface.controlPoints().front().position, copy.transform), mirroredPoint);
        opened.expectUndone();
    }
}

TEST(MirrorDialog, MirrorsInPlaceThroughTheCentreOfTheSelection)
{
    MakingWindow opened("single-100");
    opened.select(1);
    opened.bringUp<MirrorDialog>("object.mirror");
    opened.choose("through", 1);
    opened.the<QCheckBox>("copy").setChecked(false);
    opened.wait();
    const ObjectId id = opened.start.objects().begin()->first;
    opened.expectOneStep("Mirror an object");
    EXPECT_EQ(opened.scene().objects().size(), 1U);
    const Box before = opened.start.find(id)->bounds();
    EXPECT_LT(difference(opened.scene().find(id)->bounds().centre(), before.centre()),
              1e-13 * before.diagonal());
    opened.expectUndone();
}

TEST(TransformDialog, MovesTurnsAndScalesByTheNumbersTyped)
{
    MakingWindow opened("single-100");
    opened.select(1);
    opened.bringUp<TransformDialog>("object.transform");
    opened.expectNothing("leave everything where it is");
    const ObjectId id = opened.start.objects().begin()->first;
    const SceneObject before = *opened.start.find(id);
    const Vec3 centre = before.bounds().centre();
    const Vec3 corner = transformed(before.surface.controlPoints().front().position, before.transform);
    opened.type("move-x", 3);
    opened.type("turn-z", 90);
    opened.type("scale-x", 2);
    opened.expectOneStep("Transform an object");
    const SceneObject after = *opened.scene().find(id);
    EXPECT_EQ(after.surface, before.surface);
    const Vec3 arm = corner - centre;
    const Vec3 expected = centre + Vec3(3, 0, 0) + Vec3(-arm.y, 2 * arm.x, arm.z);
    EXPECT_LT(
        difference(transformed(after.surface.controlPoints().front().position, after.transform), expected),
        1e-12 * before.bounds().diagonal());
    opened.expectUndone();
}

TEST(TransformDialog, NamesItsStepForWhatItDoes)
{
    const std::pair<const char*, const char*> steps[] = {
        {"move-y", "Move 2 objects"}, {"turn-x", "Turn 2 objects"}, {"scale-z", "Scale 2 objects"}};
    for (const auto& [box, step] : steps) {
        MakingWindow opened("nine-16");
        opened.select(2);
        opened.bringUp<TransformDialog>("object.transform");
        opened.choose("about", 1);
        opened.type(box, 4.5);
        opened.expectOneStep(step);
        opened.expectUndone();
    }
}

TEST(TransformDialog, RefusesAScaleOfZeroAndKeepsWhatWasThere)
{
    MakingWindow opened("single-100");
    opened.select(1);
    opened.bringUp<TransformDialog>("object.transform");
    opened.type("scale-y", 0);
    opened.expectNothing("scale");
}

// A preview of one object must not be applied to the next one that is selected.
TEST(TransformDialog, FollowsTheSelectionAndClosingTakesThePreviewBack)
{
    MakingWindow opened("nine-16");
    opened.select(1);
    opened.bringUp<TransformDialog>("object.transform");
    opened.type("move-x", 5);
    const ObjectId first = opened.start.objects().begin()->first;
    const ObjectId other = std::next(opened.start.objects().begin())->first;
    EXPECT_NE(opened.scene().find(first), opened.start.find(first));
    opened.window.selection().setObjects({other});
    EXPECT_EQ(opened.scene().find(first), opened.start.find(first));
    opened.wait();
    EXPECT_NE(opened.scene().find(other), opened.start.find(other));
    opened.dialog->reject();
    EXPECT_TRUE(opened.scene() == opened.start);
    EXPECT_EQ(opened.steps(), 0);
}

TEST(MakingDialogs, WithNothingSelectedOrAnEmptyDocumentSayWhatToDo)
{
    for (const char* sample : {"", "single-100"}) {
        MakingWindow opened(sample);
        opened.bringUp<MirrorDialog>("object.mirror");
        opened.expectNothing("Select what is to be mirrored");
        opened.bringUp<TransformDialog>("object.transform");
        opened.expectNothing("Select what is to be moved");
        opened.bringUp<CurvesDialog>("object.curves");
        opened.expectNothing("Select the surfaces");
    }
}

TEST(MakingDialogs, EveryBoxHasATipAndANameAndIsReachedByTheTabulator)
{
    MakingWindow opened("");
    opened.bringUp<ShapeDialog>("object.add");
    opened.bringUp<MirrorDialog>("object.mirror");
    opened.bringUp<TransformDialog>("object.transform");
    opened.bringUp<CurvesDialog>("object.curves");
    for (const MakingDialog* dialog : opened.window.findChildren<MakingDialog*>())
        for (const QWidget* widget : dialog->findChildren<QWidget*>()) {
            const bool isBox = qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
                               qobject_cast<const QComboBox*>(widget) != nullptr ||
                               qobject_cast<const QAbstractButton*>(widget) != nullptr;
            if (!isBox)
                continue;
            EXPECT_FALSE(widget->toolTip().isEmpty()) << widget->objectName().toStdString();
            EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->objectName().toStdString();
            EXPECT_TRUE(widget->focusPolicy() & Qt::TabFocus) << widget->objectName().toStdString();
        }
}

TEST(MakingDialogs, NoTwoThatAreShownHaveTheSameMnemonic)
{
    MakingWindow opened("");
    opened.bringUp<ShapeDialog>("object.add");
    opened.bringUp<MirrorDialog>("object.mirror");
    opened.bringUp<TransformDialog>("object.transform");
    opened.bringUp<CurvesDialog>("object.curves");
    for (const MakingDialog* dialog : opened.window.findChildren<MakingDialog*>()) {
        auto* choice = dialog->findChild<QComboBox*>();
        for (int k = 0; k < choice->count(); ++k) {
            choice->setCurrentIndex(k);
            std::set<QString> seen;
            const auto take = [&](const QWidget& widget, const QString& text) {
                const QString key = QKeySequence::mnemonic(text).toString();
                if (key.isEmpty() || widget.isHidden())
                    return;
                EXPECT_TRUE(seen.insert(key).second) << text.toStdString();
            };
            for (const QLabel* label : dialog->findChildren<QLabel*>())
                take(*label, label->text());
            for (const QAbstractButton* button : dialog->findChildren<QAbstractButton*>())
                take(*button, button->text());
            EXPECT_GE(seen.size(), 4U);
        }
    }
}

}  // namespace knotspan::testing
