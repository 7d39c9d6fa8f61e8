// A window with one surface, selected: what tests of tools begin with.
#pragma once

#include <algorithm>

#include <gtest/gtest.h>

#include <QAction>

#include "tests/ui/window_harness.h"

namespace knotspan::testing {

class OneSurfaceTest : public ::testing::Test {
protected:
    void SetUp() override
    {
        window = shownWindow(answers, "single-100");
        if (window->viewport().renderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        id = scene().objects().begin()->first;
        start = scene();
        window->selection().setObjects({id});
        settle(*window);
    }

    [[nodiscard]] const Scene& scene() { return window->document().scene(); }
    [[nodiscard]] Selection& selection() { return window->selection(); }
    [[nodiscard]] int steps() { return window->document().undoStack().count(); }
    void act(const char* name) { window->action(name)->trigger(); }
    // How far each control point stands from where it was.
    [[nodiscard]] std::vector<Vec3> moves()
    {
        std::vector<Vec3> result;
        const auto& before = start.find(id)->surface.controlPoints();
        const auto& after = scene().find(id)->surface.controlPoints();
        for (size_t k = 0; k < before.size(); ++k)
            result.push_back(after[k].position - before[k].position);
        return result;
    }
    [[nodiscard]] static size_t countOf(const std::vector<Vec3>& moves)
    {
        return static_cast<size_t>(
            std::count_if(moves.begin(), moves.end(), [](const Vec3& by) { return by != Vec3(0); }));
    }
    [[nodiscard]] VisiblePoint point()
    {
        const auto found = visiblePoint(*window, id);
        EXPECT_TRUE(found);
        return found.value_or(VisiblePoint{});
    }

    Answers answers;
    std::unique_ptr<MainWindow> window;
    ObjectId id{};
    Scene start;
};

}  // namespace knotspan::testing
