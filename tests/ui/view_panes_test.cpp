#include "ui/viewport/view_panes.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <QAction>

#include <glm/geometric.hpp>

#include "tests/ui/window_harness.h"
#include "ui/viewport/stroke_text.h"
#include "ui/viewport/view_cube.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

Camera from(const Vec3& way)
{
    Camera camera;
    camera.target = {1, 2, 3};
    return lookedFrom(way, camera);
}

TEST(ViewPanes, AreOfOneSizeApartAndInsideThePicture)
{
    for (const PaneLayout layout : {PaneLayout::one, PaneLayout::two, PaneLayout::four})
        for (const auto& [width, height] :
             {std::pair(801, 603), std::pair(800, 600), std::pair(3, 2), std::pair(1, 1)}) {
            ViewPanes panes;
            panes.setLayout(layout, {});
            const std::vector<PaneRect> rects = panes.rects(width, height);
            ASSERT_EQ(rects.size(), panes.count());
            for (size_t k = 0; k < rects.size(); ++k) {
                EXPECT_EQ(rects[k].width, rects[0].width);
                EXPECT_EQ(rects[k].height, rects[0].height);
                EXPECT_GE(rects[k].width, 1);
                if (width < 100)
                    continue;
                EXPECT_LE(rects[k].x + rects[k].width, width);
                EXPECT_LE(rects[k].y + rects[k].height, height);
                EXPECT_EQ(panes.at(Vec2(rects[k].x, rects[k].y), width, height), k);
                EXPECT_EQ(panes.at(Vec2(rects[k].x + rects[k].width - 1, rects[k].y + rects[k].height - 1),
                                   width, height),
                          k);
            }
        }
    ViewPanes panes;
    panes.setLayout(PaneLayout::two, {});
    EXPECT_EQ(panes.at(Vec2(400, 10), 802, 600), std::nullopt) << "on the line between them";
    EXPECT_EQ(panes.at(Vec2(-1, 10), 802, 600), std::nullopt);
}

TEST(ViewPanes, KeepEachItsCamera)
{
    ViewPanes panes;
    panes.setLayout(PaneLayout::four, from({1, 0, 0}));
    EXPECT_EQ(panes.current(), 1U);
    EXPECT_TRUE(panes.isFresh(0));
    panes.setCamera(0, from({0, 0, 1}));
    EXPECT_FALSE(panes.isFresh(0));
    EXPECT_EQ(panes.makeCurrent(0, from({0, 1, 0})), from({0, 0, 1}));
    EXPECT_EQ(panes.makeCurrent(1, from({0, 0, 1})), from({0, 1, 0}));
    EXPECT_TRUE(panes.isFresh(3));
    panes.forgetCameras();
    EXPECT_TRUE(panes.isFresh(0));
}

TEST(ViewPanes, ComeBackAsTheyWereWhenOneOfThemWasShownAlone)
{
    ViewPanes panes;
    panes.setLayout(PaneLayout::four, from({1, 1, 1}));
    for (const size_t pane : {0, 2, 3})
        panes.setCamera(pane, from({0, double(pane), 1}));
    (void)panes.makeCurrent(3, from({1, 1, 1}));
    panes.setLayout(PaneLayout::one, from({0, 3, 1}));
    EXPECT_EQ(panes.count(), 1U);
    panes.setLayout(PaneLayout::four, from({-1, 0, 0}));
    EXPECT_EQ(panes.current(), 3U);
    EXPECT_EQ(panes.camera(1), from({1, 1, 1}));
    EXPECT_EQ(panes.camera(2), from({0, 2, 1}));
    EXPECT_EQ(panes.camera(3), from({-1, 0, 0}));
}

TEST(ViewPanes, AreNamedByWhereTheyLookFrom)
{
    EXPECT_EQ(viewTitle(from({0, 0, 1})), "TOP");
    EXPECT_EQ(viewTitle(from({0, 0, -1})), "BOTTOM");
    EXPECT_EQ(viewTitle(from({0, -1, 0})), "FRONT");
    EXPECT_EQ(viewTitle(from({-1, 0, 0})), "LEFT");
    Camera camera = from({1, 1, 0});
    EXPECT_EQ(viewTitle(camera), "PERSPECTIVE");
    camera.orthographic = true;
    EXPECT_EQ(viewTitle(camera), "PARALLEL");
    for (const std::string& name : namedViews())
        if (name != "iso") {
            std::string title(viewTitle(*namedView(name, {}, 1, false)));
            std::transform(title.begin(), title.end(), title.begin(),
                           [](char c) { return static_cast<char>(std::tolower(c)); });
            EXPECT_EQ(title, name);
        }
}

