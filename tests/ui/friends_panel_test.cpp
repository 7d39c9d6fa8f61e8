#include "ui/panels/friends_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QStackedWidget>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/panels/friend_graph.h"
#include "ui/viewport/friend_lines.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

size_t pixelsOf(const QImage& image, std::uint32_t colour)
{
    size_t count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += (image.pixel(x, y) & 0xffffffU) == colour ? 1 : 0;
    return count;
}

// A window with the panel up.
class FriendsPanelTest : public ::testing::Test {
protected:
    void open(const std::string& sample)
    {
        window = shownWindow(answers, sample);
        window->findChild<QDockWidget*>("friends-dock")->show();
        settle(*window);
        panel = window->findChild<FriendsPanel*>();
        view = panel->findChild<QTableView*>("friends");
    }
    [[nodiscard]] const SceneFriends& friends() const { return window->friends().friends(); }
    void show(FriendsFilter::Show what) const
    {
        auto* which = panel->findChild<QComboBox*>("friends-show");
        which->setCurrentIndex(which->findData(static_cast<int>(what)));
    }
    [[nodiscard]] QString cell(int row, int column) const
    {
        return view->model()->index(row, column).data().toString();
    }

    Answers answers;
    std::unique_ptr<MainWindow> window;
    FriendsPanel* panel = nullptr;
    QTableView* view = nullptr;
};

TEST_F(FriendsPanelTest, ListsEveryEdgeAndEveryNakedOne)
{
    open("hull");
    const size_t edges = friends().edges().size();
    ASSERT_EQ(view->model()->rowCount(), static_cast<int>(edges + friends().nakedEdges().size()));
    for (const Continuity continuity : {Continuity::none, Continuity::g0, Continuity::g1, Continuity::g2}) {
        const auto is = [&](const FriendEdge& edge) { return edge.continuity == continuity; };
        const auto expected = std::count_if(friends().edges().begin(), friends().edges().end(), is);
        int listed = 0;
        for (int k = 0; k < view->model()->rowCount(); ++k)
            listed += cell(k, FriendsTable::verdict) == continuityName(continuity) ? 1 : 0;
        EXPECT_EQ(listed, expected) << continuityName(continuity);
    }
    show(FriendsFilter::Show::naked);
    EXPECT_EQ(view->model()->rowCount(), static_cast<int>(friends().nakedEdges().size()));
    show(FriendsFilter::Show::problems);
    const auto problems = std::count_if(friends().edges().begin(), friends().edges().end(),
                                        [](const FriendEdge& edge) { return !edge.areFriends(); });
    EXPECT_GT(problems, 0);
    EXPECT_EQ(view->model()->rowCount(), problems);
}

TEST_F(FriendsPanelTest, SortsByNumbersAndFiltersByText)
{
    open("hull");
    show(FriendsFilter::Show::problems);
    show(FriendsFilter::Show::all);
    view->sortByColumn(FriendsTable::angle, Qt::DescendingOrder);
    auto* proxy = qobject_cast<FriendsFilter*>(view->model());
    auto* table = qobject_cast<FriendsTable*>(proxy->sourceModel());
    double last = 1e300;
    for (int k = 0; k < proxy->rowCount(); ++k) {
        const auto& meeting = table->row(proxy->mapToSource(proxy->index(k, 0)).row()).meeting;
        const double angle = meeting ? meeting->angleBoundDeg : -1;
        EXPECT_LE(angle, last) << k;
        last = angle;
    }
    const QString name = cell(0, FriendsTable::edgeA);
    panel->findChild<QLineEdit*>("friends-filter")->setText(name.toUpper());
    ASSERT_GT(proxy->rowCount(), 0);
    for (int k = 0; k < proxy->rowCount(); ++k)
        EXPECT_TRUE(cell(k, FriendsTable::edgeA) == name || cell(k, FriendsTable::edgeB) == name);
    panel->findChild<QLineEdit*>("friends-filter")->setText("no such name");
    EXPECT_TRUE(panel->findChild<QLabel*>("friends-empty")->isVisible());
}

TEST_F(FriendsPanelTest, AClickGoesToTheWorstPointAndShowsTheGraph)
{
    open("hull");
    KNOTSPAN_NEED_RENDERER(*window);
    show(FriendsFilter::Show::g0);
    ASSERT_GT(view->model()->rowCount(), 0);
    const Camera before = window->viewport().frame().camera;
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                      view->visualRect(view->model()->index(0, 0)).center());
    settle(*window);
    ASSERT_TRUE(window->shownFriends().chosen());
    const FriendEdge& edge = friends().edges()[*window->shownFriends().chosen()];
    EXPECT_EQ(edge.continuity, Continuity::g0);
    const Camera& camera = window->viewport().frame().camera;
    EXPECT_NE(camera, before);
    const PictureSize size = window->viewport().pictureSize();
    const auto pixel = camera.toPixel(edge.worstPoint, size.width, size.height);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x, size.width / 2.0, 2);
    EXPECT_NEAR(pixel->y, size.height / 2.0, 2);
    EXPECT_GT(pixelsOf(picture(*window), verdictColour(Continuity::g0)), 20U);  // seen, not hidden
    const auto* graph = panel->findChild<FriendGraph*>("friend-graph");
    ASSERT_TRUE(graph->content());
    EXPECT_DOUBLE_EQ(graph->content()->tolerance, 0.1);
    EXPECT_LE(graph->largest(), edge.angleBoundDeg * 1.0001);
    EXPECT_GT(graph->largest(), 0.9 * edge.angleMaxDeg);
}

