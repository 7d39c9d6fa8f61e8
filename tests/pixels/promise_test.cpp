// The promise: no pixel further from the truth than the tolerance and no background inside a closed model, on
// every path whose own rule is the error bound. KNOTSPAN_SWEEP=100 takes the whole sweep, 100 views of each
// sample at each tolerance; without it a part of it.
#include "model/samples/sample_list.h"
#include "tests/pixels/error_measurement.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

constexpr double kTolerances[] = {0.25, 0.5, 1, 4};

bool isClosedSample(const std::string& name)
{
    return name == "torus" || name == "sphere" || name == "knot";
}

// Where the eye sees each wall of a closed sample from inside, so that background shows through any gap.
Vec3 insideOf(const std::string& name)
{
    if (name == "torus")
        return {2, 0, 0};
    return name == "knot" ? Vec3(3, 0, 0) : Vec3(0.2, 0.1, -0.3);
}

std::string described(const PathInfo& path, int view, double tolerance)
{
    return path.name + ", view " + std::to_string(view) + ", " + std::to_string(tolerance) + " px";
}

void expectAllKept(Renderer& renderer, const Scene& scene, const std::string& closedName, const Frame& frame)
{
    expectPromiseKept(renderer, frame);
    if (!closedName.empty()) {
        EXPECT_EQ(leaks(renderer, scene, frame, frame.tolerancePx), 0U);
    }
}

class Promise : public ::testing::TestWithParam<std::string> {
protected:
    // All tolerances, or one in turn.
    static void look(Renderer& renderer, const Scene& scene, const std::string& closedName,
                     const std::vector<PathInfo>& list, const Camera& camera, int view)
    {
        Frame frame;
        frame.camera = camera;
        frame.width = isWholeSweep() ? 640 : 240;
        frame.height = isWholeSweep() ? 480 : 180;
        for (const PathInfo& path : list)
            for (int k = 0; k < 4; ++k) {
                if (!isWholeSweep() && (view + static_cast<int>(path.id)) % 4 != k)
                    continue;
                frame.path = path.id;
                frame.tolerancePx = kTolerances[k];
                SCOPED_TRACE(described(path, view, frame.tolerancePx));
                expectAllKept(renderer, scene, closedName, frame);
            }
    }
};

TEST_P(Promise, IsKeptFromAnywhere)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const std::vector<PathInfo> list = boundPaths(*renderer);
    if (list.empty())
        GTEST_SKIP() << "no path here samples by the error bound";
    const Scene scene = findSample(GetParam())->make();
    ASSERT_TRUE(renderer->sync(scene));
    std::mt19937 random(17);
    for (int view = 0; view < sweepViews(GetParam() == "knot" ? 3 : 8); ++view)
        look(*renderer, scene, isClosedSample(GetParam()) ? GetParam() : "", list,
             randomCamera(random, scene.bounds()), view);
}

std::vector<std::string> sampleNames(bool closed)
{
    std::vector<std::string> list;
    for (const Sample& sample : samples())
        if (!closed || isClosedSample(sample.name))
            list.push_back(sample.name);
    return list;
}

std::string testName(const ::testing::TestParamInfo<std::string>& test)
{
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Sample, Promise, ::testing::ValuesIn(sampleNames(false)), testName);

class ClosedSample : public Promise {};

TEST_P(ClosedSample, ShowsNoBackgroundFromInside)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const std::vector<PathInfo> list = boundPaths(*renderer);
    if (list.empty())
        GTEST_SKIP() << "no path here samples by the error bound";
    const Scene scene = findSample(GetParam())->make();
    ASSERT_TRUE(renderer->sync(scene));
    std::mt19937 random(18);
    for (int view = 0; view < sweepViews(4); ++view) {
        Camera camera = randomCamera(random, scene.bounds());
        camera.orthographic = false;
        camera.target += insideOf(GetParam()) - camera.eye;
        camera.eye = insideOf(GetParam());
        camera.verticalFovDegrees = 75;
        look(*renderer, scene, GetParam(), list, camera, view);
    }
}

INSTANTIATE_TEST_SUITE_P(Sample, ClosedSample, ::testing::ValuesIn(sampleNames(true)), testName);

// Property: whatever the degrees, knots, weights and view.
TEST(Promise, IsKeptOnRandomSurfaces)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const std::vector<PathInfo> list = boundPaths(*renderer);
    if (list.empty())
        GTEST_SKIP() << "no path here samples by the error bound";
    std::mt19937 random(19);
    for (int run = 0; run < sweepViews(10); ++run) {
        RandomSurfaceShape shape;
        shape.degreeU = static_cast<int>(randomBetween(random, 1, 6.99));
        shape.degreeV = static_cast<int>(randomBetween(random, 1, 6.99));
        shape.spans = static_cast<int>(randomBetween(random, 1, 4.99));
        shape.rational = randomBetween(random, 0, 1) < 0.6;
        shape.weightRatio = randomBetween(random, 1, 8);
        shape.clamped = randomBetween(random, 0, 1) < 0.7;
        shape.spanRatio = randomBetween(random, 1, 20);
        const Scene scene = sceneOf(randomSurface(random, shape));
        ASSERT_TRUE(renderer->sync(scene));
        Frame frame;
        frame.width = 200;
        frame.height = 150;
        frame.camera = randomCamera(random, scene.bounds(), isWholeSweep() ? 0.1 : 0.5);
        frame.tolerancePx = kTolerances[run % 4];
        for (const PathInfo& path : list) {
            SCOPED_TRACE(described(path, run, frame.tolerancePx) + ", degrees " +
                         std::to_string(shape.degreeU) + " and " + std::to_string(shape.degreeV));
            frame.path = path.id;
            expectPromiseKept(*renderer, frame);
        }
    }
}

}  // namespace
}  // namespace knotspan::testing
