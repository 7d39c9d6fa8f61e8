// That the measurement itself tells the truth: it sees errors and holes that are there, and none where there
// are none.
#include <glm/matrix.hpp>

#include "model/samples/sample_list.h"
#include "shaders/shared/layouts.h"
#include "tests/model/analysis/measured_error.h"
#include "tests/pixels/error_measurement.h"

namespace knotspan::testing {
namespace {

// Drawn with its error measured.
FrameStats measured(Renderer& renderer, const Scene& scene, Frame frame)
{
    frame.shading = Shading::error;
    return drawn(renderer, scene, frame).stats;
}

struct NetOnScreen {
    BezierNet net;
    ScreenView view;
};

// Of every KSQuad, in double on the CPU.
std::vector<NetOnScreen> netsOnScreen(const Scene& scene, const Frame& frame)
{
    std::vector<NetOnScreen> nets;
    Mat4 toEye(1.0);
    for (const auto& [id, object] : scene.objects()) {
        const Vec3 origin = object->surface.bounds().centre();
        toEye[3] = Vec4(transformed(origin, object->transform) - frame.camera.eye, 1.0);
        const Mat4 toClip =
            frame.camera.projection(static_cast<double>(frame.width) / frame.height, scene.bounds()) *
            frame.camera.rotation() * toEye * Mat4(glm::dmat3(object->transform));
        const ScreenView view = screenView(toClip, frame.width, frame.height);
        const BezierConversion conversion(object->surface, origin);
        for (const KsQuad& quad : ksQuads(object->surface))
            nets.push_back({knotspan::transformed(conversion.net(quad), view.toPixels), view});
    }
    return nets;
}

// The largest error of grids of n x n cells in each KSQuad.
double errorOnCpu(const Scene& scene, const Frame& frame, int n)
{
    double largest = 0;
    for (const auto& [net, view] : netsOnScreen(scene, frame))
        largest = std::max(largest, measuredError(net, view, Grid{n, n}, true, 12));
    return largest;
}

// A sheet, seen so that no part hides another.
Frame frameOfSheet(const Scene& scene, PathId path)
{
    Frame frame = frameOf(scene, path, 640, 480, "top");
    frame.camera.eye =
        frame.camera.target + 0.6 * (frame.camera.eye - frame.camera.target) + Vec3(0.4, 0.3, 0);
    return frame;
}

TEST(MeasuredError, AgreesWithTheCpu)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh9x9);
    for (const char* name : {"nine-16", "single-100"}) {
        const Scene scene = findSample(name)->make();
        const Frame frame = frameOfSheet(scene, PathId::mesh9x9);
        const double onCpu = errorOnCpu(scene, frame, 8);
        const FrameStats stats = measured(*renderer, scene, frame);
        // The CPU looks between pixel centres, too.
        EXPECT_LE(*stats.errorPxMax, onCpu + KNOTSPAN_ERROR_NOISE_PX) << name;
        EXPECT_GE(*stats.errorPxMax, 0.98 * onCpu - KNOTSPAN_ERROR_NOISE_PX) << name;
        EXPECT_GT(*stats.errorPxMean, 0.02 * onCpu) << name;
        EXPECT_LT(*stats.errorPxMean, *stats.errorPxMax) << name;
        EXPECT_EQ(*stats.errorPixelsLost, 0U) << name;
        RecordProperty(std::string(name) + "_cpu", std::to_string(onCpu));
        RecordProperty(std::string(name) + "_gpu", std::to_string(*stats.errorPxMax));
    }
}

TEST(MeasuredError, IsNextToNothingWhereGridsAreFine)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    for (const char* name : {"torus", "sphere", "single-100", "hull"}) {
        const Scene scene = findSample(name)->make();
        Frame frame = frameOf(scene, PathId::tessellation, 320, 240);
        frame.sampling = {SamplingRule::Kind::fixed, 64};
        EXPECT_LE(*measured(*renderer, scene, frame).errorPxMax, KNOTSPAN_ERROR_NOISE_PX) << name;
    }
}