TEST_F(FriendsPanelTest, TheKeyboardChoosesAndEnterGoesThere)
{
    open("hull");
    view->setFocus();
    view->setCurrentIndex(view->model()->index(0, 0));
    const Camera before = window->viewport().frame().camera;
    QTest::keyClick(view, Qt::Key_Down);
    ASSERT_TRUE(window->shownFriends().chosen());
    EXPECT_EQ(window->viewport().frame().camera, before);
    QTest::keyClick(view, Qt::Key_Return);
    EXPECT_NE(window->viewport().frame().camera, before);
}

TEST_F(FriendsPanelTest, FollowsADragLive)
{
    open("nine-16");
    KNOTSPAN_NEED_RENDERER(*window);
    view->sortByColumn(FriendsTable::edgeA, Qt::AscendingOrder);
    QStringList before;
    for (int k = 0; k < view->model()->rowCount(); ++k)
        before << cell(k, FriendsTable::gap) + cell(k, FriendsTable::angle);
    const ObjectId id = window->document().scene().objects().begin()->first;
    window->selection().setObjects({id});
    settle(*window);
    const auto point = visiblePoint(*window, id);
    ASSERT_TRUE(point);
    Hand hand(*window);
    hand.press(point->pixel);
    hand.move(point->pixel + Vec2(0, -15));
    hand.move(point->pixel + Vec2(0, -30));
    settle(*window);
    SceneFriends anew;
    anew.follow(window->document().scene());
    EXPECT_EQ(friends().edges(), anew.edges());
    QStringList during;
    for (int k = 0; k < view->model()->rowCount(); ++k)
        during << cell(k, FriendsTable::gap) + cell(k, FriendsTable::angle);
    EXPECT_NE(during, before);
    hand.release();
    window->document().undo();
    settle(*window);
    QStringList after;
    for (int k = 0; k < view->model()->rowCount(); ++k)
        after << cell(k, FriendsTable::gap) + cell(k, FriendsTable::angle);
    EXPECT_EQ(after, before);
}

TEST_F(FriendsPanelTest, ToleranceFieldsAreThoseOfTheDocument)
{
    open("hull");
    panel->findChild<QDoubleSpinBox*>("friends-angle")->setValue(45);
    panel->findChild<QDoubleSpinBox*>("friends-gap")->setValue(0.5);
    settle(*window);
    EXPECT_DOUBLE_EQ(window->friends().tolerances().angleDeg, 45);
    EXPECT_DOUBLE_EQ(window->friends().tolerances().gap, 0.5);
    EXPECT_EQ(view->model()->rowCount(),
              static_cast<int>(friends().edges().size() + friends().nakedEdges().size()));
    window->files().openSample("nine-16");
    settle(*window);
    EXPECT_DOUBLE_EQ(panel->findChild<QDoubleSpinBox*>("friends-angle")->value(), 0.1);
    EXPECT_DOUBLE_EQ(panel->findChild<QDoubleSpinBox*>("friends-gap")->value(), 0.001);
}

// Flat pieces in a row, the last one folded back over its neighbour.
Scene tubes()
{
    const auto piece = [](double from, double to, double narrower) {
        return NurbsSurface::create(
                   KnotVector::clampedUniform(1, 1), KnotVector::clampedUniform(1, 1),
                   {{{from, 0, 0}}, {{from, 1, 0}}, {{to, narrower, 0}}, {{to, 1 - narrower, 0}}})
            .value();
    };
    Scene scene;
    scene.add({.name = "Tube 1.10", .surface = piece(0, 1, 0)});
    scene.add({.name = "Tube 1.2", .surface = piece(1, 2, 0)});
    scene.add({.name = "Tube 1.1", .surface = piece(2, 1.5, 0.2)});
    return scene;
}

TEST_F(FriendsPanelTest, SortsNumbersInNamesAsNumbers)
{
    open("hull");
    window->document().reset(tubes(), "tubes");
    settle(*window);
    view->sortByColumn(FriendsTable::edgeA, Qt::AscendingOrder);
    QStringList objects;
    for (int k = 0; k < view->model()->rowCount(); ++k)
        objects << cell(k, FriendsTable::edgeA).section(", ", 1);
    objects.removeDuplicates();
    EXPECT_EQ(objects, QStringList({"Tube 1.1", "Tube 1.2", "Tube 1.10"}));
}