TEST(ViewCube, EachOfItsPartsIsUnderSomePixelAndLooksFromThere)
{
    Camera iso = *namedView("iso", {}, 1, false);
    const CubePicture picture{iso, 400, 300, 1};
    std::set<std::array<int, 3>> found;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 400; ++x)
            if (const auto part = cubePartAt(Vec2(x + 0.5, y + 0.5), picture)) {
                EXPECT_GT(x, 260);
                EXPECT_LT(y, 140);
                found.insert({int(part->x), int(part->y), int(part->z)});
                const Camera there = lookedFrom(*part, iso);
                EXPECT_NEAR(glm::dot(there.forward(), glm::normalize(*part)), -1, 1e-12);
                EXPECT_NEAR(there.distance(), iso.distance(), 1e-9 * iso.distance());
                EXPECT_EQ(there.target, iso.target);
            }
    // Of a cube seen from a corner: three faces, nine edges, seven corners.
    EXPECT_EQ(found.size(), 19U);
    EXPECT_FALSE(cubePartAt({390, 290}, picture).has_value());
}

TEST(ViewCube, IsDrawnWhereItIsHitAndNotInSmallViews)
{
    const Camera front = *namedView("front", {}, 1, false);
    Overlays overlays;
    addViewCube(overlays, {front, 400, 300, 1}, CubePart(0, -1, 0));
    ASSERT_EQ(overlays.patches.size(), 2U) << "one face, and the lit middle of it";
    const Vec2 middle = 0.5 * (overlays.patches[0].corners[0] + overlays.patches[0].corners[2]);
    EXPECT_EQ(cubePartAt(middle, {front, 400, 300, 1}), CubePart(0, -1, 0));
    EXPECT_EQ(cubePartAt(overlays.patches[0].corners[0] + Vec2(1, -1), {front, 400, 300, 1}),
              CubePart(-1, -1, -1));
    Overlays none;
    addViewCube(none, {front, 400, 200, 1}, {});
    EXPECT_TRUE(none.patches.empty() && none.strokes.empty());
    EXPECT_FALSE(cubePartAt(middle, {front, 400, 200, 1}).has_value());
}

TEST(StrokeText, IsAsWideAsItSaysAndKnowsEveryLetter)
{
    for (const char character : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-+./:")) {
        std::vector<Stroke> strokes;
        addStrokeText(strokes, std::string(1, character), {.corner = {10, 20}}, {.height = 12, .width = 1});
        EXPECT_FALSE(strokes.empty()) << character;
        for (const Stroke& stroke : strokes)
            for (const Vec2& end : {stroke.from, stroke.to}) {
                EXPECT_GE(end.x, 9.4) << character;
                EXPECT_LE(end.x, 10.6 + strokeTextWidth("A", 12)) << character;
                EXPECT_GE(end.y, 19.4) << character;
                EXPECT_LE(end.y, 32.6) << character;
            }
    }
    EXPECT_EQ(strokeTextWidth("", 12), 0);
    EXPECT_GT(strokeTextWidth("AB", 12), 2 * strokeTextWidth("A", 12));
}

