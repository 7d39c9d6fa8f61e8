#include "model/document/document_friends.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <STEPControl_Writer.hxx>

#include <gtest/gtest.h>

#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "tests/support.h"

namespace knotspan {
namespace {

void writeBox(const std::filesystem::path& path)
{
    STEPControl_Writer writer;
    writer.Transfer(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), STEPControl_AsIs);
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
}

// Moves the middle control point of an object's border u = start.
Edit pulled(const Document& document, double by)
{
    const auto& [id, object] = *document.scene().objects().begin();
    const ControlPointIndex index{0, object->surface.countV() / 2};
    Edit edit;
    edit.set(
        id, withControlPointAt(*object, index, controlPointInModel(*object, index) + Vec3(0, 0, by)).value());
    return edit;
}

TEST(DocumentFriends, SayWhatFriendsOfTheSceneAre)
{
    Document document;
    DocumentFriends friends(document);
    EXPECT_TRUE(friends.friends().edges().empty());
    document.reset(findSample("hull")->make(), "hull");
    SceneFriends anew;
    anew.follow(document.scene());
    EXPECT_EQ(friends.friends().edges(), anew.edges());
    EXPECT_EQ(friends.friends().nakedEdges(), anew.nakedEdges());
    EXPECT_FALSE(anew.edges().empty());
}

TEST(DocumentFriends, AreComputedOnceAChangeAndOnlyWhenAsked)
{
    Document document;
    DocumentFriends friends(document);
    int told = 0;
    QObject::connect(&friends, &DocumentFriends::changed, &document, [&told] { ++told; });
    document.reset(findSample("nine-16")->make(), "nine");
    EXPECT_EQ(told, 1);
    EXPECT_TRUE(friends.isStale());
    const FriendEdge* before = friends.friends().edges().data();
    EXPECT_FALSE(friends.isStale());
    const int revision = friends.revision();
    EXPECT_EQ(friends.friends().edges().data(), before);
    document.apply(pulled(document, 0.5), "pull");
    document.apply(pulled(document, 0.5), "pull");
    EXPECT_EQ(told, 3);
    EXPECT_TRUE(friends.isStale());
    EXPECT_EQ(friends.revision(), revision + 1);
    EXPECT_EQ(friends.revision(), revision + 1);
}

TEST(DocumentFriends, ANameIsNoChange)
{
    Document document;
    document.reset(findSample("nine-16")->make(), "nine");
    DocumentFriends friends(document);
    const int revision = friends.revision();
    const auto& [id, object] = *document.scene().objects().begin();
    auto renamed = std::make_shared<SceneObject>(*object);
    renamed->name = "another";
    Edit edit;
    edit.set(id, renamed);
    document.apply(edit, "rename");
    EXPECT_EQ(friends.revision(), revision);
}

TEST(DocumentFriends, FollowADragAndItsUndo)
{
    Document document;
    document.reset(findSample("knot")->make(), "knot");
    DocumentFriends friends(document);
    const std::vector<FriendEdge> before = friends.friends().edges();
    const int gesture = document.newGesture();
    for (int step = 1; step <= 5; ++step) {
        document.apply(pulled(document, 0.01), "drag", gesture);
        SceneFriends anew;
        anew.follow(document.scene());
        EXPECT_EQ(friends.friends().edges(), anew.edges()) << step;
    }
    EXPECT_NE(friends.friends().edges(), before);
    document.finishGesture(gesture);
    document.undo();
    EXPECT_EQ(friends.friends().edges(), before);
}

// A tolerance that was set for one model says nothing of the next one.
TEST(DocumentFriends, AnotherModelHasItsDefaultTolerances)
{
    const testing::TemporaryFolder folder;
    Document document;
    DocumentFriends friends(document);
    document.reset(findSample("hull")->make(), "hull");
    EXPECT_EQ(friends.tolerances(), defaultTolerances(false));
    friends.setTolerances({0.5, 20, 0.1});
    document.apply(pulled(document, 0.1), "pull");
    EXPECT_EQ(friends.tolerances().angleDeg, 20);
    ASSERT_TRUE(document.saveAs(folder / "hull.knotspan"));
    EXPECT_EQ(friends.tolerances().angleDeg, 20);
    writeBox(folder / "box.step");
    ASSERT_TRUE(document.open(folder / "box.step"));
    EXPECT_EQ(friends.tolerances(), defaultTolerances(true));
    EXPECT_NE(defaultTolerances(true), defaultTolerances(false));
    ASSERT_TRUE(document.open(folder / "hull.knotspan"));
    EXPECT_EQ(friends.tolerances(), defaultTolerances(false));
}

TEST(DocumentFriends, OtherTolerancesGiveOtherVerdicts)
{
    Document document;
    document.reset(findSample("hull")->make(), "hull");
    DocumentFriends friends(document);
    const auto kinks = [&] {
        const auto& edges = friends.friends().edges();
        return std::count_if(edges.begin(), edges.end(),
                             [](const FriendEdge& edge) { return edge.continuity == Continuity::g0; });
    };
    const auto strict = kinks();
    EXPECT_GT(strict, 0);
    int told = 0;
    QObject::connect(&friends, &DocumentFriends::changed, &document, [&told] { ++told; });
    friends.setTolerances(friends.tolerances());
    EXPECT_EQ(told, 0);
    FriendTolerances loose;
    loose.angleDeg = 170;
    friends.setTolerances(loose);
    EXPECT_EQ(told, 1);
    EXPECT_LT(kinks(), strict);
}

}  // namespace
}  // namespace knotspan
