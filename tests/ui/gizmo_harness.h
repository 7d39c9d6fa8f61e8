// What the tests of the gizmo and of drags by keys share: a window, one object selected, and where its
// handles are.
#pragma once

#include <algorithm>

#include <gtest/gtest.h>

#include <QStatusBar>

#include <glm/geometric.hpp>

#include "tests/ui/window_harness.h"
#include "ui/tools/selection_gizmo.h"

namespace knotspan::testing {

class GizmoTest : public ::testing::Test {
protected:
    void SetUp() override { open("single-100"); }
    // Windows remember what the tools were told.
    void TearDown() override
    {
        tell([](ToolSettings& settings) { settings = ToolSettings(); });
    }

    void open(const char* sample)
    {
        window = shownWindow(answers, sample);
        if (window->viewport().renderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        tell([](ToolSettings& settings) { settings = ToolSettings(); });
        id = scene().objects().begin()->first;
        start = scene();
        window->selection().setObjects({id});
        settle(*window);
    }

    template <class Change>
    void tell(const Change& change)
    {
        ToolSettings settings = window->viewport().toolSettings();
        change(settings);
        window->viewport().setToolSettings(settings);
    }

    [[nodiscard]] const Scene& scene() { return window->document().scene(); }
    [[nodiscard]] const Scene& now() { return scene(); }
    [[nodiscard]] int steps() { return window->document().history().count(); }
    [[nodiscard]] QString hint() { return window->statusBar()->currentMessage(); }
    [[nodiscard]] Camera camera() { return window->viewport().frame().camera; }

    [[nodiscard]] PictureView view()
    {
        const PictureSize size = window->viewport().pictureSize();
        return {camera(), size.width, size.height, window->viewport().devicePixelRatioF()};
    }
    [[nodiscard]] Vec2 pixelOf(const Vec3& place)
    {
        const PictureSize size = window->viewport().pictureSize();
        const auto pixel = camera().toPixel(place, size.width, size.height);
        EXPECT_TRUE(pixel.has_value());
        return pixel.value_or(Vec2(0));
    }
    [[nodiscard]] PlacedHandles placed()
    {
        return handlesOf(scene(), window->selection(), window->viewport().toolSettings().gizmo);
    }
    [[nodiscard]] size_t handleOf(HandleKind kind, DragAxis axis)
    {
        const PlacedHandles all = placed();
        for (size_t k = 0; k < all.handles.size(); ++k)
            if (all.handles[k].kind == kind && all.handles[k].axis == axis)
                return k;
        ADD_FAILURE() << "no such handle";
        return 0;
    }
    // A pixel of a handle that no other handle and no control point is near.
    [[nodiscard]] Vec2 grip(HandleKind kind, DragAxis axis)
    {
        const PlacedHandles all = placed();
        const Gizmo gizmo(view(), all.centre, all.handles);
        const size_t handle = handleOf(kind, axis);
        Vec2 best(0);
        double mostRoom = -1;
        for (const Stroke& stroke : gizmo.shape(handle))
            for (const double part : {0.1, 0.3, 0.5, 0.7, 0.9}) {
                const Vec2 at = stroke.from + part * (stroke.to - stroke.from);
                const auto hit = gizmo.under(at);
                const double room = hit && hit->handle == handle ? roomAround(at) : -1;
                if (room > mostRoom) {
                    mostRoom = room;
                    best = at;
                }
            }
        EXPECT_GT(mostRoom, 1.5) << "control points hide the handle";
        return best;
    }

    void key(int code, const QString& text = {}) { Hand(*window).key(code, text); }
    void type(const char* text)
    {
        for (const char* sign = text; *sign != 0; ++sign)
            key(static_cast<unsigned char>(*sign), QString(QLatin1Char(*sign)));
    }

    [[nodiscard]] Vec3 placeOf(const Scene& of, const ScenePoint& point)
    {
        return controlPointInModel(*of.find(point.object), point.index);
    }
    // One undo step, and undone the start to the bit.
    void expectOneStep(const QString& name)
    {
        EXPECT_EQ(steps(), 1);
        EXPECT_EQ(window->document().undoText(), name);
        window->document().undo();
        EXPECT_TRUE(scene() == start);
        for (const auto& [each, object] : start.objects())
            EXPECT_EQ(scene().find(each), object);
        settle(*window);
    }
    // Never anything but this.
    void expectNoTrace()
    {
        EXPECT_TRUE(scene() == start);
        EXPECT_FALSE(window->document().isModified());
        EXPECT_FALSE(window->document().canUndo());
        EXPECT_FALSE(window->document().canRedo());
        settle(*window);
    }

    Answers answers;
    std::unique_ptr<MainWindow> window;
    ObjectId id{};
    Scene start;

private:
    [[nodiscard]] double roomAround(const Vec2& at)
    {
        double room = 1e9;
        for (const ObjectId each : window->selection().objects())
            for (const ControlPoint& point : scene().find(each)->surface.controlPoints())
                room = std::min(room, glm::distance(at, pixelOf(transformed(point.position,
                                                                            scene().find(each)->transform))));
        return room;
    }
};

}  // namespace knotspan::testing
