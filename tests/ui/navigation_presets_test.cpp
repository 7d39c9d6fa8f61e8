// Each way to turn the view by mouse: its buttons move the eye, and no others do.
#include "ui/viewport/navigation_presets.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QSettings>

#include <glm/geometric.hpp>

#include "tests/ui/window_harness.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

// What a drag did to the eye.
std::optional<ViewTurn> turnOf(const Camera& before, const Camera& after)
{
    if (before == after)
        return std::nullopt;
    if (glm::distance(before.target, after.target) < 1e-12)
        return std::abs(before.distance() - after.distance()) < 1e-9 ? ViewTurn::orbit : ViewTurn::zoom;
    return std::abs(before.distance() - after.distance()) < 1e-9 ? ViewTurn::pan : ViewTurn::zoom;
}

class NavigationPresetTest : public ::testing::TestWithParam<int> {
protected:
    void SetUp() override
    {
        window = shownWindow(answers, "nine-16");
        KNOTSPAN_NEED_RENDERER(*window);
        window->viewport().setNavigation(preset());
    }
    void TearDown() override { QSettings().clear(); }

    [[nodiscard]] const NavigationPreset& preset() const
    {
        return navigationPresets()[static_cast<size_t>(GetParam())];
    }
    std::optional<ViewTurn> drag(Qt::MouseButton button, Qt::KeyboardModifiers keys)
    {
        const Camera before = window->viewport().frame().camera;
        Hand(*window).drag({5, 5}, {25, 45}, button, keys);
        return turnOf(before, window->viewport().frame().camera);
    }

    Answers answers;
    std::unique_ptr<MainWindow> window;
};

TEST_P(NavigationPresetTest, ItsButtonsMoveTheEyeAndNoOthersDo)
{
    for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton})
        for (const Qt::KeyboardModifier key :
             {Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier}) {
            std::optional<ViewTurn> expected = turnBy(preset(), button, key);
            if (!expected && button == Qt::LeftButton && preset().leftOrbits)
                expected = ViewTurn::orbit;
            EXPECT_EQ(drag(button, key), expected) << preset().name << " " << button << " " << key;
        }
    EXPECT_FALSE(window->document().isModified());
}

TEST_P(NavigationPresetTest, OrbitsPansAndZooms)
{
    for (const ViewTurn turn : {ViewTurn::orbit, ViewTurn::pan})
        EXPECT_FALSE(gesturesFor(preset(), turn).isEmpty()) << preset().name;
    const double before = window->viewport().frame().camera.distance();
    Hand(*window).wheel({60, 60}, 2);
    EXPECT_LT(window->viewport().frame().camera.distance(), before);
}

TEST_P(NavigationPresetTest, ALeftDragThatNoToolTakesOrbitsOrSelectsByABox)
{
    ASSERT_TRUE(window->selection().objects().empty());
    const PictureSize size = window->viewport().pictureSize();
    const Camera before = window->viewport().frame().camera;
    Hand hand(*window);
    hand.press({2, 2});
    hand.move({40, 40});
    hand.move(Vec2(size.width - 2, size.height - 2));
    EXPECT_EQ(window->viewport().isDragging(), !preset().leftOrbits);
    hand.release();
    EXPECT_EQ(window->viewport().frame().camera == before, !preset().leftOrbits);
    EXPECT_EQ(window->selection().objects().size(),
              preset().leftOrbits ? 0 : window->document().scene().objects().size());
    // A click on nothing still lets go.
    hand.click({2, 2});
    EXPECT_TRUE(window->selection().objects().empty());
}

TEST_P(NavigationPresetTest, TheStatusLineSaysHow)
{
    const QString hint = window->findChild<QLabel*>("hint")->text();
    const QString gesture =
        preset().leftOrbits ? "Left drag elsewhere" : gesturesFor(preset(), ViewTurn::orbit);
    EXPECT_TRUE(hint.contains(gesture + " turns the view")) << hint.toStdString();
}

INSTANTIATE_TEST_SUITE_P(All, NavigationPresetTest,
                         ::testing::Range(0, static_cast<int>(navigationPresets().size())),
                         [](const auto& instance) {
                             return std::string(
                                 navigationPresets()[static_cast<size_t>(instance.param)].name);
                         });

TEST(NavigationPresets, AreThoseOfTheProgramsThatTheyAreNamedFor)
{
    const auto turn = [](const char* name, Qt::MouseButton button, Qt::KeyboardModifiers keys) {
        return turnBy(findNavigation(name), button, keys);
    };
    EXPECT_EQ(turn("rhino", Qt::RightButton, {}), ViewTurn::orbit);
    EXPECT_EQ(turn("rhino", Qt::RightButton, Qt::ShiftModifier), ViewTurn::pan);
    EXPECT_EQ(turn("rhino", Qt::RightButton, Qt::ControlModifier), ViewTurn::zoom);
    EXPECT_EQ(turn("blender", Qt::MiddleButton, {}), ViewTurn::orbit);
    EXPECT_EQ(turn("blender", Qt::MiddleButton, Qt::ShiftModifier), ViewTurn::pan);
    EXPECT_EQ(turn("blender", Qt::MiddleButton, Qt::ControlModifier), ViewTurn::zoom);
    EXPECT_EQ(turn("maya", Qt::LeftButton, Qt::AltModifier), ViewTurn::orbit);
    EXPECT_EQ(turn("maya", Qt::MiddleButton, Qt::AltModifier), ViewTurn::pan);
    EXPECT_EQ(turn("maya", Qt::RightButton, Qt::AltModifier), ViewTurn::zoom);
    EXPECT_EQ(turn("plain", Qt::LeftButton, Qt::AltModifier), ViewTurn::orbit);
    EXPECT_EQ(turn("plain", Qt::RightButton, {}), ViewTurn::pan);
    for (const char* name : {"rhino", "blender", "maya"})
        EXPECT_EQ(turn(name, Qt::LeftButton, {}), std::nullopt);
    EXPECT_STREQ(findNavigation("of another version").name, "plain");
}

}  // namespace
}  // namespace knotspan
