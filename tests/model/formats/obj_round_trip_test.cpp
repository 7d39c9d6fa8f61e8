// What is written as OBJ is read as the same model.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "model/geometry/primitives.h"
#include "model/samples/sample_list.h"
#include "tests/support.h"

namespace knotspan {
namespace {

Scene writtenAndRead(const Scene& scene)
{
    const testing::TemporaryFolder folder;
    const auto written = formats::write(scene, folder / "a.obj");
    EXPECT_TRUE(written) << written.error().sentence();
    auto read = formats::readWithNotes(folder / "a.obj");
    EXPECT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(!read || read->notes.empty());
    return read ? std::move(read->scene) : Scene();
}

double largest(const Vec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

void expectSamePoints(const SceneObject& object, const NurbsSurface& back)
{
    ASSERT_EQ(back.controlPoints().size(), object.surface.controlPoints().size());
    const Box box = object.bounds();
    const double size = std::max(largest(box.low), largest(box.high));
    for (size_t k = 0; k < back.controlPoints().size(); ++k) {
        const ControlPoint& point = object.surface.controlPoints()[k];
        EXPECT_EQ(back.controlPoints()[k].weight, point.weight);
        const Vec3 gap = back.controlPoints()[k].position - transformed(point.position, object.transform);
        EXPECT_LE(largest(gap), 1e-12 * size);
    }
}

void expectSame(const Scene& scene, const Scene& back)
{
    ASSERT_EQ(back.objects().size(), scene.objects().size());
    auto other = back.objects().begin();
    for (const auto& [id, object] : scene.objects()) {
        const SceneObject& found = *(other++)->second;
        EXPECT_EQ(found.name, object->name);
        EXPECT_EQ(found.surface.knotsU(), object->surface.knotsU());
        EXPECT_EQ(found.surface.knotsV(), object->surface.knotsV());
        EXPECT_EQ(found.trimLoops, object->trimLoops);
        expectSamePoints(*object, found.surface);
        if (object->transform == Mat4(1.0)) {
            EXPECT_EQ(found.surface, object->surface);
        }
    }
}

TEST(ObjRoundTrip, KeepsEverySample)
{
    for (const Sample& sample : samples()) {
        SCOPED_TRACE(sample.name);
        const Scene scene = sample.make();
        expectSame(scene, writtenAndRead(scene));
    }
}

SceneObject trimmedSphere()
{
    const auto line = [](Vec2 from, Vec2 to) {
        return *TrimCurve::create(KnotVector::clampedUniform(1, 1), {{from, 1}, {to, 1}});
    };
    const auto arc = *TrimCurve::create(KnotVector::clampedUniform(2, 1),
                                        {{{1, 1.0 / 3}, 1}, {{1.1, 0.9}, std::sqrt(0.5)}, {{0.2, 1}, 1}});
    const auto unclamped = *TrimCurve::create(
        *KnotVector::create(2, {0, 1, 2, 3, 4, 5, 6, 7}),
        {{{0.5, 0.5}, 1}, {{0.4, 0.6}, 1}, {{0.6, 0.7}, 1}, {{0.5, 0.5}, 1}, {{0.4, 0.6}, 1}});
    SceneObject object{"Spant № 3 \"Bug\" 船 \\", {}, Mat4(1.0), false, sphere({1, 2, 3}, 0.7), {}};
    object.trimLoops = {{true, {line({0, 0}, {1, 1.0 / 3}), arc, line({0.2, 1}, {0, 0})}},
                        {false, {unclamped}}};
    return object;
}

TEST(ObjRoundTrip, KeepsTrimLoopsNamesAndHiddenObjects)
{
    Scene scene;
    scene.add(trimmedSphere());
    scene.add({"plain", {}, Mat4(1.0), true, trimmedSphere().surface, {}});
    expectSame(scene, writtenAndRead(scene));
}

TEST(ObjRoundTrip, AppliesTransforms)
{
    Scene scene;
    SceneObject object = trimmedSphere();
    object.transform = glm::rotate(glm::translate(Mat4(1.0), Vec3(100, -20, 3e4)), 0.3, Vec3(1, 2, 3));
    object.transform = glm::scale(object.transform, Vec3(-2, 3, 0.1));
    scene.add(object);
    const Scene back = writtenAndRead(scene);
    expectSame(scene, back);
    EXPECT_EQ(back.objects().begin()->second->transform, Mat4(1.0));
}

TEST(ObjRoundTrip, KeepsPeculiarNumbersAndCommonWeights)
{
    std::vector<ControlPoint> points;
    for (const double number : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -1.7976931348623157e308, 4.35,
                                123456789012345680.0, 2.2250738585072011e-308, 1e22})
        points.push_back({{number, -number, number * 0.5}, 2.5});
    const auto surface = NurbsSurface::create(KnotVector::clampedUniform(2, 1),
                                              *KnotVector::create(2, {-1e9, -1e9, 0, 1e-9, 1, 1}), points);
    ASSERT_TRUE(surface);
    Scene scene;
    scene.add({"peculiar", {}, Mat4(1.0), true, *surface, {}});
    expectSame(scene, writtenAndRead(scene));
}

TEST(ObjRoundTrip, NamesObjectsThatHaveNoNameAndKeepsNamesOnOneLine)
{
    Scene scene;
    scene.add({"", {}, Mat4(1.0), true, sphere({1, 2, 3}, 0.7), {}});
    scene.add({"two\nlines", {}, Mat4(1.0), true, sphere({1, 2, 3}, 0.7), {}});
    const Scene back = writtenAndRead(scene);
    ASSERT_EQ(back.objects().size(), 2u);
    EXPECT_EQ(back.find(ObjectId{0})->name, "Surface 1");
    EXPECT_EQ(back.find(ObjectId{1})->name, "two lines");
}

TEST(ObjRoundTrip, RefusesToWriteWhatIsTooFarAway)
{
    Scene scene;
    scene.add({"far", {}, Mat4(1.0), true, sphere({0, 0, 0}, 1e300), {}});
    SceneObject object = *scene.find(ObjectId{0});
    object.transform = glm::scale(Mat4(1.0), Vec3(1e10));
    scene.exchange(ObjectId{0}, std::make_shared<SceneObject>(object));
    const testing::TemporaryFolder folder;
    const auto written = formats::write(scene, folder / "a.obj");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().what, "The control points of \"far\" are too far away to be written");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.obj"));
}

TEST(ObjRoundTrip, FailsWithASentenceWhenTheDiskIsFull)
{
    if (!std::filesystem::exists("/dev/full"))
        GTEST_SKIP() << "no full device here";
    const auto result = formats::find("a.obj")->write(findSample("hull")->make(), "/dev/full");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().sentence(),
              "The file cannot be written. Check that the disk has room and try again.");
}

}  // namespace
}  // namespace knotspan