// A KSQuad seen edge-on, cut into thousands of triangles that are 71 pixels long and 1/1000 pixel wide: float
// tells no point of one from another, and half a pixel was once measured where the truth is within the
// tolerance.
TEST(MeasuredError, IsNotTheNoiseOfTrianglesTooThinToTell)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh);
    const Scene scene = findSample("extremes")->make();
    Frame frame = frameOf(scene, PathId::mesh, 640, 480);
    frame.tolerancePx = 0.25;
    const FrameStats stats = measured(*renderer, scene, frame);
    EXPECT_LE(*stats.errorPxMax, frame.tolerancePx + KNOTSPAN_ERROR_NOISE_PX);
    const auto [net, view] = netsOnScreen(scene, frame)[178];
    const Grid grid = chooseGrid(net, view, frame.tolerancePx, Triangles::any).grid;
    EXPECT_GT(grid.v, 500);
    const double truth = measuredError(net, view, grid, false, 12);
    EXPECT_LE(truth, frame.tolerancePx);
    RecordProperty("lost", std::to_string(*stats.errorPixelsLost));
    RecordProperty("truth", std::to_string(truth));
    RecordProperty("grid", std::to_string(grid.u) + " x " + std::to_string(grid.v));
}

TEST(MeasuredError, IsAbsentFromOtherPictures)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("nine-16")->make();
    const FrameStats stats = drawn(*renderer, scene, frameOf(scene, renderer->bestPath(), 64, 48)).stats;
    EXPECT_FALSE(stats.errorPxMax);
    EXPECT_FALSE(stats.errorPxMean);
    EXPECT_FALSE(stats.errorPixelsLost);
    EXPECT_FALSE(stats.leakPixels);
    EXPECT_EQ(toJson(stats).find("error_px_max"), std::string::npos);
}

TEST(MeasuredError, IsABreakInColourBeyondTheTolerance)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh9x9);
    const Scene scene = findSample("nine-16")->make();
    Frame frame = frameOfSheet(scene, PathId::mesh9x9);
    frame.shading = Shading::error;
    const auto violations = [&](double tolerance) {
        frame.tolerancePx = tolerance;
        const Picture picture = drawn(*renderer, scene, frame).picture;
        size_t count = 0;
        for (size_t at = 0; at < picture.rgba.size(); at += 4)
            count += picture.rgba[at] > 220 && picture.rgba[at + 1] < 10 ? 1 : 0;
        return count;
    };
    const double largest = *measured(*renderer, scene, frame).errorPxMax;
    EXPECT_EQ(violations(1.01 * largest), 0U);
    EXPECT_GT(violations(0.5 * largest), 50U);
}

TEST(Leaks, AreSeenWhereASurfaceIsMissing)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene whole = findSample("knot")->make();
    Frame frame;
    frame.width = 160;
    frame.height = 120;
    frame.path = renderer->bestPath();
    frame.camera.eye = {3, 0, 0};  // inside the tube
    frame.camera.target = {3, 0, -1};
    frame.camera.up = {0, 1, 0};
    frame.camera.verticalFovDegrees = 75;
    (void)drawn(*renderer, whole, frame);
    EXPECT_EQ(leaks(*renderer, whole, frame, 1), 0U);

    // The surface in the middle of the picture.
    const auto picked = renderer->pick(80, 60);
    ASSERT_TRUE(picked && picked->object());
    Scene open = whole;
    SceneObject hidden = *open.find(*picked->object());
    hidden.visible = false;
    open.exchange(*picked->object(), std::make_shared<const SceneObject>(hidden));
    (void)drawn(*renderer, open, frame);
    EXPECT_GT(leaks(*renderer, whole, frame, 1), 20U);
}

}  // namespace
}  // namespace knotspan::testing
