// Each statement of OBJ files that makes a surface.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/formats/obj_format.h"
#include "model/geometry/evaluation.h"
#include "obj_text.h"

namespace knotspan {
namespace {

using testing::onlySurfaceOf;
using testing::sceneOf;
using testing::sixPointSurface;
using testing::sixVertices;

TEST(ObjSurfaces, HaveTheirControlPointsWithUFastest)
{
    const NurbsSurface surface = onlySurfaceOf(sixVertices() + sixPointSurface());
    EXPECT_EQ(surface.degreeU(), 2);
    EXPECT_EQ(surface.degreeV(), 1);
    ASSERT_EQ(surface.countU(), 3);
    ASSERT_EQ(surface.countV(), 2);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 2; ++j)
            EXPECT_EQ(surface.controlPoint(i, j), (ControlPoint{Vec3(i, j, i * j), 1})) << i << ", " << j;
    EXPECT_EQ(surface.knotsU().values(), (std::vector<double>{0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(surface.knotsV().values(), (std::vector<double>{0, 0, 1, 1}));
}

TEST(ObjSurfaces, AreTheSameHoweverTheTextIsLaidOut)
{
    const NurbsSurface plain = onlySurfaceOf(sixVertices() + sixPointSurface());
    const std::string windows = "\xEF\xBB\xBF";
    std::string text =
        "# a comment with a backslash \\\r\n\r\n" + sixVertices() +
        "\tcstype   bspline # comment\n\n deg 2 \\\n 1\nsurf +0 1.0 0e5 .1e1 -6/1/1 2//3 \\\r\n"
        "3/4 \\\n-3 5\\\n6\nparm u 0 0 0\\\n 1 1 1\nparm v 0 0 +1 1.\nend";
    EXPECT_EQ(onlySurfaceOf(text), plain);
    std::string crlf;
    std::string cr;
    for (const char c : sixVertices() + sixPointSurface()) {
        crlf += c == '\n' ? "\r\n" : std::string(1, c);
        cr += c == '\n' ? '\r' : c;
    }
    EXPECT_EQ(onlySurfaceOf(crlf), plain);
    EXPECT_EQ(onlySurfaceOf(cr), plain);
    EXPECT_EQ(onlySurfaceOf(windows + sixVertices() + sixPointSurface()), plain);
}

TEST(ObjSurfaces, AreRationalOnlyWhereTheFileSaysSo)
{
    const double half = std::sqrt(0.5);
    const std::string vertices = "v 1 0 0 1\nv 1 1 0 0.7071067811865476\nv 0 1 0 1\n"
                                 "v 1 0 2 1\nv 1 1 2 0.7071067811865476\nv 0 1 2\n";
    const std::string body = " bezier\ndeg 2 1\nsurf 0 1 0 1 1 2 3 4 5 6\nparm u 0 1\nparm v 0 1\nend\n";
    const NurbsSurface arc = onlySurfaceOf(vertices + "cstype rat" + body);
    EXPECT_DOUBLE_EQ(arc.controlPoint(1, 0).weight, half);
    for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const Vec3 at = evaluate(arc, u, 0.25).position;
        EXPECT_NEAR(std::hypot(at.x, at.y), 1, 1e-15);
        EXPECT_NEAR(at.z, 0.5, 1e-15);
    }
    const NurbsSurface parabola = onlySurfaceOf(vertices + "cstype" + body);
    EXPECT_FALSE(parabola.isRational());
    EXPECT_EQ(evaluate(parabola, 0.5, 0).position, Vec3(0.75, 0.75, 0));
}

// De Casteljau by hand: a quadratic piece between two joints, linear in v.
Vec3 pieceAt(const std::vector<Vec3>& net, size_t first, double u, double v)
{
    const auto row = [&](size_t start) {
        const Vec3 a = glm::mix(net[start], net[start + 1], u);
        const Vec3 b = glm::mix(net[start + 1], net[start + 2], u);
        return glm::mix(a, b, u);
    };
    return glm::mix(row(first), row(first + 5), v);
}

TEST(ObjSurfaces, OfSeveralBezierPiecesAreOneSurface)
{
    const std::vector<Vec3> net{{0, 0, 0}, {1, 0, 2}, {2, 0, 0}, {3, 0, 5}, {4, 0, 1},
                                {0, 1, 0}, {1, 1, 1}, {2, 1, 3}, {3, 1, 0}, {4, 1, 0}};
    std::string text;
    for (const Vec3& at : net)
        text += "v " + std::to_string(at.x) + " " + std::to_string(at.y) + " " + std::to_string(at.z) + "\n";
    text += "cstype bezier\ndeg 2 1\nsurf -1 3 0 1 1 2 3 4 5 6 7 8 9 10\nparm u -1 0 3\nparm v 0 1\nend\n";
    const NurbsSurface surface = onlySurfaceOf(text);
    EXPECT_EQ(surface.knotsU().values(), (std::vector<double>{-1, -1, -1, 0, 0, 3, 3, 3}));
    for (const double v : {0.0, 0.3, 1.0}) {
        for (const double u : {0.0, 0.25, 0.8}) {
            EXPECT_LT(glm::distance(evaluate(surface, u - 1, v).position, pieceAt(net, 0, u, v)), 1e-14);
            EXPECT_LT(glm::distance(evaluate(surface, 3 * u, v).position, pieceAt(net, 2, u, v)), 1e-14);
        }
    }
}

TEST(ObjSurfaces, OverAPartOfTheirKnotsAreCutOutExactly)
{
    const std::string vertices =
        "v 0 0 0\nv 1 2 0 2\nv 2 0 1\nv 3 1 0 0.5\nv 0 0 4\nv 1 1 4\nv 2 0 5\nv 3 3 4\n";
    const auto surface = [&](const std::string& range) {
        return onlySurfaceOf(vertices + "cstype rat bspline\ndeg 2 1\nsurf " + range +
                             " 1 2 3 4 5 6 7 8\nparm u 0 0 0 0.5 1 1 1\nparm v 0 0 1 1\nend\n");
    };
    const NurbsSurface whole = surface("0 1 0 1");
    EXPECT_EQ(whole.countU(), 4);
    EXPECT_EQ(surface("1e-12 1.0000001 0 0.9999999999"), whole);  // but for what a program rounded
    const NurbsSurface part = surface("0.25 0.75 0.5 1");
    EXPECT_EQ(part.knotsU().domainStart(), 0.25);
    EXPECT_EQ(part.knotsU().domainEnd(), 0.75);
    EXPECT_EQ(part.knotsV().domainStart(), 0.5);
    for (const double u : {0.25, 0.4, 0.5, 0.75})
        for (const double v : {0.5, 0.7, 1.0})
            EXPECT_LT(glm::distance(evaluate(part, u, v).position, evaluate(whole, u, v).position), 1e-14);
}

TEST(ObjSurfaces, WithoutClampedKnotsStayAsTheyAre)
{
    const NurbsSurface surface =
        onlySurfaceOf(sixVertices() + "cstype bspline\ndeg 2 1\nsurf 2 3 1 2 1 2 3 4 5 6\n"
                                      "parm u 0 1 2 3 4 5\nparm v 0 1 2 3\nend\n");
    EXPECT_EQ(surface.knotsU().values(), (std::vector<double>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(evaluate(surface, 2, 1).position, Vec3(0.5, 0, 0));
}

TEST(ObjSurfaces, HaveTheNameOfTheObjectOrGroupStatedLast)
{
    const Scene scene =
        sceneOf(sixVertices() + sixPointSurface() + "o hull \n" + sixPointSurface() + "g  port side\n" +
                sixPointSurface() + sixPointSurface() + "o caf\xE9\ng default\n" + sixPointSurface() +
                "o Spant № 3 # aft\\\n" + sixPointSurface());
    std::vector<std::string> names;
    for (const auto& [id, object] : scene.objects())
        names.push_back(object->name);
    EXPECT_EQ(names, (std::vector<std::string>{"Surface 1", "hull", "port side", "port side", "café",
                                               "Spant № 3 # aft\\"}));
}

TEST(ObjSurfaces, TakeWeightsAndColoursBehindVerticesForWhatTheyAre)
{
    std::string text =
        "v 0 0 0 0.1 0.2 0.3\nv 1 0 0 2 0.1 0.2 0.3\nv 0 1 0 3\nv 1 1 0\n"
        "cstype rat bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 0 1 1\nparm v 0 0 1 1\nend\n";
    const NurbsSurface surface = onlySurfaceOf(text);
    EXPECT_EQ(surface.controlPoint(0, 0).weight, 1);
    EXPECT_EQ(surface.controlPoint(1, 0).weight, 2);
    EXPECT_EQ(surface.controlPoint(0, 1).weight, 3);
    EXPECT_EQ(surface.controlPoint(1, 1).weight, 1);
}

TEST(ObjSurfaces, StandBesideWhatIsLeftOutAndNoted)
{
    const auto import = formats::sceneFromObj(
        sixVertices() + "vt 0 0\nvn 0 0 1\nusemtl steel\ns 1\nf 1 2 3\nf 1/1/1 2/1/1 3/1/1 4/1/1\nl 1 2\n" +
        "cstype bezier\ndeg 2\ncurv 0 1 1 2 3\nparm u 0 1\nend\n" + sixPointSurface("sp 1 2\nscrv 0 1 1\n") +
        sixPointSurface() + "con 1 0 1 1 2 0 1 1\n" +
        "deg 16 1\nsurf 0 1 0 1 1 2 3 4 5 6\nparm u 0 1\nparm v 0 1\nend\n");
    ASSERT_TRUE(import) << import.error().sentence();
    EXPECT_EQ(import->scene.objects().size(), 2u);
    ASSERT_EQ(import->scene.meshes().size(), 1u);
    EXPECT_EQ(import->scene.meshes().begin()->second->mesh->triangles.size(), 3u);
    EXPECT_EQ(
        import->notes,
        (std::vector<std::string>{
            "1 of 3 surfaces was left out; the first reason is: line 35: Its degree (deg) along u is not "
            "from 1 to 15.",
            "1 line or point of a mesh was left out.", "1 curve in space was left out.", "2 statements about special curves and points were left out.",
            "1 statement about connected edges was left out."}));
}

}  // namespace
}  // namespace knotspan
