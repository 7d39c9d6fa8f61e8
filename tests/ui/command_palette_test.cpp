// Ctrl+K: finding an action by words, and running it.
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QLineEdit>
#include <QListView>
#include <QSettings>
#include <QTest>

#include "tests/ui/window_harness.h"
#include "ui/actions.h"
#include "ui/command_model.h"
#include "ui/command_palette.h"
#include "ui/command_search.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

std::vector<std::string> namesFor(const QString& filter, const QStringList& recent = {})
{
    const std::vector<CommandWords> commands = {
        {"view.knots", "Knot lines", "View", "Show where the surfaces' spans meet"},
        {"tools.knot", "Insert knot", "Tools", "Click a surface to insert a knot there"},
        {"view.fit", "Fit all", "View", "Bring the whole model into view"},
        {"edit.matchEdge", "Match edge", "Edit", "Make surfaces meet smoothly along an edge"}};
    std::vector<std::string> names;
    for (const size_t k : commandsFor(commands, filter, recent))
        names.push_back(commands[k].name.toStdString());
    return names;
}

using Names = std::vector<std::string>;

TEST(CommandSearch, TakesWordsInAnyOrderAndCase)
{
    EXPECT_EQ(namesFor("KNOT insert"), Names{"tools.knot"});
    EXPECT_EQ(namesFor("insert knot"), Names{"tools.knot"});
    EXPECT_EQ(namesFor("knot bring"), Names{});
}

TEST(CommandSearch, LooksIntoTextMenuNameAndTip)
{
    EXPECT_EQ(namesFor("view fit"), Names{"view.fit"});
    EXPECT_EQ(namesFor("matchedge"), Names{"edit.matchEdge"});
    EXPECT_EQ(namesFor("smoothly"), Names{"edit.matchEdge"});
}

TEST(CommandSearch, PutsTheNearestFirst)
{
    EXPECT_EQ(namesFor("knot"), (Names{"view.knots", "tools.knot"}));  // one begins with it
    EXPECT_EQ(namesFor("view"), (Names{"view.knots", "view.fit"}));
    EXPECT_EQ(namesFor("meet"), (Names{"view.knots", "edit.matchEdge"}));
}

TEST(CommandSearch, PutsWhatWasUsedLastFirstAmongEquals)
{
    EXPECT_EQ(namesFor("", {"edit.matchEdge", "view.fit"}),
              (Names{"edit.matchEdge", "view.fit", "view.knots", "tools.knot"}));
    EXPECT_EQ(namesFor("view", {"view.fit"}), (Names{"view.fit", "view.knots"}));
    EXPECT_EQ(namesFor("knot", {"tools.knot"}), (Names{"view.knots", "tools.knot"}));
}

class Palette : public ::testing::Test {
protected:
    void SetUp() override
    {
        QSettings().remove("recentCommands");
        window->action("help.palette")->trigger();
        palette = window->findChild<CommandPalette*>();
        ASSERT_NE(palette, nullptr);
        filter = palette->findChild<QLineEdit*>();
        list = palette->findChild<QListView*>();
    }
    void TearDown() override { QSettings().clear(); }

    [[nodiscard]] QModelIndex row(int k) const { return list->model()->index(k, 0); }
    [[nodiscard]] QString text(int k) const { return row(k).data().toString(); }

    Answers answers;
    std::unique_ptr<MainWindow> window = std::make_unique<MainWindow>(answering(answers));
    CommandPalette* palette = nullptr;
    QLineEdit* filter = nullptr;
    QListView* list = nullptr;
};

TEST_F(Palette, ListsEveryActionAndPanelWithItsMenuTipAndKeys)
{
    ASSERT_EQ(list->model()->rowCount(), window->commands().size());
    EXPECT_GT(static_cast<size_t>(list->model()->rowCount()), actionList().size());
    int withKeys = 0;
    for (int k = 0; k < list->model()->rowCount(); ++k) {
        EXPECT_FALSE(text(k).isEmpty() || text(k).contains('&')) << k;
        EXPECT_FALSE(row(k).data(CommandModel::kMenu).toString().isEmpty()) << text(k).toStdString();
        EXPECT_FALSE(row(k).data(Qt::ToolTipRole).toString().isEmpty()) << text(k).toStdString();
        withKeys += row(k).data(CommandModel::kKeys).toString().isEmpty() ? 0 : 1;
    }
    EXPECT_GT(withKeys, 60);
    EXPECT_FALSE(filter->accessibleName().isEmpty() || list->accessibleName().isEmpty());
}

TEST_F(Palette, EnterRunsWhatIsChosenAndPutsItFirstNextTime)
{
    EXPECT_FALSE(window->viewport().frame().overlays.knotLines);
    QTest::keyClicks(filter, "knot");
    ASSERT_EQ(text(0), "Knot lines");
    EXPECT_EQ(row(0).data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
    QTest::keyClick(filter, Qt::Key_Return);
    EXPECT_TRUE(window->viewport().frame().overlays.knotLines);
    EXPECT_FALSE(palette->isVisible());

    window->action("help.palette")->trigger();
    EXPECT_TRUE(palette->isVisible() && filter->text().isEmpty());
    EXPECT_EQ(text(0), "Knot lines");
    EXPECT_EQ(row(0).data(Qt::CheckStateRole).toInt(), Qt::Checked);
    EXPECT_TRUE(row(0).data(Qt::AccessibleTextRole).toString().contains("on"));
}

TEST_F(Palette, ArrowsChooseAndAClickRuns)
{
    QTest::keyClicks(filter, "look from");
    ASSERT_GT(list->model()->rowCount(), 3);
    QTest::keyClick(filter, Qt::Key_Down);
    EXPECT_EQ(list->currentIndex().row(), 1);
    QTest::keyClick(filter, Qt::Key_Up);
    QTest::keyClick(filter, Qt::Key_Up);
    EXPECT_EQ(list->currentIndex().row(), list->model()->rowCount() - 1);  // round
    QTest::keyClick(filter, Qt::Key_PageUp);
    EXPECT_EQ(list->currentIndex().row(), 0);

    filter->setText("history");
    ASSERT_EQ(text(0), "History");
    const auto* dock = window->findChild<QDockWidget*>("history-dock");
    const bool wasHidden = dock->isHidden();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(row(0)).center());
    EXPECT_NE(dock->isHidden(), wasHidden);
}

TEST_F(Palette, DoesNotRunWhatIsNotPossible)
{
    filter->setText("delete");
    ASSERT_EQ(text(0), "Delete");
    EXPECT_FALSE(row(0).data(CommandModel::kIsPossible).toBool());
    EXPECT_TRUE(row(0).data(Qt::AccessibleTextRole).toString().contains("not possible now"));
    int triggered = 0;
    QObject::connect(window->action("edit.delete"), &QAction::triggered, [&] { ++triggered; });
    QTest::keyClick(filter, Qt::Key_Return);
    EXPECT_EQ(triggered, 0);
    EXPECT_TRUE(palette->isVisible());
    QTest::keyClick(filter, Qt::Key_Escape);
    EXPECT_FALSE(palette->isVisible());
}

}  // namespace
}  // namespace knotspan
