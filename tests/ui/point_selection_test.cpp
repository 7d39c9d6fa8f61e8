// Control points by the hand and by keys: selecting several, moving them together, falloff, symmetry, axes.
#include <cmath>

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTest>

#include <glm/geometric.hpp>

#include "tests/ui/one_surface_test.h"
#include "ui/panels/tool_panel.h"
#include "ui/points_dialog.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

using PointSelectionTest = OneSurfaceTest;

TEST_F(PointSelectionTest, ActionsWidenNarrowAndInvertIt)
{
    const NurbsSurface& surface = scene().find(id)->surface;
    const auto countU = static_cast<size_t>(surface.countU());
    const auto countV = static_cast<size_t>(surface.countV());
    selection().setPoints(pointOf(scene(), {id, {3, 4}}));
    act("points.grow");
    EXPECT_EQ(selection().points().size(), 5U);
    act("points.shrink");
    EXPECT_TRUE(selection().points() == pointOf(scene(), {id, {3, 4}}));
    act("points.row");
    EXPECT_TRUE(selection().points() == rowOf(scene(), id, 3));
    act("points.column");
    EXPECT_EQ(selection().points().size(), countU * countV);
    selection().setPoints(columnOf(scene(), id, 4));
    act("points.invert");
    EXPECT_EQ(selection().points().size(), countU * (countV - 1));
    act("points.net");
    EXPECT_EQ(selection().points().size(), countU * countV);
    EXPECT_FALSE(window->document().isModified());
}

TEST_F(PointSelectionTest, ADragOnOneOfThemMovesAllByOneStep)
{
    const VisiblePoint at = point();
    selection().setPoints(rowOf(scene(), id, at.index.i));
    settle(*window);
    Hand hand(*window);
    hand.drag(at.pixel, at.pixel + Vec2(24, -18));
    const auto all = moves();
    EXPECT_EQ(countOf(all), static_cast<size_t>(scene().find(id)->surface.countV()));
    const Vec3 first = all[static_cast<size_t>(at.index.i * scene().find(id)->surface.countV())];
    for (const Vec3& by : all)
        EXPECT_TRUE(by == Vec3(0) || glm::distance(by, first) <= 1e-12 * glm::length(first));
    EXPECT_EQ(steps(), 1);
    act("edit.undo");
    EXPECT_TRUE(scene() == start);
}

TEST_F(PointSelectionTest, ShiftAddsControlTakesOutAndAClickLeavesOne)
{
    const VisiblePoint at = point();
    const PointSelection row = rowOf(scene(), id, at.index.i == 0 ? 1 : 0);
    const PointSelection one = pointOf(scene(), {id, at.index});
    selection().setPoints(row);
    settle(*window);
    Hand hand(*window);
    hand.click(at.pixel, Qt::ShiftModifier);
    PointSelection both = row;
    both.add(one);
    EXPECT_TRUE(selection().points() == both);
    hand.click(at.pixel, Qt::ControlModifier);
    EXPECT_TRUE(selection().points() == row);
    hand.click(at.pixel, Qt::ControlModifier);
    EXPECT_TRUE(selection().points() == both);
    hand.click(at.pixel);
    EXPECT_TRUE(selection().points() == one);
    EXPECT_FALSE(window->document().isModified());
}

