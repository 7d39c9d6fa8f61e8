#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSpinBox>

#include "tests/ui/window_harness.h"
#include "ui/panels/look_form.h"
#include "ui/panels/ramp_legend.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class LookForms : public ::testing::Test {
protected:
    void shade(Viewport& viewport, Shading shading)
    {
        Frame frame = viewport.frame();
        frame.shading = shading;
        viewport.setFrame(frame);
    }
    template <class Widget>
    [[nodiscard]] static Widget& child(QWidget& parent, const char* name)
    {
        return *parent.findChild<Widget*>(name);
    }

    Document document_;
    Selection selection_;
    Viewport viewport_{document_, selection_};
    LookForm form_{viewport_};
};

TEST_F(LookForms, ShowWhatTheShadingReadsAndNothingElse)
{
    const std::map<Shading, std::string> readers = {
        {Shading::zebra, "look-stripes"},     {Shading::reflection, "look-stripes"},
        {Shading::isophotes, "look-stripes"}, {Shading::matcap, "look-matcap"},
        {Shading::curvature, "look-low"},     {Shading::draft, "look-draft"},
        {Shading::checker, "look-squares"},   {Shading::deviation, "ramp-legend"}};
    for (const ShadingInfo& info : shadings()) {
        shade(viewport_, info.id);
        const auto reader = readers.find(info.id);
        EXPECT_EQ(form_.isHidden(), reader == readers.end()) << info.name;
        for (const char* name : {"look-stripes", "look-matcap", "look-low", "look-draft", "look-squares"})
            EXPECT_EQ(child<QWidget>(form_, name).isVisibleTo(&form_),
                      reader != readers.end() && reader->second == name)
                << info.name << ", " << name;
    }
}

TEST_F(LookForms, TellTheFrame)
{
    shade(viewport_, Shading::zebra);
    child<QSpinBox>(form_, "look-stripes").setValue(31);
    child<QSpinBox>(form_, "look-stripe-angle").setValue(45);
    EXPECT_EQ(viewport_.frame().look.stripes, 31);
    EXPECT_EQ(viewport_.frame().look.stripesTurnedDegrees, 45);
    shade(viewport_, Shading::draft);
    auto& pull = child<QComboBox>(form_, "look-pull");
    pull.setCurrentText("-y");
    Q_EMIT pull.activated(pull.currentIndex());
    child<QDoubleSpinBox>(form_, "look-draft").setValue(2.5);
    EXPECT_EQ(viewport_.frame().look.pull, Vec3(0, -1, 0));
    EXPECT_EQ(viewport_.frame().look.draftDegrees, 2.5);
    shade(viewport_, Shading::checker);
    child<QSpinBox>(form_, "look-squares").setValue(7);
    EXPECT_EQ(viewport_.frame().look.checkerCells, 7);
}

TEST_F(LookForms, TakeARangeOnlyWhereItIsOne)
{
    shade(viewport_, Shading::curvature);
    EXPECT_FALSE(viewport_.frame().look.curvatureRange);
    auto& low = child<QDoubleSpinBox>(form_, "look-low");
    auto& high = child<QDoubleSpinBox>(form_, "look-high");
    EXPECT_FALSE(low.isEnabled());
    child<QCheckBox>(form_, "look-automatic").setChecked(false);
    high.setValue(0.5);
    low.setValue(-0.25);
    EXPECT_EQ(viewport_.frame().look.curvatureRange, (NumberRange{-0.25, 0.5}));
    EXPECT_TRUE(low.isEnabled());
    low.setValue(0.75);
    EXPECT_EQ(viewport_.frame().look.curvatureRange, (NumberRange{-0.25, 0.5}));
    child<QCheckBox>(form_, "look-automatic").setChecked(true);
    EXPECT_FALSE(viewport_.frame().look.curvatureRange);
}

TEST(LookInTheWindow, TheLegendSaysWhatThePictureShows)
{
    Answers answers;
    const auto window = shownWindow(answers, "sphere");
    KNOTSPAN_NEED_RENDERER(*window);
    Frame frame = window->viewport().frame();
    frame.shading = Shading::curvature;
    frame.look.curvature = CurvatureKind::gauss;
    window->viewport().setFrame(frame);
    ASSERT_TRUE(settle(*window));
    auto* legend = window->findChild<RampLegend*>();
    ASSERT_NE(legend, nullptr);
    EXPECT_FALSE(legend->isHidden());
    EXPECT_EQ(legend->accessibleDescription(),
              "Blue is -1 or less, pale 0, orange 1 or more");  // of radius 1
    frame.look.curvatureRange = NumberRange{2, 4};
    window->viewport().setFrame(frame);
    ASSERT_TRUE(settle(*window));
    EXPECT_EQ(legend->accessibleDescription(), "Blue is 2 or less, pale 3, orange 4 or more");
    const QColor middle =
        picture(*window).pixelColor(picture(*window).width() / 2, picture(*window).height() / 2);
    const Vec3 blue = colourOnRamp(0);
    EXPECT_NEAR(middle.redF(), blue.x, 0.01);
    EXPECT_NEAR(middle.blueF(), blue.z, 0.01);
}

}  // namespace
}  // namespace knotspan
