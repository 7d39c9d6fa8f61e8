#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListView>
#include <QRegularExpression>
#include <QSlider>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QToolButton>

#include "tests/ui/window_harness.h"
#include "ui/panels/rendering_panel.h"
#include "ui/panels/stats_panel.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

QToolButton* buttonNamed(const QWidget& parent, const QString& text)
{
    for (auto* button : parent.findChildren<QToolButton*>())
        if (button->text() == text)
            return button;
    return nullptr;
}

void usePath(Viewport& viewport, PathId path)
{
    Frame frame = viewport.frame();
    frame.path = path;
    viewport.setFrame(frame);
}

TEST(RenderingPanel, ShowsEveryPathCullingModeShadingAndEvaluator)
{
    Document document;
    Selection selection;
    Viewport viewport(document, selection);
    const RenderingPanel panel(viewport);
    EXPECT_EQ(panel.findChild<QComboBox*>("path")->count(), static_cast<int>(paths().size()));
    EXPECT_EQ(panel.findChild<QComboBox*>("shading")->count(), static_cast<int>(shadings().size()));
    auto* evaluator = panel.findChild<QComboBox*>("evaluator");
    ASSERT_EQ(evaluator->count(), static_cast<int>(evaluators().size()));
    EXPECT_EQ(evaluator->currentText().toStdString(), "auto");
    evaluator->setCurrentText("stair");
    Q_EMIT evaluator->activated(evaluator->currentIndex());
    EXPECT_EQ(viewport.frame().evaluator, Evaluator::stair);
    EXPECT_EQ(panel.findChildren<QCheckBox*>(QRegularExpression("^culling-")).size(), kCullModeCount);
    for (const CullMode& mode : cullModes()) {
        const auto* check = panel.findChild<QCheckBox*>("culling-" + QString::fromStdString(mode.name));
        ASSERT_NE(check, nullptr) << mode.name;
        EXPECT_EQ(check->toolTip().toStdString(), mode.description);
    }
    auto* counting = panel.findChild<QCheckBox*>("count-wrong");
    ASSERT_NE(counting, nullptr);
    EXPECT_FALSE(viewport.frame().countWrongCulls);
    counting->click();
    EXPECT_TRUE(viewport.frame().countWrongCulls);
}

TEST(RenderingPanel, APathThatTheDeviceCannotRunIsGreyedWithTheReason)
{
    Document document;
    Selection selection;
    Viewport viewport(document, selection);
    const RenderingPanel panel(viewport);
    const auto* items = qobject_cast<QStandardItemModel*>(panel.findChild<QComboBox*>("path")->model());
    int row = 0;
    for (const PathInfo& info : paths()) {
        const Renderer* renderer = viewport.renderer();
        const std::string why = renderer != nullptr ? renderer->whyUnavailable(info.id) : "";
        EXPECT_EQ(items->item(row)->isEnabled(), renderer != nullptr && why.empty()) << info.name;
        EXPECT_EQ(items->item(row)->toolTip().toStdString(), why.empty() ? info.description : why);
        ++row;
    }
}

TEST(RenderingPanel, ToleranceIsGreyedWithTheReasonWhereThePathDoesNotFollowIt)
{
    Document document;
    Selection selection;
    Viewport viewport(document, selection);
    const RenderingPanel panel(viewport);
    std::vector<QWidget*> controls = {panel.findChild<QSlider*>("tolerance-slider"),
                                      panel.findChild<QDoubleSpinBox*>("tolerance")};
    for (const char* preset : {"Draft", "Balanced", "Exact"})
        controls.push_back(buttonNamed(panel, preset));
    for (const PathId path : {PathId::tessellation, PathId::mesh9x9, PathId::tessellation}) {
        usePath(viewport, path);
        const bool follows = path == PathId::tessellation;
        for (const QWidget* control : controls) {
            EXPECT_EQ(control->isEnabled(), follows);
            EXPECT_FALSE(control->toolTip().isEmpty());
            EXPECT_EQ(control->toolTip().contains("mesh-9x9"), !follows) << control->toolTip().toStdString();
            EXPECT_EQ(control->toolTip().contains("9 by 9"), !follows) << control->toolTip().toStdString();
        }
        EXPECT_EQ(controls.back()->toolTip().startsWith("A quarter"), follows);
    }
    if (viewport.renderer() == nullptr)
        GTEST_SKIP() << "no Vulkan device here";
    usePath(viewport, PathId::mesh9x9);
    const PathInfo& best = pathInfo(viewport.renderer()->bestPath());
    ASSERT_TRUE(best.followsTolerance);
    EXPECT_TRUE(controls.front()->toolTip().contains("Choose the path " + QString::fromStdString(best.name)));
}

