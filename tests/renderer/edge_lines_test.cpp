// Lines along the borders of surfaces: where they are, what hides them, and that they cost nothing without.
#include <algorithm>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr std::uint32_t kOrange = 0xe69f00;

// Around the middle of the domain, 0.7 of it wide.
TrimCurve circleIn(const NurbsSurface& surface)
{
    const KnotVector& knots = surface.knotsU();
    const double size = knots.domainEnd() - knots.domainStart();
    const Vec2 centre(knots.domainStart() + 0.5 * size);
    std::vector<TrimPoint> points;
    std::vector<double> circle{0, 0, 0};
    for (int k = 0; k <= 8; ++k) {
        const double angle = k * std::acos(-1.0) / 4;
        const bool corner = k % 2 == 1;
        points.push_back(
            {centre + 0.35 * size * (corner ? std::sqrt(2.0) : 1) * Vec2(std::cos(angle), std::sin(angle)),
             corner ? std::sqrt(0.5) : 1});
        if (k > 0 && k < 8 && !corner)
            circle.insert(circle.end(), 2, k / 2);
    }
    circle.insert(circle.end(), 3, 4);
    return TrimCurve::create(KnotVector::create(2, circle).value(), points).value();
}

class EdgeLineTest : public ::testing::TestWithParam<PathId> {
protected:
    void SetUp() override
    {
        if (sharedRenderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        KNOTSPAN_NEED_PATH(*sharedRenderer(), GetParam());
        frame = frameOf(scene, GetParam(), 240, 180);
    }

    Scene scene = findSample("single-100")->make();
    ObjectId id = scene.objects().begin()->first;
    Frame frame;
};

TEST_P(EdgeLineTest, LieOnTheSidesAndPartsThatWereAskedFor)
{
    const NurbsSurface& surface = scene.find(id)->surface;
    const double end = surface.knotsU().domainEnd();
    const double start = surface.knotsU().domainStart();
    frame.overlays.edgeLines = {{id, {0, Side::startV, start, (start + end) / 2}, kOrange, 3}};
    const Picture picture = drawn(*sharedRenderer(), scene, frame).picture;
    EXPECT_GT(pixelsOf(picture, kOrange), 50U);
    const int rows = surface.countU();
    const auto pixelOf = [&](int i, int j) {
        return frame.camera.toPixel(controlPointInModel(*scene.find(id), {i, j}), frame.width, frame.height)
            .value();
    };
    EXPECT_TRUE(isNear(picture, pixelOf(0, 0), kOrange));
    EXPECT_FALSE(isNear(picture, pixelOf(rows - 1, 0), kOrange));
    EXPECT_FALSE(isNear(picture, pixelOf(0, surface.countV() - 1), kOrange));
    for (const Side side : {Side::startU, Side::endU, Side::startV, Side::endV}) {
        frame.overlays.edgeLines = {{id, {0, side, start, end}, kOrange, 3}};
        const Picture whole = drawn(*sharedRenderer(), scene, frame).picture;
        const bool far1 = side == Side::endU;
        const bool far2 = side == Side::endV;
        EXPECT_TRUE(isNear(whole, pixelOf(far1 ? rows - 1 : 0, far2 ? surface.countV() - 1 : 0), kOrange));
    }
}

// A circle in the parameters, drawn half.
TEST_P(EdgeLineTest, FollowTrimCurvesThroughTheSurface)
{
    SceneObject trimmed = *scene.find(id);
    const TrimCurve curve = circleIn(trimmed.surface);
    trimmed.trimLoops = {{true, {curve}}};
    scene.exchange(id, std::make_shared<SceneObject>(trimmed));
    frame.camera = frameOf(scene, GetParam(), 240, 180, "top").camera;  // where nothing hides the line
    frame.overlays.edgeLines = {{id, {0, {}, 0, 2, TrimPlace{0, 0}}, kOrange, 3}};
    const Picture picture = drawn(*sharedRenderer(), scene, frame).picture;
    const auto isSeenAt = [&](double t) {
        const Vec2 at = curve.evaluate(t);
        const Vec3 point = transformed(evaluate(trimmed.surface, at.x, at.y).position, trimmed.transform);
        return isNear(picture, frame.camera.toPixel(point, frame.width, frame.height).value(), kOrange);
    };
    for (const double t : {0.05, 0.4, 0.9, 1.3, 1.7, 1.95})
        EXPECT_TRUE(isSeenAt(t)) << t;
    for (const double t : {2.3, 2.9, 3.7})
        EXPECT_FALSE(isSeenAt(t)) << t;
    frame.overlays.edgeLines = {{id, {0, {}, 0, 2, TrimPlace{0, 1}}, kOrange, 3}};  // there is none
    EXPECT_EQ(pixelsOf(drawn(*sharedRenderer(), scene, frame).picture, kOrange), 0U);
}

// Pixels that outlines change, and those that places of the borders are on, are the same.
TEST_P(EdgeLineTest, OutlinesAreThoseOfWhatIsLeft)
{
    frame = frameOf(scene, GetParam(), 240, 180, "top");
    SceneObject object = *scene.find(id);
    const TrimCurve curve = circleIn(object.surface);
    const double end = object.surface.knotsU().domainEnd();
    std::vector<Vec2> circle;
    for (double t = 0; t < 4; t += 0.01)
        circle.push_back(curve.evaluate(t));
    std::vector<Vec2> sides;
    for (double t = 0; t <= end; t += end / 400)
        sides.insert(sides.end(), {Vec2(t, 0), Vec2(t, end), Vec2(0, t), Vec2(end, t)});
    std::vector<Vec2> both = circle;
    both.insert(both.end(), sides.begin(), sides.end());
    const auto expectAt = [&](const std::vector<TrimLoop>& loops, const std::vector<Vec2>& border) {
        object.trimLoops = loops;
        scene.exchange(id, std::make_shared<SceneObject>(object));
        frame.overlays.outlines = false;
        const Picture bare = drawn(*sharedRenderer(), scene, frame).picture;
        frame.overlays.outlines = true;
        const Picture outlined = drawn(*sharedRenderer(), scene, frame).picture;
        EXPECT_EQ(sharedRenderer()->draw(frame)->uploadBytesPerFrame, 0U);
        std::vector<Vec2> pixels;
        for (const Vec2& at : border)
            pixels.push_back(*frame.camera.toPixel(
                transformed(evaluate(object.surface, at.x, at.y).position, object.transform), frame.width,
                frame.height));
        std::vector<bool> isSeen(pixels.size(), false);
        int stray = 0;
        for (int y = 0; y < frame.height; ++y)
            for (int x = 0; x < frame.width; ++x) {
                if (colourAt(bare, x, y) == colourAt(outlined, x, y))
                    continue;
                bool isNearOne = false;
                for (size_t k = 0; k < pixels.size(); ++k)
                    if (glm::distance(pixels[k], Vec2(x + 0.5, y + 0.5)) < 2) {
                        isNearOne = true;
                        isSeen[k] = true;
                    }
                stray += !isNearOne;
            }
        EXPECT_EQ(stray, 0);
        EXPECT_EQ(std::count(isSeen.begin(), isSeen.end(), false), 0);
    };
    ASSERT_EQ(object.surface.knotsU(), object.surface.knotsV());
    ASSERT_EQ(object.surface.knotsU().domainStart(), 0);
    {
        SCOPED_TRACE("whole");
        expectAt({}, sides);
    }
    {
        SCOPED_TRACE("a disc");
        expectAt({{true, {curve}}}, circle);
    }
    {
        SCOPED_TRACE("a hole");
        const std::vector<TrimPoint> around{{{0, 0}}, {{end, 0}}, {{end, end}}, {{0, end}}, {{0, 0}}};
        const TrimCurve border = TrimCurve::create(KnotVector::clampedUniform(1, 4), around).value();
        expectAt({{true, {border}}, {false, {curve}}}, both);
    }
}

// Of each way to pack a scene one.
INSTANTIATE_TEST_SUITE_P(Path, EdgeLineTest,
                         ::testing::Values(PathId::tessellation, PathId::bezier, PathId::cpu), pathTestName);

TEST(EdgeLines, CostNothingWhereThereAreNone)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("nine-16")->make();
    const ObjectId id = scene.objects().begin()->first;
    Frame frame = frameOf(scene, renderer->bestPath(), 160, 120);
    const Picture bare = drawn(*renderer, scene, frame).picture;
    EXPECT_EQ(renderer->draw(frame)->uploadBytesPerFrame, 0U);
    Frame lined = frame;
    lined.overlays.edgeLines = {{id, {0, Side::startU, 0, 1}, kOrange, 3}};
    const auto first = renderer->draw(lined);
    ASSERT_TRUE(first);
    EXPECT_GT(pixelsOf(renderer->capture().value(), kOrange), 0U);
    EXPECT_EQ(renderer->draw(lined)->uploadBytesPerFrame, 0U);  // nothing changed
    const auto without = renderer->draw(frame);
    ASSERT_TRUE(without);
    EXPECT_EQ(without->uploadBytesPerFrame, 0U);
    EXPECT_EQ(renderer->capture()->rgba, bare.rgba);
}

