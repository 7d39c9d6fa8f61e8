// A hand that does anything: clicks, drags, half drags that are cancelled, keys, settings, undo and redo. All
// of it undone, the document is the one that it began with, to the bit. KNOTSPAN_SOAK=1: 2,000 events.
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>

#include "tests/ui/window_harness.h"
#include "ui/panels/tool_panel.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class Walk {
public:
    Walk(MainWindow& window, unsigned seed) : window_(window), hand_(window), random_(seed) {}

    void step()
    {
        switch (below(12)) {
        case 0:
        case 1:
            return hand_.click(pixel(), keys());
        case 2:
        case 3:
        case 4:
            return hand_.drag(pixel(), pixel(), Qt::LeftButton, keys());
        case 5:
            hand_.press(pixel(), Qt::LeftButton, keys());
            hand_.move(pixel());
            act("edit.deselect");  // Escape
            return hand_.release();
        case 6:
            return setting();
        case 7:
            return act(below(3) == 0 ? "edit.redo" : "edit.undo");
        case 8:
            return typing();
        case 9:
            return act(kTools[below(std::size(kTools))]);
        default:
            return act(kActions[below(std::size(kActions))]);
        }
    }

private:
    static constexpr const char* kTools[] = {"tools.select", "tools.select",  "tools.select", "tools.box",
                                             "tools.lasso",  "tools.weight",  "tools.knot",   "tools.grab",
                                             "tools.smooth", "tools.inflate", "tools.flatten"};
    static constexpr const char* kActions[] = {
        "points.row",        "points.column",     "points.net",     "points.grow",      "points.shrink",
        "points.invert",     "points.left",       "points.up",      "points.rightFine", "edit.keepFriends",
        "edit.selectAll",    "object.duplicate",  "edit.delete",    "object.sidesBoth", "view.iso",
        "view.fit",          "view.nets",         "view.friends",   "edit.deselect",    "view.top",
        "object.hide",       "object.isolate",    "object.showAll", "object.lock",      "object.unlockAll",
        "view.points",       "view.hulls",        "view.isoCurves", "view.normals",     "view.knots",
        "view.outlines",     "tools.gizmo",       "tools.snap",     "tools.takePoints", "tools.takeObjects",
        "tools.largerBrush", "tools.smallerBrush"};

    // Keys while something is dragged.
    void typing()
    {
        hand_.press(pixel(), Qt::LeftButton, keys());
        hand_.move(pixel());
        constexpr std::pair<int, const char*> kKeys[] = {
            {Qt::Key_X, "x"},      {Qt::Key_Y, "y"},     {Qt::Key_Z, "z"},      {Qt::Key_U, "u"},
            {Qt::Key_N, "n"},      {Qt::Key_1, "1"},     {Qt::Key_Period, "."}, {Qt::Key_5, "5"},
            {Qt::Key_Minus, "-"},  {Qt::Key_Equal, "="}, {Qt::Key_Space, " "},  {Qt::Key_Backspace, "\b"},
            {Qt::Key_Return, "\r"}};
        for (size_t k = below(6); k > 0; --k) {
            const auto& [key, text] = kKeys[below(std::size(kKeys))];
            hand_.key(key, text);
        }
        if (below(4) == 0)
            hand_.key(Qt::Key_Escape);
        hand_.release();
    }
    [[nodiscard]] size_t below(size_t count)
    {
        return std::uniform_int_distribution<size_t>(0, count - 1)(random_);
    }
    [[nodiscard]] Vec2 pixel()
    {
        // Often one where a control point is, as the hand would.
        if (below(2) == 0 && !window_.selection().objects().empty()) {
            const ObjectId id = *window_.selection().objects().begin();
            if (const SharedObject object = window_.document().scene().find(id)) {
                const ControlPointIndex index{
                    static_cast<int>(below(static_cast<size_t>(object->surface.countU()))),
                    static_cast<int>(below(static_cast<size_t>(object->surface.countV())))};
                const PictureSize size = window_.viewport().pictureSize();
                if (const auto seen = window_.viewport().frame().camera.toPixel(
                        controlPointInModel(*object, index), size.width, size.height))
                    return *seen;
            }
        }
        const PictureSize size = window_.viewport().pictureSize();
        return Vec2(below(static_cast<size_t>(size.width)), below(static_cast<size_t>(size.height)));
    }
    [[nodiscard]] Qt::KeyboardModifiers keys()
    {
        constexpr Qt::KeyboardModifier kKeys[] = {Qt::NoModifier, Qt::NoModifier, Qt::NoModifier,
                                                  Qt::ShiftModifier, Qt::ControlModifier};
        return kKeys[below(std::size(kKeys))];
    }
    void setting()
    {
        auto* panel = window_.findChild<ToolPanel*>();
        constexpr const char* kLists[] = {"drag-axis", "falloff-shape", "falloff-distance", "symmetry"};
        auto* list = panel->findChild<QComboBox*>(kLists[below(std::size(kLists))]);
        list->setCurrentIndex(static_cast<int>(below(static_cast<size_t>(list->count()))));
        panel->findChild<QDoubleSpinBox*>("falloff-radius")
            ->setValue(below(2) == 0 ? 0 : 0.5 * double(below(6)));
    }
    void act(const char* id)
    {
        if (QAction* action = window_.action(id); action->isEnabled())
            action->trigger();
    }

    MainWindow& window_;
    Hand hand_;
    std::mt19937 random_;
};

TEST(RandomWalk, UndoneIsTheDocumentThatItBeganWith)
{
    Answers answers;
    const auto window = shownWindow(answers, "nine-16");
    KNOTSPAN_NEED_RENDERER(*window);
    const Scene start = window->document().scene();
    const bool soak = std::getenv("KNOTSPAN_SOAK") != nullptr;
    Walk walk(*window, 7);
    int mostSteps = 0;
    for (int k = 0; k < (soak ? 2000 : 200); ++k) {
        walk.step();
        mostSteps = std::max(mostSteps, window->document().history().count());
    }
    EXPECT_GT(mostSteps, 5);
    while (window->document().canUndo())
        window->document().undo();
    EXPECT_TRUE(window->document().scene() == start);
    EXPECT_FALSE(window->document().isModified());
}

}  // namespace
}  // namespace knotspan