// Rules that the path cannot follow are greyed, and another path takes its own rule instead of one that it
// cannot.
TEST(RenderingPanel, OffersTheSamplingRulesThatThePathCanFollow)
{
    Document document;
    Selection selection;
    Viewport viewport(document, selection);
    const RenderingPanel panel(viewport);
    auto* sampling = panel.findChild<QComboBox*>("sampling");
    auto* cells = panel.findChild<QSpinBox*>("sampling-cells");
    const auto* items = qobject_cast<QStandardItemModel*>(sampling->model());
    const auto choose = [&](const char* name) {
        sampling->setCurrentText(name);
        Q_EMIT sampling->activated(sampling->currentIndex());
    };
    usePath(viewport, PathId::tessellation);
    EXPECT_TRUE(items->item(sampling->findText("bound"))->isEnabled());
    EXPECT_FALSE(cells->isEnabled());
    choose("fixed");
    cells->setValue(5);
    EXPECT_EQ(name(viewport.frame().sampling), "fixed:5");
    choose("bound");
    EXPECT_EQ(name(viewport.frame().sampling), "bound");
    auto* path = panel.findChild<QComboBox*>("path");
    path->setCurrentText("surface");
    Q_EMIT path->activated(path->currentIndex());
    EXPECT_EQ(viewport.frame().sampling, SamplingRule{});
    EXPECT_FALSE(items->item(sampling->findText("bound"))->isEnabled());
}

TEST(RenderingPanel, SliderBoxAndPresetsShowOneTolerance)
{
    Document document;
    Selection selection;
    Viewport viewport(document, selection);
    usePath(viewport, PathId::tessellation);
    const RenderingPanel panel(viewport);
    auto* slider = panel.findChild<QSlider*>("tolerance-slider");
    auto* box = panel.findChild<QDoubleSpinBox*>("tolerance");
    EXPECT_DOUBLE_EQ(box->value(), viewport.frame().tolerancePx);
    slider->setValue(slider->minimum());
    EXPECT_DOUBLE_EQ(viewport.frame().tolerancePx, 4);
    EXPECT_DOUBLE_EQ(box->value(), 4);
    EXPECT_TRUE(buttonNamed(panel, "Draft")->isChecked());
    buttonNamed(panel, "Exact")->click();
    EXPECT_DOUBLE_EQ(viewport.frame().tolerancePx, 0.25);
    EXPECT_EQ(slider->value(), slider->maximum());
    EXPECT_FALSE(buttonNamed(panel, "Draft")->isChecked());
    box->setValue(1);
    EXPECT_DOUBLE_EQ(viewport.frame().tolerancePx, 1);
    EXPECT_TRUE(buttonNamed(panel, "Balanced")->isChecked());
    EXPECT_EQ(slider->value(), (slider->minimum() + slider->maximum()) / 2);
}

TEST(StatsPanel, HasARowForEveryField)
{
    StatsPanel panel;
    FrameStats stats;
    stats.device = "a device";
    stats.triangles = 12345;
    panel.setStats(stats);
    ASSERT_EQ(panel.topLevelItemCount(), static_cast<int>(statFields().size()));
    for (const StatField& field : statFields())
        EXPECT_EQ(panel.shown(field.name).toStdString(), display(field, stats)) << field.name;
    EXPECT_EQ(panel.shown("device"), "a device");
}

TEST(ObjectsPanel, HidingAnObjectTakesItOutOfThePicture)
{
    Answers answers;
    const auto window = shownWindow(answers, "single-100");
    KNOTSPAN_NEED_RENDERER(*window);
    const QImage shown = picture(*window);
    auto* list = window->findChild<QListView*>("objects");
    list->setCurrentIndex(list->model()->index(0, 0));
    EXPECT_EQ(window->selection().objects().size(), 1U);
    ASSERT_TRUE(list->model()->setData(list->model()->index(0, 0), Qt::Unchecked, Qt::CheckStateRole));
    settle(*window);
    const QImage hidden = picture(*window);
    EXPECT_GT(differingPixels(shown, hidden), shown.width() * shown.height() / 50);
    window->document().reset(Scene(), "empty");
    settle(*window);
    EXPECT_EQ(differingPixels(picture(*window), hidden), 0);
}

}  // namespace
}  // namespace knotspan
