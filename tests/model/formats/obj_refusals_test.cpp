// What is no OBJ file with free-form surfaces is refused with a sentence that names the line.
#include <chrono>

#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "obj_text.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using testing::polygon;
using testing::refusal;
using testing::sixPointSurface;
using testing::sixVertices;

constexpr const char* kAgain = ". Export or copy the model again.";

TEST(ObjRefusals, NameTheLineOfWhatCannotBeUnderstood)
{
    const std::pair<const char*, const char*> cases[] = {
        {"v 1 2", "line 1: The coordinate z is missing"},
        {"v 1 2 x", "line 1: The coordinate z is no finite number, but \"x\""},
        {"\n\nv 1 nan 3", "line 3: The coordinate y is no finite number, but \"nan\""},
        {"v inf 1 1", "line 1: The coordinate x is no finite number, but \"inf\""},
        {"v 1e999 1 1", "line 1: The coordinate x is no finite number, but \"1e999\""},
        {"v 1,5 1 1", "line 1: The coordinate x is no finite number, but \"1,5\""},
        {"v 1 1 1 1 1", "line 1: A vertex has five numbers"},
        {"vp", "line 1: The parameter u is missing"},
        {"hello", "line 1: \"hello\" is no statement of OBJ files"},
        {"\x01\x80zzz", "line 1: \"??zzz\" is no statement of OBJ files"},
        {"deg two", "line 1: The degree is no whole number, but \"two\""},
        {"surf 0 1 0 1 1", "line 1: The kind of curve (cstype) is not stated before"},
        {"parm u 0 1", "line 1: This statement belongs between surf or curv2 and end"},
        {"end", "line 1: This statement belongs between surf or curv2 and end"},
        {"cstype bspline\nsurf 0 1 0 1 1", "line 2: There is no control point 1: up to here there are 0"},
        {"v 0 0 0\ncstype bspline\nsurf 0 1 0 1 1 -2",
         "line 3: There is no control point -2: up to here there are 1"},
        {"v 0 0 0\ncstype bspline\nsurf 0 1 0 1 0",
         "line 3: There is no control point 0: up to here there are 1"},
        {"v 0 0 0\ncstype bspline\nsurf 0 1 0 1 1 \\\n 99999999999999999999",
         "line 4: The number of a control point is none, but \"99999999999999999999\""},
        {"cstype bspline\nsurf 0 1 0", "line 2: The end of v is missing"},
        {"cstype bspline\nsurf 0 1 0 1\nparm w 0 1", "line 3: The direction is neither u nor v, but \"w\""},
        {"cstype bspline\nsurf 0 1 0 1\nparm u 0 1\nparm u 1", "line 4: The parameters along u stand twice"},
        {"cstype bspline\nsurf 0 1 0 1\ntrim 0 1 1",
         "line 3: There is no trimming curve 1: up to here there are 0"},
        {"cstype bspline\nsurf 0 1 0 1\ntrim", "line 3: The loop has no trimming curves"},
        {"cstype bspline\nsurf 0 1 0 1\ntrim 0 1", "line 3: The number of the trimming curve is missing"},
        {"cstype bspline\nsurf 0 1 0 1\nv 0 0 0\n", "line 2: What begins here has no end statement"},
        {"cstype bspline\nsurf 0 1 0 1\nsurf 0 1 0 1\n", "line 2: What begins here has no end statement"},
    };
    for (const auto& [text, sentence] : cases)
        EXPECT_EQ(refusal(text), std::string(sentence) + kAgain) << text;
}

TEST(ObjRefusals, SayWhichKindsOfCurvesAreRead)
{
    for (const std::string kind : {"bmatrix", "cardinal", "taylor"}) {
        EXPECT_EQ(refusal("# x\ncstype rat " + kind), "line 2: Curves and surfaces of the kind \"" + kind +
                                                          "\" are not read, only bspline and bezier. Export "
                                                          "them as B-splines.");
    }
}

// The reason why the only surface is none.
std::string fault(const std::string& text)
{
    const std::string sentence = refusal(text);
    const std::string begin = "None of the file's 1 surfaces can be read; the first reason is: ";
    const std::string end = ". Repair the model in the program that made it.";
    if (sentence.rfind(begin, 0) != 0 || sentence.size() < begin.size() + end.size())
        return "other: " + sentence;
    return sentence.substr(begin.size(), sentence.size() - begin.size() - end.size());
}

std::string surfaceWith(const std::string& basis, const std::string& range, const std::string& parameters)
{
    return sixVertices() + basis + "\nsurf " + range + " 1 2 3 4 5 6\n" + parameters + "\nend\n";
}

