// A plane through the model in the window: its curves, their length, live.
#include <numbers>

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>

#include <glm/geometric.hpp>

#include "model/geometry/primitives.h"
#include "tests/ui/one_surface_test.h"
#include "ui/document_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

constexpr double kPi = std::numbers::pi;

class SectionTest : public OneSurfaceTest {
protected:
    [[nodiscard]] ShownSection& section() { return window->viewport().section(); }
    void show(const std::vector<NurbsSurface>& surfaces)
    {
        Scene model;
        for (const NurbsSurface& surface : surfaces)
            model.add({.surface = surface});
        window->document().reset(model, "Shapes");
        settle(*window);
    }
};

TEST_F(SectionTest, ShowsItsCurvesAndTheirLength)
{
    show({sphere({0, 0, 50}, 5)});
    const QImage bare = picture(*window);
    act("view.section");
    settle(*window);
    EXPECT_TRUE(window->action("view.section")->isChecked());
    EXPECT_EQ(section().settings().offset, 50) << "it goes to the model's middle";
    EXPECT_GT(differingPixels(bare, picture(*window)), 300);
    EXPECT_EQ(section().curves(), 1U);
    EXPECT_NEAR(section().length(), 10 * kPi, 1e-3);
    act("view.section");
    settle(*window);
    EXPECT_EQ(differingPixels(bare, picture(*window)), 0);
}

TEST_F(SectionTest, IsMovedInThePanel)
{
    window->findChild<QDockWidget*>("measures-dock")->show();
    show({sphere(Vec3(0), 5)});
    auto* offset = window->findChild<QDoubleSpinBox*>("section-offset");
    EXPECT_FALSE(offset->isEnabled());
    window->findChild<QCheckBox*>("section-shown")->click();
    window->findChild<QComboBox*>("section-axis")->setCurrentIndex(0);
    offset->setValue(3);
    settle(*window);
    EXPECT_NEAR(section().length(), 8 * kPi, 1e-3);
    EXPECT_TRUE(window->findChild<QLabel*>("section-length")->text().startsWith("1, together 25.13"))
        << window->findChild<QLabel*>("section-length")->text().toStdString();
    offset->setValue(6);
    settle(*window);
    EXPECT_EQ(window->findChild<QLabel*>("section-length")->text(), "none");
}

TEST_F(SectionTest, IsCutAgainOnlyWhereASurfaceChanged)
{
    show({sphere({-9, 0, 0}, 5), sphere({9, 0, 0}, 4)});
    act("view.section");
    settle(*window);
    const std::vector<SharedSpaceLines> before = section().lines();
    ASSERT_EQ(before.size(), 3U) << "the plane's outline and two cuts";
    EXPECT_EQ(section().lines(), before);
    SceneObject moved = *scene().objects().rbegin()->second;
    moved.transform[3].z = 2.4;
    Edit edit;
    edit.set(scene().objects().rbegin()->first, std::make_shared<const SceneObject>(moved));
    window->document().apply(edit, "Move", window->document().newGesture());  // as in a drag
    settle(*window);
    const std::vector<SharedSpaceLines> after = section().lines();
    ASSERT_EQ(after.size(), 3U);
    EXPECT_EQ(after[1], before[1]);
    EXPECT_NE(after[2], before[2]);
    EXPECT_NEAR(section().length(), 10 * kPi + 2 * kPi * 3.2, 1e-3);
}

TEST_F(SectionTest, OfManySurfacesComesPieceByPieceAndIsWhole)
{
    window->files().openSample("knot");
    settle(*window);
    act("view.section");
    settle(*window);
    EXPECT_TRUE(section().isComplete());
    EXPECT_FALSE(window->viewport().isDrawPending());
    const size_t all = section().lines().size();
    EXPECT_GT(all, 20U);
    double parts = 0;
    for (const SharedSpaceLines& lines : section().lines())
        if (lines != section().lines().front())
            for (const SpaceLine& line : lines->lines)
                parts += glm::distance(line.from, line.to);
    EXPECT_NEAR(parts, section().length(), 1e-9 * parts);
}

}  // namespace
}  // namespace knotspan
