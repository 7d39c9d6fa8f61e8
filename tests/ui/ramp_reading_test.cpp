// The number under the pointer is that of the colour there, and reading it draws no picture.
#include <QLabel>

#include "model/geometry/primitives.h"
#include "tests/ui/one_surface_test.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class RampReadingTest : public OneSurfaceTest {
protected:
    void SetUp() override
    {
        OneSurfaceTest::SetUp();
        if (IsSkipped())
            return;
        Scene model;
        ball = model.add({.name = "ball", .surface = sphere({0, 0, 0}, 2)});
        model.add({.name = "far", .surface = sphere({0, 0, 0}, 1.5)});
        window->document().reset(model, "Balls");
        window->viewport().look("front");
        window->selection().clear();
        settle(*window);
    }
    void shade(Shading shading)
    {
        Frame frame = window->viewport().frame();
        frame.shading = shading;
        window->viewport().setFrame(frame);
        settle(*window);
    }
    [[nodiscard]] QString reading()
    {
        const auto* label = window->findChild<QLabel*>("ramp-reading");
        return label->isHidden() ? QString() : label->text();
    }
    [[nodiscard]] Vec2 middle() const
    {
        const PictureSize size = window->viewport().pictureSize();
        return {size.width / 2, size.height / 2};
    }

    ObjectId ball{};
};

TEST_F(RampReadingTest, SaysTheCurvatureOfABallAndNothingBesideIt)
{
    shade(Shading::curvature);
    Hand hand(*window);
    hand.move(middle());
    settle(*window);
    EXPECT_TRUE(reading().startsWith("Curvature ")) << reading().toStdString();
    EXPECT_NEAR(std::abs(reading().split(' ').at(1).toDouble()), 0.5, 1e-6);
    EXPECT_TRUE(reading().endsWith(" /mm"));
    Frame frame = window->viewport().frame();
    frame.look.curvature = CurvatureKind::gauss;
    window->viewport().setFrame(frame);
    settle(*window);
    EXPECT_EQ(reading(), "Curvature 0.25 /mm²") << "without the pointer moving";
    hand.move({2, 2});
    settle(*window);
    EXPECT_EQ(reading(), "");
}

TEST_F(RampReadingTest, SaysTheDraftAndHowFarTheBallIs)
{
    Hand hand(*window);
    shade(Shading::draft);
    hand.move(middle());
    settle(*window);
    ASSERT_TRUE(reading().startsWith("Draft ")) << reading().toStdString();
    EXPECT_NEAR(reading().mid(6).chopped(1).toDouble(), 0, 2) << "seen from the front";
    window->viewport().deviation().setSettings({{ball}, {}});
    shade(Shading::deviation);
    while (window->viewport().deviation().isMeasuring())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 1000);
    settle(*window);
    ASSERT_TRUE(reading().startsWith("Deviation ")) << reading().toStdString();
    EXPECT_NEAR(reading().split(' ').at(1).toDouble(), 0.5, 0.01);
    shade(Shading::shaded);
    EXPECT_EQ(reading(), "");
}

TEST_F(RampReadingTest, DrawsNoPicture)
{
    shade(Shading::curvature);
    Hand hand(*window);
    hand.move(middle());
    settle(*window);
    int drawn = 0;
    QObject::connect(&window->viewport(), &Viewport::frameDrawn, window.get(), [&] { ++drawn; });
    QString before = reading();
    ASSERT_NE(before, "");
    for (int step = 1; step < 10; ++step)
        hand.move(middle() + Vec2(step, step));
    settle(*window);
    EXPECT_EQ(drawn, 0);
}

}  // namespace
}  // namespace knotspan
