// Curvature combs in the window: of what is selected, live, made again only where something changed.
#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QSpinBox>

#include <glm/geometric.hpp>

#include "model/geometry/primitives.h"
#include "tests/ui/one_surface_test.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class CombsTest : public OneSurfaceTest {
protected:
    [[nodiscard]] ShownCombs& combs() { return window->viewport().combs(); }
    void show(const std::vector<NurbsSurface>& surfaces)
    {
        Scene model;
        std::set<ObjectId> ids;
        for (const NurbsSurface& surface : surfaces)
            ids.insert(model.add({.surface = surface}));
        window->document().reset(model, "Shapes");
        window->selection().setObjects(ids);
        settle(*window);
    }
    static double lengthOf(const SpaceLine& line) { return glm::distance(line.from, line.to); }
};

TEST_F(CombsTest, ShowOnWhatIsSelectedAndNowhereElse)
{
    const QImage bare = picture(*window);
    act("view.combs");
    settle(*window);
    EXPECT_TRUE(window->action("view.combs")->isChecked());
    EXPECT_GT(differingPixels(bare, picture(*window)), 500);
    act("view.combs");
    settle(*window);
    EXPECT_EQ(differingPixels(bare, picture(*window)), 0);
    window->selection().clear();
    settle(*window);
    const QImage unselected = picture(*window);
    act("view.combs");
    settle(*window);
    EXPECT_EQ(differingPixels(unselected, picture(*window)), 0);
}

TEST_F(CombsTest, PointOutOfTheBendAndAreLongerWhereItIsStronger)
{
    act("view.combs");
    show({cylinder({-9, 0, 0}, 2, 3), cylinder({9, 0, 0}, 4, 3)});
    EXPECT_DOUBLE_EQ(combs().strongest(), 0.5);
    std::vector<double> teeth;
    for (const size_t around : {1, 3})  // the others run straight upwards
        for (const SpaceLine& line : combs().lines().at(around)->lines) {
            const Vec3 axis(line.from.x < 0 ? -9 : 9, 0, line.from.z);
            const double radius = line.from.x < 0 ? 2 : 4;
            if (std::abs(glm::distance(line.from, axis) - radius) > 1e-9 || line.from.z != line.to.z)
                continue;  // between tips
            const double length = lengthOf(line);
            EXPECT_NEAR(glm::distance(line.to, axis), radius + length, 1e-9) << "straight away from the axis";
            teeth.push_back(length * radius);
        }
    ASSERT_GT(teeth.size(), 100U);
    for (const double tooth : teeth)
        EXPECT_NEAR(tooth, teeth.front(), 1e-9) << "as one over the radius";
    const double longest = teeth.front() / 2 / scene().bounds().diagonal();
    EXPECT_LE(longest, 0.08);
    EXPECT_GE(longest, 0.08 / 1.5) << "about as long as asked for";
}

TEST_F(CombsTest, AreMadeAgainOnlyWhereASurfaceChanged)
{
    act("view.combs");
    show({cylinder({-9, 0, 0}, 2, 3), cylinder({9, 0, 0}, 4, 3)});
    const std::vector<SharedSpaceLines> before = combs().lines();
    ASSERT_EQ(before.size(), 4U);
    EXPECT_EQ(combs().lines(), before);
    SceneObject moved = *scene().objects().rbegin()->second;
    moved.transform[3].z = 1;
    Edit edit;
    edit.set(scene().objects().rbegin()->first, std::make_shared<const SceneObject>(moved));
    window->document().apply(edit, "Move", window->document().newGesture());  // as in a drag
    const std::vector<SharedSpaceLines> after = combs().lines();
    ASSERT_EQ(after.size(), 4U);
    EXPECT_EQ(after[0], before[0]);
    EXPECT_EQ(after[1], before[1]);
    EXPECT_NE(after[2], before[2]);
    EXPECT_NEAR(after[2]->lines.front().from.z, before[2]->lines.front().from.z + 1, 1e-12);
}

TEST_F(CombsTest, AreAsManyAsThePanelSays)
{
    window->findChild<QDockWidget*>("measures-dock")->show();
    auto* shown = window->findChild<QCheckBox*>("combs-shown");
    auto* curves = window->findChild<QSpinBox*>("combs-curves");
    EXPECT_FALSE(curves->isEnabled());
    shown->click();
    show({plane(Vec3(0), {2, 0, 0}, {0, 2, 0})});
    EXPECT_TRUE(curves->isEnabled());
    EXPECT_EQ(window->findChild<QLabel*>("combs-strongest")->text(), "-") << "nothing bends";
    show({cylinder(Vec3(0), 2, 3)});
    const auto teeth = [this] { return combs().lines()[1]->lines.size(); };
    const size_t five = teeth();
    curves->setValue(10);
    EXPECT_EQ(teeth(), 2 * five);
    settle(*window);
    EXPECT_EQ(window->findChild<QLabel*>("combs-strongest")->text(), "0.5 1/mm, radius 2 mm");
}

}  // namespace
}  // namespace knotspan
