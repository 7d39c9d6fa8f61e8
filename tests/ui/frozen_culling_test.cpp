// View > Freeze culling.
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>

#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/panels/rendering_panel.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

TEST(FreezeCulling, TakesTheCameraOfTheMomentAndLetsItGo)
{
    Answers answers;
    MainWindow window(answering(answers));
    QAction* action = window.action("view.freezeCulling");
    ASSERT_NE(action, nullptr);
    EXPECT_FALSE(action->isChecked());
    const Camera eye = window.viewport().frame().camera;
    action->trigger();
    EXPECT_TRUE(action->isChecked());
    ASSERT_TRUE(window.viewport().frame().cullingCamera.has_value());
    window.viewport().look("back");
    EXPECT_EQ(*window.viewport().frame().cullingCamera, eye);
    EXPECT_FALSE(window.viewport().frame().camera == eye);
    action->trigger();
    EXPECT_FALSE(window.viewport().frame().cullingCamera.has_value());
}

// Another model is another place to stand in.
TEST(FreezeCulling, EndsWithTheDocument)
{
    Answers answers;
    MainWindow window(answering(answers));
    window.action("view.freezeCulling")->trigger();
    window.files().openSample("sphere");
    EXPECT_FALSE(window.viewport().frame().cullingCamera.has_value());
    EXPECT_FALSE(window.action("view.freezeCulling")->isChecked());
}

TEST(FreezeCulling, KeepsWhatIsDrawnWhileTheViewTurnsAndOutlinesTheRest)
{
    Answers answers;
    const auto window = shownWindow(answers, "torus");
    KNOTSPAN_NEED_RENDERER(*window);
    window->action("view.front")->trigger();
    settle(*window);
    EXPECT_FALSE(statsOf(*window).shown("culling").contains("frozen"));
    window->action("view.freezeCulling")->trigger();
    settle(*window);
    EXPECT_TRUE(statsOf(*window).shown("culling").contains("frozen"));
    const QString drawn = statsOf(*window).shown("ksquads_drawn");
    EXPECT_NE(drawn, statsOf(*window).shown("ksquads"));
    Hand hand(*window);
    hand.drag({5, 5}, {200, 40});
    settle(*window);
    EXPECT_EQ(statsOf(*window).shown("ksquads_drawn"), drawn);
    const QImage frozen = picture(*window);
    window->action("view.freezeCulling")->trigger();
    settle(*window);
    EXPECT_GT(differingPixels(picture(*window), frozen), frozen.width() * frozen.height() / 100);
    EXPECT_FALSE(statsOf(*window).shown("culling").contains("frozen"));
}

TEST(RenderingPanel, ShowsTheColourThatAModeIsOutlinedIn)
{
    Document document;
    Selection selection;
    Viewport viewport(document, selection);
    const RenderingPanel panel(viewport);
    for (const CullMode& mode : cullModes()) {
        const auto* check = panel.findChild<QCheckBox*>("culling-" + QString::fromStdString(mode.name));
        ASSERT_NE(check, nullptr) << mode.name;
        const QImage swatch = check->icon().pixmap(check->iconSize()).toImage();
        ASSERT_FALSE(swatch.isNull()) << mode.name;
        EXPECT_EQ(swatch.pixelColor(swatch.rect().center()).rgb(), QRgb(0xff000000U | mode.colour))
            << mode.name;
    }
}

}  // namespace
}  // namespace knotspan
