// Frame::wave: the control points move on the device, and come back to where they were.
#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "model/scene/deformation.h"
#include "tests/renderer/render_support.h"

#include <algorithm>
#include <array>

#include <glm/gtc/matrix_transform.hpp>

namespace knotspan::testing {
namespace {

class WaveOnDevice : public ::testing::Test {
protected:
    void SetUp() override
    {
        renderer = sharedRenderer();
        if (renderer == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        SceneObject turned = *scene.objects().begin()->second;
        turned.transform = glm::translate(Mat4(1), Vec3(3, 1, 1)) *
                           glm::rotate(Mat4(1), 1.2, Vec3(1, 2, 0.5)) *
                           glm::scale(Mat4(1), Vec3(0.7, -1.3, 0.9));
        scene.add(turned);
        frame = frameOf(scene, renderer->bestPath());
    }

    // Every coordinate of every vertex, in an order that does not depend on the device's.
    [[nodiscard]] std::vector<std::array<double, 7>> vertices() const
    {
        const auto captured = renderer->captureVertices(frame);
        std::vector<std::array<double, 7>> list;
        if (!captured) {
            ADD_FAILURE() << captured.error().sentence();
            return list;
        }
        for (const CapturedVertex& vertex : *captured)
            list.push_back({static_cast<double>(vertex.spanU), static_cast<double>(vertex.spanV), vertex.u,
                            vertex.v, vertex.position.x, vertex.position.y, vertex.position.z});
        std::sort(list.begin(), list.end());
        return list;
    }
    [[nodiscard]] Scene edited() const
    {
        Scene result = scene;
        const ObjectId id = scene.objects().begin()->first;
        const SharedObject before = scene.find(id);
        result.exchange(
            id, withControlPointAt(*before, {4, 5}, controlPointInModel(*before, {4, 5}) + Vec3(0.1, 0, 0.4))
                    .value());
        return result;
    }
    // Drawn by a wave on the device, and with the scene that the CPU made of it.
    [[nodiscard]] Difference differenceFromCpu(const Scene& rest, int step)
    {
        frame.wave = waveAt(rest, Deformation::all, step);
        const Drawn onDevice = drawn(*renderer, rest, frame);
        frame.wave.reset();
        const Picture byCpu = drawn(*renderer, deformed(rest, Deformation::all, step), frame).picture;
        return compare(onDevice.picture, byCpu);
    }

    Renderer* renderer = nullptr;
    Scene scene = findSample("single-100")->make();
    Frame frame;
};

TEST_F(WaveOnDevice, DrawsWhatTheDeformedSceneDraws)
{
    const Picture rest = drawn(*renderer, scene, frame).picture;
    for (const int step : {9, 16, 40}) {
        const Difference difference = differenceFromCpu(scene, step);
        EXPECT_EQ(difference.silhouetteOff, 0U) << step;
        EXPECT_LT(difference.meanShaded, 0.05) << step;
        const Picture moved = drawn(*renderer, deformed(scene, Deformation::all, step), frame).picture;
        EXPECT_GT(compare(rest, moved).meanShaded, 0.2) << "the wave is too small for this test to see";
    }
}

TEST_F(WaveOnDevice, LeavesTheModelAsItWasToTheBit)
{
    ASSERT_TRUE(renderer->sync(scene));
    const auto before = vertices();
    for (const int step : {3, 20}) {
        frame.wave = waveAt(scene, Deformation::all, step);
        EXPECT_NE(vertices(), before);
    }
    frame.wave.reset();
    EXPECT_FALSE(before.empty());
    EXPECT_EQ(vertices(), before);
}

TEST_F(WaveOnDevice, TakesAnEditWhileItMoves)
{
    ASSERT_TRUE(renderer->sync(Scene()));
    ASSERT_TRUE(renderer->sync(scene));
    (void)drawn(*renderer, edited(), frame);
    const auto wanted = vertices();

    ASSERT_TRUE(renderer->sync(Scene()));
    ASSERT_TRUE(renderer->sync(scene));
    frame.wave = waveAt(scene, Deformation::all, 7);
    const auto moving = vertices();
    const Difference difference = differenceFromCpu(edited(), 8);
    EXPECT_EQ(difference.silhouetteOff, 0U);
    EXPECT_LT(difference.meanShaded, 0.05);

    ASSERT_TRUE(renderer->sync(Scene()));
    ASSERT_TRUE(renderer->sync(scene));
    frame.wave = waveAt(scene, Deformation::all, 7);
    EXPECT_EQ(vertices(), moving);
    (void)drawn(*renderer, edited(), frame);
    frame.wave.reset();
    EXPECT_EQ(vertices(), wanted);
}

// Objects that come and go, and another path that moves its points itself, in the middle of it.
TEST_F(WaveOnDevice, EndsWithTheSceneThatItMoved)
{
    ASSERT_TRUE(renderer->sync(scene));
    const auto before = vertices();
    frame.wave = waveAt(scene, Deformation::all, 7);
    (void)drawn(*renderer, scene, frame);
    Scene fewer = scene;
    fewer.exchange(scene.objects().rbegin()->first, nullptr);
    (void)drawn(*renderer, fewer, frame);
    (void)drawn(*renderer, scene, frame);
    if (renderer->whyUnavailable(PathId::bezier).empty()) {
        Frame other = frame;
        other.path = PathId::bezier;
        const Picture still = drawn(*renderer, scene, other).picture;
        other.wave.reset();
        EXPECT_EQ(drawn(*renderer, scene, other).picture.rgba, still.rgba);
    }
    frame.wave.reset();
    EXPECT_EQ(vertices(), before);
}

}  // namespace
}  // namespace knotspan::testing
