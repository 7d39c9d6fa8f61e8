// What is said of trim loops, and how those of a file are turned.
#include <algorithm>

#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "model/formats/loop_notes.h"
#include "model/formats/verified_writing.h"
#include "model/geometry/loop_direction.h"
#include "tests/support.h"

namespace knotspan::formats {
namespace {

using testing::TemporaryFolder;

TrimLoop through(const std::vector<Vec2>& corners, bool outer)
{
    TrimLoop loop{outer, {}};
    for (size_t k = 0; k < corners.size(); ++k)
        loop.curves.push_back(TrimCurve::create(KnotVector::clampedUniform(1, 1),
                                                {{corners[k]}, {corners[(k + 1) % corners.size()]}})
                                  .value());
    return loop;
}

TrimLoop square(double from, double to, bool outer)
{
    if (outer)
        return through({{from, from}, {to, from}, {to, to}, {from, to}}, true);
    return through({{from, from}, {from, to}, {to, to}, {to, from}}, false);
}

Scene plateWith(const std::vector<TrimLoop>& loops)
{
    const KnotVector knots = KnotVector::clampedUniform(1, 1);
    Scene scene;
    scene.add(
        {.name = "plate",
         .surface =
             NurbsSurface::create(knots, knots, {{{0, 0, 0}}, {{0, 4, 0}}, {{4, 0, 0}}, {{4, 4, 0}}}).value(),
         .trimLoops = loops});
    return scene;
}

// The only sentence, or all of them where there are more or fewer.
std::string noteOf(const std::vector<TrimLoop>& loops)
{
    std::string all;
    for (const std::string& note : loopNotes(plateWith(loops)))
        all += (all.empty() ? "" : "\n") + note;
    return all;
}

TEST(LoopNotes, SayNothingOfHolesInOutlinesWhicheverWayTheyRun)
{
    EXPECT_EQ(noteOf({}), "");
    EXPECT_EQ(noteOf({square(0.1, 0.9, true), square(0.3, 0.5, false), square(0.6, 0.7, false)}), "");
    EXPECT_EQ(noteOf({square(0.3, 0.5, false)}), "") << "a hole in the whole surface";
    TrimLoop wrong = square(0.3, 0.5, true);
    wrong.outer = false;
    EXPECT_EQ(noteOf({square(0.1, 0.9, true), wrong}), "");
    EXPECT_EQ(noteOf({square(0.1, 0.4, true), square(0.6, 0.9, true), square(0.7, 0.8, false)}), "");
}

TEST(LoopNotes, TellWhereNothingIsLeft)
{
    const std::string gone = "1 surface has trim loops that leave nothing of it, and is not shown: plate. Untrim";
    EXPECT_EQ(noteOf({{true, {}}}).substr(0, gone.size()), gone);
    EXPECT_EQ(noteOf({square(1.2, 1.4, true)}).substr(0, gone.size()), gone);
}

TEST(LoopNotes, TellOfAHoleThatIsThereTwice)
{
    TrimLoop again = square(0.3, 0.5, false);
    std::rotate(again.curves.begin(), again.curves.begin() + 1, again.curves.end());
    const std::string note = noteOf({square(0.1, 0.9, true), square(0.3, 0.5, false), again});
    EXPECT_NE(note.find("1 surface has the same trim loop twice; the two cancel each other, and neither is "
                        "shown: plate. If that is not meant"),
              std::string::npos)
        << note;
    // Mirrored holes have the same box and the same area.
    EXPECT_EQ(noteOf({square(0, 1, true), through({{0.3, 0.3}, {0.3, 0.5}, {0.5, 0.3}}, false),
                      through({{0.31, 0.5}, {0.5, 0.5}, {0.5, 0.31}}, false)}),
              "");
}

TEST(LoopNotes, TellOfHolesAroundAndBesideTheirOutline)
{
    const std::string around = noteOf({square(0.3, 0.5, true), square(0.1, 0.9, false)});
    EXPECT_NE(
        around.find("1 surface has a hole around the outline; shown is what lies between the two: plate."),
        std::string::npos)
        << around;
    const std::string beside = noteOf({square(0.1, 0.4, true), square(0.6, 0.9, false)});
    EXPECT_NE(
        beside.find("1 surface has a hole outside of the outline; shown is what it encloses, too: plate."),
        std::string::npos)
        << beside;
}

TEST(LoopNotes, DoNotSayOfAFigureEightThatItEnclosesNothing)
{
    const std::string eight = noteOf({through({{0.1, 0.2}, {0.9, 0.8}, {0.9, 0.2}, {0.1, 0.8}}, true)});
    EXPECT_EQ(eight.find("enclose nothing"), std::string::npos) << eight;
    EXPECT_NE(eight.find("trim loops that cross; what lies in two of them, or twice in one, is cut out, the "
                         "rest is shown: plate. Mend them"),
              std::string::npos)
        << eight;
    const std::string there = noteOf({square(0, 1, true), through({{0.1, 0.2}, {0.9, 0.7}}, false)});
    EXPECT_NE(there.find("trim loops that enclose nothing and change nothing: plate."), std::string::npos)
        << there;
}

TEST(LoopNotes, NameDistancesInWordsThatCanBeRead)
{
    TrimLoop open = square(0.1, 0.6, true);
    open.curves.pop_back();
    const std::string note = noteOf({open});
    EXPECT_NE(
        note.find("trim loops that do not close (by up to 50 % of the surface) and is shown whole: plate. "
                  "Mend them"),
        std::string::npos)
        << note;
    for (const auto& [reach, words] :
         std::vector<std::pair<double, std::string>>{{1.15, "15 % of the surface"},
                                                     {1.999, "about the surface's size"},
                                                     {2.5, "1.5 times the surface's size"},
                                                     {500, "far more than the surface's size"}}) {
        const std::string beyond =
            noteOf({through({{0.1, 0.1}, {reach, 0.1}, {reach, 0.9}, {0.1, 0.9}}, true)});
        EXPECT_NE(beyond.find("reach up to " + words + " beyond it"), std::string::npos) << beyond;
        for (const char* wrong : {"inf", "nan", "e+"})
            EXPECT_EQ(beyond.find(wrong), std::string::npos) << beyond;
    }
    TrimLoop endless = through({{0.1, 0.1}, {1e200, 0.1}}, true);
    endless.curves.pop_back();
    EXPECT_NE(noteOf({endless}).find("(by up to far more than the surface's size)"), std::string::npos)
        << noteOf({endless});
}

// Reads what `scene` is in a file: loops are turned there.
Scene throughAFile(const Scene& scene)
{
    const TemporaryFolder folder;
    EXPECT_TRUE(write(scene, folder / "a.knotspan"));
    return find("a.knotspan")->read(folder / "a.knotspan").value().scene;
}

TEST(LoopDirection, LoopsOfAFileThatRunTheWrongWayAreTurnedOnReading)
{
    TrimLoop outer = square(0.1, 0.9, false);
    outer.outer = true;
    TrimLoop hole = square(0.3, 0.5, true);
    hole.outer = false;
    const Scene scene = throughAFile(plateWith({outer, hole}));
    const SceneObject& object = *scene.objects().begin()->second;
    ASSERT_EQ(object.trimLoops.size(), 2U);
    EXPECT_NEAR(signedArea(object.trimLoops[0].curves), 0.64, 1e-15);
    EXPECT_NEAR(signedArea(object.trimLoops[1].curves), -0.04, 1e-15);
    EXPECT_EQ(throughAFile(scene).objects().begin()->second->trimLoops, object.trimLoops) << "once is enough";
    const TemporaryFolder folder;
    for (const std::string extension : {".step", ".igs", ".brep", ".obj", ".knotspan"}) {
        const auto verified = writeVerified(scene, folder / ("a" + extension));
        EXPECT_TRUE(verified) << extension << ": " << (verified ? "" : verified.error().sentence());
    }
}

TEST(LoopDirection, LoopsThatDoNotCloseInThePlaneStayAsTheyAre)
{
    TrimLoop around = through({{0, 0.5}, {1, 0.5}}, false);  // around a surface that is closed along u
    around.curves.pop_back();
    EXPECT_EQ(oriented(around), around);
    const TrimLoop nothing = through({{0.1, 0.1}, {0.7, 0.5}}, true);
    EXPECT_EQ(oriented(nothing), nothing);
    EXPECT_EQ(oriented(TrimLoop{true, {}}), (TrimLoop{true, {}}));
    EXPECT_EQ(oriented(square(0.2, 0.3, true)), square(0.2, 0.3, true));
}

}  // namespace
}  // namespace knotspan::formats
