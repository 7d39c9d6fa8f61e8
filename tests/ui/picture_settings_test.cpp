// What the picture was told is told to the next session's, but for what belongs to one model.
#include <gtest/gtest.h>

#include <QSettings>

#include "model/document/document.h"
#include "ui/picture_settings_store.h"

namespace knotspan {
namespace {

class PictureSettingsTest : public ::testing::Test {
protected:
    void SetUp() override { QSettings().clear(); }
    void TearDown() override { QSettings().clear(); }

    Document document_;
    Selection selection_;
    Viewport viewport_{document_, selection_};
    Viewport next_{document_, selection_};
};

TEST_F(PictureSettingsTest, ComeBackInTheNextSession)
{
    Frame frame = viewport_.frame();
    frame.look.stripes = 31;
    frame.look.stripesTurnedDegrees = 45;
    frame.look.matcap = Matcap::pearl;
    frame.look.curvature = CurvatureKind::largest;
    frame.look.curvatureRange = NumberRange{-0.25, 0.5};
    frame.look.deviationRange = NumberRange{0, 0.125};
    frame.look.checker = CheckerBy::length;
    frame.look.checkerCells = 9;
    frame.look.checkerLength = 2.5;
    frame.look.pull = Vec3(0, -1, 0);
    frame.look.draftDegrees = 3;
    frame.tolerancePx = 0.25;
    frame.culling = *parseCullSet("none");
    frame.shading = Shading::draft;
    viewport_.setFrame(frame);
    viewport_.combs().setSettings({true, 7, 12});
    viewport_.section().setSettings({true, 0, 33});
    storePicture(viewport_);
    restorePicture(next_);
    EXPECT_EQ(next_.frame().look, frame.look);
    EXPECT_EQ(next_.frame().tolerancePx, 0.25);
    EXPECT_EQ(next_.frame().culling, frame.culling);
    EXPECT_EQ(next_.frame().shading, Shading::shaded);
    EXPECT_EQ(next_.combs().settings(), (CombSettings{false, 7, 12}));
    EXPECT_EQ(next_.section().settings().axis, 0);
    EXPECT_FALSE(next_.section().settings().shown);
    EXPECT_NE(next_.section().settings().offset, 33);
}

TEST_F(PictureSettingsTest, ARangeThatIsNoLongerSetIsForgotten)
{
    Frame frame = viewport_.frame();
    frame.look.curvatureRange = NumberRange{1, 2};
    viewport_.setFrame(frame);
    storePicture(viewport_);
    viewport_.setFrame(next_.frame());
    storePicture(viewport_);
    restorePicture(next_);
    EXPECT_FALSE(next_.frame().look.curvatureRange);
}

TEST_F(PictureSettingsTest, NonsenseIsPassedOver)
{
    const Frame usual = next_.frame();
    QSettings stored;
    for (const char* key :
         {"look/stripes", "look/matcap", "look/curvature", "look/curvatureRange/low", "look/pull/0",
          "look/draft", "tolerance", "culling", "combs/curves", "section/axis"})
        stored.setValue(key, "banana");
    stored.setValue("look/squares", -3);
    stored.setValue("look/pull/1", "nan");
    stored.setValue("combs/longest", 1e99);
    restorePicture(next_);
    EXPECT_EQ(next_.frame(), usual);
    EXPECT_EQ(next_.combs().settings(), CombSettings{});
    EXPECT_EQ(next_.section().settings(), SectionSettings{});
}

}  // namespace
}  // namespace knotspan
