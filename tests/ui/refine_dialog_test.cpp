// Refine surface, driven through its boxes and buttons: the document, one undo step, the preview.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/refine_dialog.h"

namespace knotspan::testing {

namespace {

struct Opened {
    Answers answers;
    MainWindow window{answering(answers)};
    Scene start;
    ObjectId id{};
    RefineDialog* dialog = nullptr;

    explicit Opened(const char* sample = "single-100")
    {
        window.files().openSample(sample);
        start = scene();
        id = start.objects().begin()->first;
        window.show();
        window.selection().setObjects({id});
        window.action("edit.refine")->trigger();
        dialog = window.findChild<RefineDialog*>();
        wait();
    }

    void wait() const
    {
        EXPECT_TRUE(QTest::qWaitFor([this] { return !dialog->isLooking(); }, 10'000));
    }
    [[nodiscard]] const Scene& scene() { return window.document().scene(); }
    [[nodiscard]] const NurbsSurface& surface() { return scene().find(id)->surface; }
    // Asked only where nothing is shown: who looks at the stack takes a preview back.
    [[nodiscard]] int steps() { return window.document().undoStack().count(); }
    template <class Widget>
    [[nodiscard]] Widget& the(const char* name) const
    {
        return *dialog->findChild<Widget*>(name);
    }
    [[nodiscard]] std::string details() const { return the<QLabel>("details").text().toStdString(); }
    void choose(RefinementKind kind, Direction direction = Direction::U) const
    {
        the<QComboBox>("kind").setCurrentIndex(static_cast<int>(kind));
        the<QComboBox>("direction").setCurrentIndex(static_cast<int>(direction));
        wait();
    }
    void click(const char* name) const { QTest::mouseClick(&the<QPushButton>(name), Qt::LeftButton); }
};

bool says(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST(RefineDialog, DoesEachThingAsOneStepThatUndoTakesBackToTheBit)
{
    using Kind = RefinementKind;
    Opened opened;
    opened.the<QDoubleSpinBox>("tolerance").setValue(1000);
    for (const Kind kind : {Kind::insertKnot, Kind::removeKnot, Kind::raiseDegree, Kind::lowerDegree,
                            Kind::rebuild, Kind::split, Kind::reverse, Kind::swap}) {
        opened.choose(kind, Direction::V);
        EXPECT_TRUE(opened.dialog->isPreviewing()) << opened.details();
        EXPECT_FALSE(opened.window.document().canUndo());
        EXPECT_FALSE(opened.scene() == opened.start);  // it is shown
        opened.click("apply");
        EXPECT_EQ(opened.steps(), 1);
        EXPECT_FALSE(opened.scene() == opened.start);
        EXPECT_EQ(opened.scene().objects().size(), kind == Kind::split ? 2U : 1U);
        opened.window.action("edit.undo")->trigger();
        EXPECT_TRUE(opened.scene() == opened.start) << static_cast<int>(kind);
        EXPECT_FALSE(opened.window.document().canUndo());
    }
}

TEST(RefineDialog, InsertsTheKnotThatIsTyped)
{
    Opened opened;
    auto& box = opened.the<QDoubleSpinBox>("parameter");
    const KnotVector before = opened.start.find(opened.id)->surface.knotsU();
    const double middle = (before.domainStart() + before.domainEnd()) / 2 + 0.01;
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, box.locale().toString(middle, 'f', 6));
    QTest::keyClick(&box, Qt::Key_Tab);
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "The shape stays as it is.")) << opened.details();
    opened.click("apply");
    const std::vector<double>& knots = opened.surface().knotsU().values();
    EXPECT_EQ(knots.size(), before.values().size() + 1);
    EXPECT_EQ(std::count(knots.begin(), knots.end(), box.value()), 1);
}

TEST(RefineDialog, SaysHowFarTheSurfaceMovesAndRefusesWhatIsTooFar)
{
    Opened opened;
    opened.choose(RefinementKind::lowerDegree);
    opened.the<QDoubleSpinBox>("tolerance").setValue(1e-6);
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "would move by up to")) << opened.details();
    EXPECT_FALSE(opened.the<QPushButton>("apply").isEnabled());
    EXPECT_FALSE(opened.dialog->isPreviewing());
    EXPECT_TRUE(opened.scene() == opened.start);
    opened.the<QDoubleSpinBox>("tolerance").setValue(1000);
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "nowhere by more than")) << opened.details();
    EXPECT_TRUE(opened.the<QPushButton>("apply").isEnabled());
}

TEST(RefineDialog, RebuildsToTheNumbersGiven)
{
    Opened opened;
    opened.choose(RefinementKind::rebuild);
    EXPECT_EQ(opened.the<QSpinBox>("count-u").value(), opened.start.find(opened.id)->surface.countU());
    opened.the<QSpinBox>("count-u").setValue(7);
    opened.the<QSpinBox>("degree-u").setValue(4);
    opened.wait();
    opened.click("apply");
    EXPECT_EQ(opened.surface().countU(), 7);
    EXPECT_EQ(opened.surface().degreeU(), 4);
}

TEST(RefineDialog, ClosingTakesThePreviewBackAndWithoutASurfaceItSaysWhatToDo)
{
    Opened opened;
    opened.choose(RefinementKind::raiseDegree);
    EXPECT_FALSE(opened.scene() == opened.start);
    opened.click("close");
    EXPECT_TRUE(opened.scene() == opened.start);
    EXPECT_EQ(opened.steps(), 0);
    opened.window.selection().clear();
    opened.window.action("edit.refine")->trigger();
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "Select a surface")) << opened.details();
    EXPECT_FALSE(opened.the<QPushButton>("apply").isEnabled());
}

// A preview of one object must not be applied to the next one that is selected.
TEST(RefineDialog, FollowsTheSelection)
{
    Opened opened("nine-16");
    opened.choose(RefinementKind::raiseDegree);
    const ObjectId other = std::next(opened.start.objects().begin())->first;
    opened.window.selection().setObjects({other});
    opened.wait();
    EXPECT_EQ(opened.scene().find(opened.id), opened.start.find(opened.id));
    opened.click("apply");
    EXPECT_EQ(opened.scene().find(opened.id), opened.start.find(opened.id));
    EXPECT_EQ(opened.scene().find(other)->surface.degreeU(), opened.start.find(other)->surface.degreeU() + 1);
    opened.window.selection().setObjects({opened.id, other});
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "one surface only")) << opened.details();
}

}  // namespace knotspan::testing