class FourViews : public ::testing::Test {
protected:
    void SetUp() override
    {
        window = shownWindow(answers, "single-100");
        if (window->viewport().renderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        action("view.fourPanes").trigger();
        ASSERT_TRUE(settle(*window));
    }
    void TearDown() override { window->close(); }

    QAction& action(const char* id) { return *window->findChild<QAction*>(id); }
    // Of the pane in column and row 0 or 1, in pixels of the whole picture.
    [[nodiscard]] Vec2 middleOf(int column, int row)
    {
        const PictureSize size = window->viewport().pictureSize();
        return {(column + 0.5) * (size.width + 2), (row + 0.5) * (size.height + 2)};
    }

    Answers answers;
    std::unique_ptr<MainWindow> window;
};

TEST_F(FourViews, ShowTheModelFromFourSides)
{
    const QImage all = picture(*window);
    const PictureSize size = window->viewport().pictureSize();
    EXPECT_EQ(all.width() / 2, size.width + 1 - all.width() % 2);
    for (const int column : {0, 1})
        for (const int row : {0, 1}) {
            const Vec2 middle = middleOf(column, row);
            EXPECT_NE(all.pixelColor(int(middle.x), int(middle.y)).rgb() & 0xffffff, 0x2b2e34U);
        }
    EXPECT_EQ(viewTitle(window->viewport().frame().camera), "PERSPECTIVE");
    action("view.onePane").trigger();
    ASSERT_TRUE(settle(*window));
    EXPECT_EQ(window->viewport().pictureSize().width, all.width());
}

TEST_F(FourViews, AClickWorksInItsOwnView)
{
    Hand hand(*window);
    hand.click(middleOf(0, 0));
    ASSERT_TRUE(settle(*window));
    EXPECT_EQ(viewTitle(window->viewport().frame().camera), "TOP");
    EXPECT_TRUE(window->viewport().frame().camera.orthographic);
    EXPECT_EQ(window->selection().objects().size(), 1U) << "the same click takes what is there";
    action("view.right").trigger();
    ASSERT_TRUE(settle(*window));
    hand.wheel(middleOf(1, 0), 1);
    ASSERT_TRUE(settle(*window));
    EXPECT_EQ(viewTitle(window->viewport().frame().camera), "PERSPECTIVE");
    hand.click(middleOf(0, 0));
    EXPECT_EQ(viewTitle(window->viewport().frame().camera), "RIGHT") << "it kept what it was turned to";
}

TEST_F(FourViews, ADragInOneMovesThePointInAll)
{
    Hand hand(*window);
    hand.click(middleOf(0, 0));
    ASSERT_TRUE(settle(*window));
    const auto point = visiblePoint(*window, *window->selection().objects().begin());
    ASSERT_TRUE(point.has_value());
    const Vec3 before = positionOf(*window, *point);
    const QImage old = picture(*window);
    hand.drag(point->pixel + window->viewport().pictureCorner(), point->pixel + Vec2(25, 0));
    ASSERT_TRUE(settle(*window));
    const Vec3 moved = positionOf(*window, *point) - before;
    EXPECT_GT(glm::length(moved), 0);
    EXPECT_NEAR(moved.z, 0, 1e-9) << "dragged as seen from above";
    const QImage now = picture(*window);
    const PictureSize size = window->viewport().pictureSize();
    for (const int column : {0, 1})
        for (const int row : {0, 1}) {
            const QRect pane(column * (size.width + 2), row * (size.height + 2), size.width, size.height);
            EXPECT_GT(differingPixels(old.copy(pane), now.copy(pane)), 20) << column << row;
        }
}

TEST_F(FourViews, OnlyTheTurnedOneChanges)
{
    const QImage old = picture(*window);
    const PictureSize size = window->viewport().pictureSize();
    Hand hand(*window);
    hand.drag(middleOf(1, 0) + Vec2(0, 20), middleOf(1, 0) + Vec2(40, 20), Qt::MiddleButton,
              Qt::ShiftModifier);
    ASSERT_TRUE(settle(*window));
    const QImage now = picture(*window);
    const QRect turned(size.width + 2, 0, size.width, size.height);
    EXPECT_GT(differingPixels(old.copy(turned), now.copy(turned)), 100);
    const QRect below(0, size.height + 2, 2 * size.width + 2, size.height);
    EXPECT_EQ(differingPixels(old.copy(below), now.copy(below)), 0);
}

TEST(ViewCubeInTheWindow, AClickLooksFromItsFaceAndADragTurns)
{
    Answers answers;
    const auto window = shownWindow(answers, "single-100");
    KNOTSPAN_NEED_RENDERER(*window);
    window->selection().clear();
    window->resize(1100, 640);
    ASSERT_TRUE(settle(*window));
    Viewport& viewport = window->viewport();
    const PictureSize size = viewport.pictureSize();
    const auto pixelOf = [&](const CubePart& part) -> std::optional<Vec2> {
        for (int y = 0; y < 130; ++y)
            for (int x = size.width - 130; x < size.width; ++x)
                if (cubePartAt(Vec2(x, y), {viewport.frame().camera, size.width, size.height, 1}) == part)
                    return Vec2(x, y) + Vec2(2, 2);
        return std::nullopt;
    };
    Hand hand(*window);
    const auto top = pixelOf({0, 0, 1});
    ASSERT_TRUE(top.has_value());
    const QImage plain = picture(*window);
    hand.hover(*top);
    ASSERT_TRUE(settle(*window));
    EXPECT_GT(differingPixels(plain, picture(*window)), 50) << "lit";
    hand.click(*top);
    ASSERT_TRUE(settle(*window));
    EXPECT_EQ(viewTitle(viewport.frame().camera), "TOP");
    EXPECT_TRUE(window->selection().objects().empty());
    const Camera camera = viewport.frame().camera;
    hand.drag(*top, *top + Vec2(-30, 20));
    ASSERT_TRUE(settle(*window));
    EXPECT_NE(viewport.frame().camera, camera);
    EXPECT_EQ(viewport.frame().camera.target, camera.target);
    window->findChild<QAction*>("view.cube")->trigger();
    ASSERT_TRUE(settle(*window));
    EXPECT_FALSE(viewport.showsCube());
    window->findChild<QAction*>("view.cube")->trigger();
}

}  // namespace
}  // namespace knotspan