TEST(ObjRefusals, SayWhyASurfaceIsNone)
{
    const std::string spline = "cstype bspline\ndeg 2 1";
    const std::string bezier = "cstype bezier\ndeg 2 1";
    const std::string knots = "parm u 0 0 0 1 1 1\nparm v 0 0 1 1";
    EXPECT_EQ(fault(surfaceWith(spline, "0 1 0 1", knots)), "other: ");
    EXPECT_EQ(fault(surfaceWith("cstype bspline", "0 1 0 1", knots)),
              "line 8: Its degree (deg) along u is not from 1 to 15");
    EXPECT_EQ(fault(surfaceWith("cstype bspline\ndeg 2", "0 1 0 1", knots)),
              "line 9: Its degree (deg) along v is not from 1 to 15");
    EXPECT_EQ(fault(surfaceWith(spline, "0 1 0 1", "parm v 0 0 1 1")),
              "line 9: Its parameters along u (parm u) are missing");
    EXPECT_EQ(fault(surfaceWith(spline, "0 1 0 1", "parm u 0 0 0 1 1 1\nparm v 0 0 1 2 2")),
              "line 9: Its parameters ask for 3 x 3 control points, but there are 6");
    EXPECT_EQ(fault(surfaceWith(spline, "0 1 0 1", "parm u 0 0 1 0 1 1\nparm v 0 0 1 1")),
              "line 9: Knot 3 is smaller than the one before it");
    EXPECT_EQ(fault(surfaceWith(spline, "0 1.1 0 1", knots)),
              "line 9: The range 0 to 1.1 leaves the knots' domain 0 to 1");
    EXPECT_EQ(fault(surfaceWith(spline, "0.5 0.5 0 1", knots)), "line 9: The range 0.5 to 0.5 is empty");
    EXPECT_EQ(fault(surfaceWith(spline, "0 1 1 0", knots)), "line 9: The range 1 to 0 is empty");
    EXPECT_EQ(fault(surfaceWith(bezier, "0 1 0 1", "parm u 0\nparm v 0 1")),
              "line 9: A Bezier curve or surface needs two parameters or more in each direction");
    EXPECT_EQ(fault(surfaceWith(bezier, "0 1 0 1", "parm u 0 0\nparm v 0 1")),
              "line 9: Parameter 1 is not above the one before it");
    EXPECT_EQ(fault(surfaceWith(bezier, "0 1 0 1", "parm u 0 1 2 3\nparm v 0 1")),
              "line 9: 3 Bezier pieces of degree 2 need more than its 6 control points");
    const std::string heavy =
        "v 0 0 0 -1\nv 1 0 0\nv 0 1 0\nv 1 1 0\ncstype rat bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 "
        "4\nparm u 0 0 1 1\nparm v 0 0 1 1\nend";
    EXPECT_EQ(fault(heavy), "line 7: Control point (0, 0) has a weight that is not above zero");
    const std::string extreme =
        "v 1e308 0 0\nv -1e308 0 0\nv 0 1 0\nv 1 1 0\ncstype rat bspline\ndeg 1 1\nsurf 0.1 0.9 0 1 "
        "1 2 3 4\nparm u 0 0 1 1\nparm v 0 0 1 1\nend";
    EXPECT_EQ(fault(extreme), "line 7: Its range is a part of its knots' domain, and its numbers are too "
                              "extreme to cut it");
}

TEST(ObjRefusals, SayWhatIsInAFileWithoutAModel)
{
    const std::string nothing = "The file holds neither free-form surfaces nor polygons. Choose another file.";
    EXPECT_EQ(refusal(""), nothing);
    EXPECT_EQ(refusal(polygon("0 0 1 1")), nothing);
    EXPECT_EQ(refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"),
              std::string("line 4: A polygon has fewer than three corners") + kAgain);
    EXPECT_EQ(refusal("v 0 0 0\nv 1 0 0\nf 1 2 3\n"),
              std::string("line 3: There is no vertex 3: up to here there are 2") + kAgain);
}

TEST(ObjRefusals, EndFilesThatWouldExhaustMemory)
{
    std::string uses;
    for (int k = 0; k < 10'000'001; ++k)
        uses += "1 ";
    EXPECT_EQ(refusal("v 0 0 0\ncstype bspline\ndeg 1 1\nsurf 0 1 0 1 " + uses),
              "line 4: The file has more than 10000000 control points. Split the model into several files.");
    EXPECT_EQ(refusal("cstype bspline\nsurf 0 1 0 1\nparm u " + uses),
              "line 3: The file has more than 10000000 parameters. Split the model into several files.");
    // A loop that takes a curve of 3000 points again and again.
    std::string places;
    for (int k = 0; k < 3000; ++k)
        places += std::to_string(k % 2) + " 0 ";
    std::string loop = "trim";
    for (int k = 0; k < 340; ++k)
        loop += " 0 2999 1";
    EXPECT_EQ(refusal(sixVertices() + polygon(places) + sixPointSurface(loop + "\n")),
              "line 3017: The file uses its trimming curves too often. Split the model into several files.");
}

TEST(ObjRefusals, AndNamesStayShortHoweverLongTheLinesAre)
{
    const std::string longName(3'000'000, 'n');
    const Scene scene = testing::sceneOf("o " + longName + "\n" + sixVertices() + sixPointSurface());
    ASSERT_EQ(scene.objects().size(), 1u);
    EXPECT_EQ(scene.objects().begin()->second->name, std::string(255, 'n'));
    EXPECT_EQ(refusal(longName),
              "line 1: \"nnnnnnnnnnnnnnnnnnnnnnnn...\" is no statement of OBJ files" + std::string(kAgain));
}

TEST(ObjRefusals, NameTheFileToo)
{
    const testing::TemporaryFolder folder;
    testing::writeFile(folder / "a.obj", "v 1 2\n");
    const auto read = formats::read(folder / "a.obj");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().sentence(),
              (folder / "a.obj").string() + ", line 1: The coordinate z is missing" + kAgain);
}

}  // namespace
}  // namespace knotspan