TEST_F(FriendsPanelTest, ShowsAnAngleThatIsReachedAndNoRounding)
{
    open("hull");
    window->document().reset(tubes(), "tubes");
    settle(*window);
    show(FriendsFilter::Show::g0);
    ASSERT_EQ(view->model()->rowCount(), 1);
    EXPECT_EQ(cell(0, FriendsTable::angle), "180°");
    EXPECT_EQ(cell(0, FriendsTable::gap), "0");
    EXPECT_EQ(friendFigure(3.6e-14, 1e-7), "0");
    EXPECT_EQ(friendFigure(3.6e-4, 1e-7), "3.60e-4");
    EXPECT_EQ(friendFigure(0.0036, 1e-7), "0.0036");
    const auto* summary = panel->findChild<QLabel*>("friends-summary");
    EXPECT_TRUE(summary->text().startsWith("2 edges meet: 1 G2, 1 G0; ")) << summary->text().toStdString();
    EXPECT_TRUE(summary->text().endsWith(" naked")) << summary->text().toStdString();
}

TEST_F(FriendsPanelTest, TheGraphHasThePlaceWhereTheEdgeIsWorst)
{
    open("hull");
    for (size_t k = 0; k < friends().edges().size(); ++k) {
        window->shownFriends().choose(k);
        settle(*window);
        const FriendEdge& edge = friends().edges()[k];
        const auto* graph = panel->findChild<FriendGraph*>("friend-graph");
        ASSERT_TRUE(graph->content());
        const auto& samples = graph->content()->samples;
        EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end(),
                                   [](const auto& x, const auto& y) { return x.parameter < y.parameter; }));
        EXPECT_TRUE(std::any_of(samples.begin(), samples.end(), [&](const EdgeSample& sample) {
            return sample.parameter == edge.worst;
        })) << k;
        EXPECT_TRUE(graph->accessibleDescription().contains("sampled"));
    }
}

TEST_F(FriendsPanelTest, OpensTallEnoughToRead)
{
    open("hull");
    window->resize(1280, 800);
    auto* dock = window->findChild<QDockWidget*>("friends-dock");
    dock->hide();
    settle(*window);
    dock->toggleViewAction()->trigger();
    settle(*window);
    EXPECT_TRUE(view->isVisible());
    EXPECT_FALSE(view->visibleRegion().isEmpty());  // in front of the objects
    EXPECT_GE(view->viewport()->height(), 6 * view->rowHeight(0));
}

TEST_F(FriendsPanelTest, SaysWhenThereIsNothing)
{
    open("hull");
    window->document().reset(Scene(), "empty");
    settle(*window);
    const auto* empty = panel->findChild<QLabel*>("friends-empty");
    EXPECT_TRUE(empty->isVisible());
    EXPECT_TRUE(empty->text().contains("Open a model")) << empty->text().toStdString();
}

TEST_F(FriendsPanelTest, EverythingHasANameAndATip)
{
    open("hull");
    for (const char* name :
         {"friends-show", "friends-filter", "friends-gap", "friends-angle", "friends-quantity"}) {
        const auto* widget = panel->findChild<QWidget*>(name);
        ASSERT_NE(widget, nullptr) << name;
        EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
        EXPECT_FALSE(widget->toolTip().isEmpty()) << name;
    }
    EXPECT_FALSE(view->accessibleName().isEmpty());
    EXPECT_FALSE(view->model()->index(0, 0).data(Qt::ToolTipRole).toString().isEmpty());
    for (int column = 0; column < FriendsTable::columns; ++column)
        EXPECT_FALSE(view->model()->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
}

TEST(FriendEdges, AreDrawnInTheVerdictsColoursAndComputedOnlyWhenShown)
{
    Answers answers;
    const auto window = shownWindow(answers, "hull");
    KNOTSPAN_NEED_RENDERER(*window);
    EXPECT_TRUE(window->friends().isStale());  // nobody asked
    const QImage bare = picture(*window);
    QAction* action = window->action("view.friends");
    action->trigger();
    settle(*window);
    EXPECT_TRUE(action->isChecked());
    EXPECT_FALSE(window->friends().isStale());
    const QImage lined = picture(*window);
    EXPECT_GT(pixelsOf(lined, verdictColour(Continuity::g0)), 30U);
    EXPECT_EQ(pixelsOf(bare, verdictColour(Continuity::g0)), 0U);
    action->trigger();
    settle(*window);
    EXPECT_EQ(differingPixels(picture(*window), bare, 0), 0);
}

}  // namespace
}  // namespace knotspan