TEST_F(PointSelectionTest, ShiftHeldMovesByATenth)
{
    const VisiblePoint at = point();
    const size_t place = static_cast<size_t>(at.index.i * scene().find(id)->surface.countV() + at.index.j);
    Hand hand(*window);
    hand.drag(at.pixel, at.pixel + Vec2(40, 0));
    const double whole = glm::length(moves()[place]);
    act("edit.undo");
    settle(*window);
    hand.drag(at.pixel, at.pixel + Vec2(40, 0), Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NEAR(glm::length(moves()[place]), whole / 10, 1e-6 * whole);
}

TEST_F(PointSelectionTest, ThePanelSaysWhichWayAndWhoFollows)
{
    auto* panel = window->findChild<ToolPanel*>();
    ASSERT_NE(panel, nullptr);
    const VisiblePoint at = point();
    panel->findChild<QComboBox*>("drag-axis")->setCurrentIndex(static_cast<int>(DragAxis::z));
    Hand hand(*window);
    hand.drag(at.pixel, at.pixel + Vec2(0, -30));
    EXPECT_EQ(countOf(moves()), 1U);
    for (const Vec3& by : moves()) {
        EXPECT_EQ(by.x, 0);
        EXPECT_EQ(by.y, 0);
        EXPECT_GE(by.z, 0);
    }
    act("edit.undo");
    settle(*window);
    panel->findChild<QComboBox*>("falloff-distance")
        ->setCurrentIndex(static_cast<int>(FalloffDistance::netSteps));
    panel->findChild<QDoubleSpinBox*>("falloff-radius")->setValue(3);
    hand.drag(at.pixel, at.pixel + Vec2(0, -30));
    const auto all = moves();
    EXPECT_GT(countOf(all), 4U);
    const int countV = scene().find(id)->surface.countV();
    const double most = all[static_cast<size_t>(at.index.i * countV + at.index.j)].z;
    for (int i = 0; i < scene().find(id)->surface.countU(); ++i)
        for (int j = 0; j < countV; ++j) {
            const int away = std::abs(i - at.index.i) + std::abs(j - at.index.j);
            const double share = falloffShare(FalloffShape::smooth, away, 3);
            EXPECT_NEAR(all[static_cast<size_t>(i * countV + j)].z, share * most, 1e-9 * most);
        }
    EXPECT_EQ(steps(), 1);
    act("edit.undo");
    EXPECT_TRUE(scene() == start);
}

TEST_F(PointSelectionTest, NumbersMoveAndWeighThem)
{
    selection().setPoints(pointOf(scene(), {id, {2, 3}}));
    act("points.numbers");
    auto* dialog = window->findChild<PointsDialog*>();
    ASSERT_NE(dialog, nullptr);
    const auto choose = [&](int what) {
        dialog->findChild<QComboBox*>("what")->setCurrentIndex(what);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog->isLooking(); }, 10'000));
    };
    const auto type = [&](const char* box, double value) {
        dialog->findChild<QDoubleSpinBox*>(box)->setValue(value);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog->isLooking(); }, 10'000));
    };
    const auto apply = [&] { QTest::mouseClick(dialog->findChild<QPushButton*>("apply"), Qt::LeftButton); };
    const auto now = [&] { return scene().find(id)->surface.controlPoint(2, 3); };
    const Vec3 before = start.find(id)->surface.controlPoint(2, 3).position;
    choose(0);
    type("place-z", 0.25);
    EXPECT_FALSE(scene() == start);  // it is shown
    apply();
    EXPECT_LE(glm::distance(now().position, before + Vec3(0, 0, 0.25)), 1e-12);
    choose(1);
    type("place-x", before.x + 0.5);
    apply();
    EXPECT_NEAR(now().position.x, dialog->findChild<QDoubleSpinBox*>("place-x")->value(), 1e-12);
    EXPECT_NEAR(now().position.x, before.x + 0.5, 1e-4);
    EXPECT_EQ(now().position.y, before.y);
    choose(2);
    type("weight", 2.5);
    apply();
    EXPECT_EQ(now().weight, 2.5);
    EXPECT_EQ(steps(), 3);
    for (int k = 0; k < 3; ++k)
        act("edit.undo");
    EXPECT_TRUE(scene() == start);
    selection().setPoints({});
    EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog->isLooking(); }, 10'000));
    EXPECT_FALSE(dialog->findChild<QPushButton*>("apply")->isEnabled());
}

TEST_F(PointSelectionTest, KeysNudgeThem)
{
    selection().setPoints(rowOf(scene(), id, 2));
    act("points.up");
    const double whole = glm::length(moves()[static_cast<size_t>(2 * scene().find(id)->surface.countV())]);
    EXPECT_GT(whole, 0);
    EXPECT_EQ(countOf(moves()), static_cast<size_t>(scene().find(id)->surface.countV()));
    act("points.down");
    for (const Vec3& by : moves())
        EXPECT_LE(glm::length(by), 1e-12 * whole + 1e-12);
    act("points.rightFine");
    EXPECT_NEAR(glm::length(moves()[static_cast<size_t>(2 * scene().find(id)->surface.countV())]), whole / 10,
                1e-6 * whole);
    EXPECT_EQ(steps(), 3);
    for (int k = 0; k < 3; ++k)
        act("edit.undo");
    EXPECT_TRUE(scene() == start);
}

}  // namespace
}  // namespace knotspan
