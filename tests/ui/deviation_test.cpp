// Surfaces coloured by their distance from others, in the window: chosen, measured beside the hand, followed.
#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

#include "model/geometry/primitives.h"
#include "model/scene/edit.h"
#include "model/scene/mesh_object.h"
#include "tests/ui/one_surface_test.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class DeviationTest : public OneSurfaceTest {
protected:
    void SetUp() override
    {
        OneSurfaceTest::SetUp();
        if (IsSkipped())
            return;
        window->findChild<QDockWidget*>("measures-dock")->show();
        Scene model;
        inner = model.add({.name = "inner", .surface = sphere({0, 0, 0}, 2)});
        outer = model.add({.name = "outer", .surface = sphere({0, 0, 0}, 3)});
        window->document().reset(model, "Spheres");
        settle(*window);
    }
    [[nodiscard]] ShownDeviation& deviation() { return window->viewport().deviation(); }
    // Until all is measured and drawn.
    void wait()
    {
        settle(*window);
        while (deviation().isMeasuring())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 1000);
        settle(*window);
    }
    [[nodiscard]] QString text(const char* name) { return window->findChild<QLabel*>(name)->text(); }
    void place(ObjectId object, const Vec3& at)
    {
        SceneObject moved = *scene().find(object);
        moved.transform[3] = Vec4(at, 1);
        Edit edit;
        edit.set(object, std::make_shared<SceneObject>(std::move(moved)));
        window->document().apply(edit, "Move");
    }

    ObjectId inner{};
    ObjectId outer{};
};

TEST_F(DeviationTest, MeasuresWhatIsSelectedFromAllOthersAndFollowsEdits)
{
    window->selection().setObjects({outer});
    act("view.deviation");
    EXPECT_TRUE(window->action("view.deviation")->isChecked());
    wait();
    EXPECT_EQ(deviation().settings().measured, std::set{outer});
    ASSERT_NE(deviation().map(), nullptr);
    EXPECT_NEAR(deviation().map()->figures.largest, 1, deviation().map()->uncertainty());
    EXPECT_EQ(text("deviation-measured"), "outer");
    EXPECT_EQ(text("deviation-reference"), "all others");
    EXPECT_TRUE(text("deviation-largest").contains(" mm (± ")) << text("deviation-largest").toStdString();
    window->selection().clear();  // what is measured stays
    place(outer, {0.5, 0, 0});
    wait();
    EXPECT_NEAR(deviation().map()->figures.largest, 1.5, deviation().map()->uncertainty());
    EXPECT_NEAR(text("deviation-mean").split(' ').first().toDouble(), 1, 0.05);
    act("view.deviation");
    wait();
    EXPECT_EQ(deviation().map(), nullptr) << "nothing is kept where it is not shown";
    EXPECT_EQ(window->viewport().frame().shading, Shading::shaded);
}

TEST_F(DeviationTest, AReferenceThatWasNamedCountsWhileItIsHidden)
{
    SceneObject hidden = *scene().find(outer);
    hidden.visible = false;
    Edit edit;
    edit.set(outer, std::make_shared<SceneObject>(std::move(hidden)));
    window->document().apply(edit, "Hide");
    act("view.deviation");
    wait();
    EXPECT_EQ(deviation().map(), nullptr) << "what is hidden is none of all others";
    deviation().setSettings({{inner}, {outer}});
    wait();
    ASSERT_NE(deviation().map(), nullptr);
    EXPECT_NEAR(deviation().map()->figures.largest, 1, deviation().map()->uncertainty());
}

TEST_F(DeviationTest, ThePictureHasTheRampsColours)
{
    window->selection().setObjects({outer});
    act("view.deviation");
    auto* low = window->findChild<QDoubleSpinBox*>("deviation-low");
    auto* high = window->findChild<QDoubleSpinBox*>("deviation-high");
    EXPECT_FALSE(low->isEnabled());
    window->findChild<QCheckBox*>("deviation-automatic")->setChecked(false);
    wait();
    high->setValue(5);
    window->selection().clear();
    wait();
    ASSERT_EQ(window->viewport().frame().look.deviationRange, (NumberRange{0, 5}));
    const QImage shown = picture(*window);
    const QColor middle = shown.pixelColor(shown.width() / 2, shown.height() / 2);
    const Vec3 expected = colourOnRamp(0.2);  // 1 of 5
    EXPECT_NEAR(middle.redF(), expected.x, 0.01);
    EXPECT_NEAR(middle.greenF(), expected.y, 0.01);
    EXPECT_NEAR(middle.blueF(), expected.z, 0.01);
}

TEST_F(DeviationTest, TheReferenceIsTakenByAButtonAndMayBeAMesh)
{
    Scene model = scene();
    const ObjectId mesh =
        model.addMesh(meshObject("floor", {{{-50, -50, -7}, {50, -50, -7}, {0, 50, -7}}, {{0, 1, 2}}}));
    window->document().reset(model, "Spheres");
    window->selection().setObjects({inner});
    window->findChild<QPushButton*>("deviation-measured-take")->click();
    window->selection().setObjects({}, {mesh});
    window->findChild<QPushButton*>("deviation-reference-take")->click();
    EXPECT_EQ(deviation().settings().reference, std::set{mesh});
    window->findChild<QCheckBox*>("deviation-shown")->click();
    wait();
    ASSERT_NE(deviation().map(), nullptr);
    EXPECT_NEAR(deviation().map()->figures.largest, 9, deviation().map()->uncertainty());
    EXPECT_EQ(text("deviation-measured"), "inner");
}

TEST_F(DeviationTest, SaysWhatIsMissingWhereNothingIsChosen)
{
    window->selection().clear();
    act("view.deviation");
    wait();
    EXPECT_EQ(deviation().map(), nullptr);
    EXPECT_TRUE(text("deviation-largest").startsWith("There is nothing to compare"));
    const QImage shown = picture(*window);
    EXPECT_EQ(shown.pixelColor(shown.width() / 2, shown.height() / 2), QColor(128, 128, 128));
}

}  // namespace
}  // namespace knotspan
