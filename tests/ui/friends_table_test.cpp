#include <set>

#include <QElapsedTimer>

#include <gtest/gtest.h>

#include "tests/support.h"
#include "ui/panels/friends_table.h"
#include "ui/viewport/friend_lines.h"

namespace knotspan {
namespace {

TEST(FriendEdges, HaveAColourForEachVerdictAndTheirRank)
{
    const std::vector<Continuity> worstFirst = {Continuity::none, Continuity::undetermined, Continuity::g0,
                                                Continuity::g1, Continuity::g2};
    std::set<std::uint32_t> colours{nakedColour()};
    int last = -1;
    for (const Continuity continuity : worstFirst) {
        colours.insert(verdictColour(continuity));
        EXPECT_GT(smoothnessRank(continuity), last);
        last = smoothnessRank(continuity);
    }
    EXPECT_EQ(colours.size(), 6U);
}

TEST(FriendsTableModel, TenThousandRowsAreSortedInATrice)
{
    Scene scene;
    const NurbsSurface flat =
        NurbsSurface::create(KnotVector::clampedUniform(1, 1), KnotVector::clampedUniform(1, 1),
                             {{{0, 0, 0}}, {{0, 1, 0}}, {{1, 0, 0}}, {{1, 1, 0}}})
            .value();
    for (int i = 0; i < 2500; ++i) {
        SceneObject object{.surface = flat};
        object.transform[3] = Vec4(2.5 * (i % 50), 2.5 * (i / 50), 0, 1);
        scene.add(std::move(object));
    }
    Document document;
    document.reset(std::move(scene), "many");
    DocumentFriends friends(document);
    FriendsTable table(friends);
    FriendsFilter filter(table);
    (void)friends.friends();
    QElapsedTimer clock;
    clock.start();
    table.takeOver();
    filter.sort(FriendsTable::gap);
    filter.sort(FriendsTable::edgeA);
    filter.show(FriendsFilter::Show::problems);
    filter.show(FriendsFilter::Show::all);
    EXPECT_EQ(filter.rowCount(), 10000);
    EXPECT_LT(clock.elapsed(), 1000 * testing::kHang);
}

}  // namespace
}  // namespace knotspan
