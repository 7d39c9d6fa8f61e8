#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "model/formats/format_list.h"
#include "model/geometry/primitives.h"
#include "model/samples/sample_list.h"
#include "tests/support.h"

namespace knotspan {
namespace {

// == takes 0.0 and -0.0 for one; bits do not.
bool sameBits(double a, double b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST(KnotspanFormat, SavesAndReadsEverySampleToTheBit)
{
    const testing::TemporaryFolder folder;
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        const auto path = folder / (sample.name + ".knotspan");
        const auto written = formats::write(scene, path);
        ASSERT_TRUE(written) << written.error().sentence();
        const auto read = formats::read(path);
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_TRUE(*read == scene) << sample.name;

        const std::string text = testing::readFile(path);
        ASSERT_TRUE(formats::write(*read, path));
        EXPECT_EQ(testing::readFile(path), text) << sample.name;
    }
}

// Every kind of number a double can be.
std::vector<double> peculiarNumbers()
{
    using Limits = std::numeric_limits<double>;
    return {-0.0,
            0.1,
            1.0 / 3,
            Limits::denorm_min(),
            -3 * Limits::denorm_min(),
            Limits::min(),
            Limits::max(),
            -Limits::max(),
            1 + Limits::epsilon(),
            9007199254740993.0,
            123456789012345680.0,
            5e-324,
            2.2250738585072011e-308,
            8.41e21,
            -1.7976931348623157e308,
            4.35};
}

TEST(KnotspanFormat, KeepsPeculiarNumbersToTheBit)
{
    const auto numbers = peculiarNumbers();
    std::vector<ControlPoint> points;
    for (const double number : numbers)
        points.push_back({{number, -number, number * 0.5}, number > 0 ? number : 1.0});
    const auto surface =
        NurbsSurface::create(KnotVector::clampedUniform(3, 1), KnotVector::clampedUniform(3, 1), points);
    ASSERT_TRUE(surface);
    Scene scene;
    SceneObject object{"peculiar", {0.1, 1.0 / 3, 5e-324}, Mat4(1.0), false, *surface, {}};
    object.transform[3] = Vec4(-0.0, 1e-310, 12345.678901234567, 1);
    scene.add(object);

    const testing::TemporaryFolder folder;
    ASSERT_TRUE(formats::write(scene, folder / "peculiar.knotspan"));
    const auto read = formats::read(folder / "peculiar.knotspan");
    ASSERT_TRUE(read) << read.error().sentence();
    const SceneObject& back = *read->find(ObjectId{0});
    EXPECT_EQ(back, object);
    for (size_t i = 0; i < numbers.size(); ++i) {
        const ControlPoint& point = back.surface.controlPoints()[i];
        EXPECT_TRUE(sameBits(point.position.x, points[i].position.x)) << i;
        EXPECT_TRUE(sameBits(point.position.y, points[i].position.y)) << i;
        EXPECT_TRUE(sameBits(point.position.z, points[i].position.z)) << i;
        EXPECT_TRUE(sameBits(point.weight, points[i].weight)) << i;
    }
    EXPECT_TRUE(sameBits(back.transform[3].x, -0.0));
}

TEST(KnotspanFormat, KeepsTrimLoopsNamesUnitsAndTransforms)
{
    const auto line = [](Vec2 from, Vec2 to) {
        return *TrimCurve::create(KnotVector::clampedUniform(1, 1), {{from, 1}, {to, 1}});
    };
    const auto arc = *TrimCurve::create(KnotVector::clampedUniform(2, 1),
                                        {{{1, 1.0 / 3}, 1}, {{1.1, 0.9}, std::sqrt(0.5)}, {{0.2, 1}, 1}});
    SceneObject object{
        "Spant № 3 \"Bug\"\n\\ 船", {0.1, 0.2, 0.3}, Mat4(2.5), true, sphere({1, 2, 3}, 0.7), {}};
    object.transform[3] = Vec4(4, 5, 6, 1);
    object.transform[0] = Vec4(0.1, 0.7, -0.3, 0);
    object.trimLoops = {{true, {line({0, 0}, {1, 1.0 / 3}), arc, line({0.2, 1}, {0, 0})}}, {false, {arc}}};
    object.sides = Sides::back;
    Scene scene;
    scene.setUnits("in");
    scene.add(object);

    const testing::TemporaryFolder folder;
    ASSERT_TRUE(formats::write(scene, folder / "a.knotspan"));
    const auto read = formats::read(folder / "a.knotspan");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(*read == scene);
    EXPECT_EQ(read->units(), "in");
    EXPECT_EQ(read->find(ObjectId{0})->trimLoops, object.trimLoops);
}

TEST(KnotspanFormat, WritesTheMembersThatTheDesignNames)
{
    const testing::TemporaryFolder folder;
    ASSERT_TRUE(formats::write(findSample("sphere")->make(), folder / "s.knotspan"));
    const auto json = nlohmann::json::parse(testing::readFile(folder / "s.knotspan"));
    EXPECT_EQ(json["format"], "knotspan");
    EXPECT_EQ(json["version"], 1);
    EXPECT_EQ(json["units"], "mm");
    const auto& surface = json["objects"][0]["surface"];
    EXPECT_EQ(surface["degree_u"], 2);
    EXPECT_EQ(surface["knots_v"].size(), 12u);
    EXPECT_EQ(surface["control_points"].size(), 153u);
    EXPECT_EQ(surface["control_points"][0], (std::vector<double>{0, 0, -1, 1}));
}

TEST(KnotspanFormat, ReadsAnEmptyScene)
{
    const testing::TemporaryFolder folder;
    ASSERT_TRUE(formats::write(Scene(), folder / "empty.knotspan"));
    const auto read = formats::read(folder / "empty.knotspan");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(*read == Scene());
}

TEST(KnotspanFormat, IsFoundByItsExtensionInUpperOrLowerCase)
{
    ASSERT_NE(formats::find("a/b.knotspan"), nullptr);
    EXPECT_EQ(formats::find("a/b.KnotSpan"), formats::find("a/b.knotspan"));
    EXPECT_EQ(formats::find("a/b.xyz"), nullptr);
    EXPECT_EQ(formats::find("a/knotspan"), nullptr);
}

}  // namespace
}  // namespace knotspan