TEST(EdgeLines, AreHiddenByWhatIsInFront)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    Scene scene = findSample("single-100")->make();
    const ObjectId id = scene.objects().begin()->first;
    SceneObject lid = *scene.find(id);
    lid.transform = Mat4(Vec4(3, 0, 0, 0), Vec4(0, 3, 0, 0), Vec4(0, 0, 1, 0), Vec4(0, 0, 20, 1));
    Frame frame = frameOf(scene, renderer->bestPath(), 160, 120, "top");
    frame.overlays.edgeLines = {{id, {0, Side::startU, 0, 1}, kOrange, 3}};
    EXPECT_GT(pixelsOf(drawn(*renderer, scene, frame).picture, kOrange), 20U);
    const Box bounds = scene.bounds();
    lid.transform[3] = Vec4(bounds.centre() * -2.0, 1);
    lid.transform[3].z = bounds.high.z - bounds.low.z + 1;
    scene.add(lid);
    frame.camera = frameOf(scene, frame.path, 160, 120, "top").camera;
    EXPECT_EQ(pixelsOf(drawn(*renderer, scene, frame).picture, kOrange), 0U);
}

// An object that went, and parts outside the surface, are no lines.
TEST(EdgeLines, ThatNameNothingAreLeftOut)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("single-100")->make();
    const ObjectId id = scene.objects().begin()->first;
    Frame frame = frameOf(scene, renderer->bestPath(), 160, 120);
    frame.overlays.edgeLines = {{ObjectId(99), {0, Side::startU, 0, 1}, kOrange, 3},
                                {id, {0, Side::startU, 1e6, 2e6}, kOrange, 3}};
    EXPECT_EQ(pixelsOf(drawn(*renderer, scene, frame).picture, kOrange), 0U);
}

}  // namespace
}  // namespace knotspan::testing
