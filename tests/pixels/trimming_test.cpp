// Trimmed surfaces in the picture, on every path: each pixel against closed forms of the loops, what is
// picked there, and that nothing else changes.
#include <algorithm>

#include "model/geometry/knot_insertion.h"
#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "shaders/shared/cull_list.h"
#include "tests/model/trimming/loop_samples.h"
#include "tests/pixels/trimmed_forms.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

class TrimmedPictures : public ::testing::TestWithParam<PathId> {
protected:
    void SetUp() override
    {
        renderer = sharedRenderer();
        if (renderer == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        KNOTSPAN_NEED_PATH(*renderer, GetParam());
    }

    [[nodiscard]] Frame frameFor(const Scene& scene) const
    {
        return frameOf(scene, GetParam(), kWidth, kHeight);
    }

    // What the exact surface shows at a place in the picture: nothing, or the number of the layer.
    using Shown = std::function<int(const Ray&)>;

    // Every pixel whose neighbours would show the same, too.
    void expectShown(const Scene& scene, const Frame& frame, const Shown& shown)
    {
        const Drawn picture = drawn(*renderer, scene, frame);
        const KsQuadIndices indices = renderer->captureKsQuads().value();
        int judged = 0;
        int holes = 0;
        int wrong = 0;
        for (int y = 1; y + 1 < kHeight; ++y)
            for (int x = 1; x + 1 < kWidth; ++x) {
                const int wanted = shown(rayThrough(frame, x + 0.5, y + 0.5));
                bool alike = true;
                for (int k = 0; k < 9; ++k)
                    alike = alike && shown(rayThrough(frame, x - 0.5 + k % 3, y - 0.5 + k / 3)) == wanted;
                if (!alike)
                    continue;
                ++judged;
                holes += wanted == 0 ? 1 : 0;
                const bool there = indices.indices[static_cast<size_t>(y) * kWidth + x] != 0;
                wrong += there != (wanted != 0) || isBackground(picture.picture, x, y) == there ? 1 : 0;
            }
        EXPECT_EQ(wrong, 0);
        EXPECT_GT(judged, kWidth * kHeight / 2);
        EXPECT_GT(holes, 100);
    }

    static Shown layers(std::vector<Vec3> (*met)(const Ray&), const std::function<bool(const Vec3&)>& remains)
    {
        return [met, remains](const Ray& ray) {
            int layer = 0;
            for (const Vec3& place : met(ray)) {
                ++layer;
                if (remains(place))
                    return layer;
            }
            return 0;
        };
    }

    Renderer* renderer = nullptr;
};

Scene sceneOf(SceneObject object)
{
    Scene scene;
    scene.add(std::move(object));
    return scene;
}

TEST_P(TrimmedPictures, ShowAPlaneWhereItsLoopsLeaveIt)
{
    const Scene scene = sceneOf(platter(loopsOf(kRim, kHole)));
    Frame frame = frameFor(scene);
    for (const Shading shading : {Shading::shaded, Shading::normals, Shading::error})
        for (const bool orthographic : {false, true}) {
            SCOPED_TRACE(::testing::PrintToString(static_cast<int>(shading)) + (orthographic ? " flat" : ""));
            frame.shading = shading;
            frame.camera = namedView("iso", scene.hullPoints(), 4.0 / 3, orthographic).value();
            expectShown(scene, frame, layers(metOnPlane, onPlatter));
        }
}

TEST_P(TrimmedPictures, ShowARationalSurfaceWhereItsLoopsLeaveIt)
{
    const Scene scene = sceneOf(pipe());
    Frame frame = frameFor(scene);
    frame.camera.eye = {3, -4, 0.8};
    frame.camera.target = {0, 0, 0};
    expectShown(scene, frame, layers(metOnPipe, onPipe));
}

// A pipe and what was cut out of it, cut into other triangles.
TEST_P(TrimmedPictures, LeaveNoPixelBetweenTwoThatMeetAlongALoop)
{
    const Scene whole = sceneOf([] {
        SceneObject object = pipe();
        object.trimLoops.clear();
        return object;
    }());
    Scene parts = sceneOf(pipe());
    SceneObject lid = pipe();
    lid.surface = withKnotsInserted(lid.surface, Direction::U, {6.3, 6.62});
    lid.trimLoops = {{true, {circle(kWindow.centre, kWindow.radius)}}};
    parts.add(lid);
    Frame frame = frameFor(whole);
    frame.width = 3 * kWidth;
    frame.height = 3 * kHeight;
    frame.camera.eye = {2.4, -2.6, 0.8};
    frame.camera.target = {0.5, -0.5, 0};
    frame.tolerancePx = 1.5;
    (void)drawn(*renderer, whole, frame);
    const KsQuadIndices wanted = renderer->captureKsQuads().value();
    const Drawn met = drawn(*renderer, parts, frame);
    EXPECT_EQ(met.stats.surfacesTrimmed, 2U);
    const KsQuadIndices shown = renderer->captureKsQuads().value();
    // The pipe's arcs come first in both scenes. Between pipe and lid one would see those behind.
    size_t ofLid = 0;
    size_t between = 0;
    for (size_t k = 0; k < shown.indices.size(); ++k) {
        const bool inFront = wanted.indices[k] >= 6;
        ofLid += shown.indices[k] > 8 ? 1 : 0;
        between += inFront && shown.indices[k] < 6 ? 1 : 0;
    }
    EXPECT_GT(ofLid, 2000U);
    EXPECT_EQ(between, 0U);
}

// Against many places in each pixel that a loop runs through. A picture of pixels that are covered or not
// would be off by a quarter in the mean.
TEST_P(TrimmedPictures, AreSmoothWhereTheyEnd)
{
    constexpr int kParts = 12;
    const Scene scene = sceneOf(platter(loopsOf(kRim, kHole)));
    Frame frame = frameFor(scene);
    frame.camera = namedView("top", scene.hullPoints(), 4.0 / 3, true).value();
    const Picture picture = drawn(*renderer, scene, frame).picture;
    const auto redAt = [&](int x, int y) {
        return static_cast<double>(
            picture.rgba[4 * (static_cast<size_t>(y) * kWidth + static_cast<size_t>(x))]);
    };
    const Vec2 inside = frame.camera.toPixel({1.2, 1, 0}, kWidth, kHeight).value();
    const double covered = redAt(static_cast<int>(inside.x), static_cast<int>(inside.y));
    const double background = kBackground[0];
    ASSERT_GT(covered, background + 60);
    int crossed = 0;
    double sum = 0;
    int far = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            EXPECT_EQ(picture.rgba[4 * (static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)) + 3], 255);
            int hits = 0;
            for (int k = 0; k < kParts * kParts; ++k) {
                const Ray ray =
                    rayThrough(frame, x + (k % kParts + 0.5) / kParts, y + (k / kParts + 0.5) / kParts);
                const auto places = metOnPlane(ray);
                hits += !places.empty() && onPlatter(places.front()) ? 1 : 0;
            }
            const double wanted = static_cast<double>(hits) / (kParts * kParts);
            const double off = std::abs((redAt(x, y) - background) / (covered - background) - wanted);
            if (hits == 0 || hits == kParts * kParts) {
                EXPECT_LT(off, 0.02) << x << ", " << y;
                continue;
            }
            ++crossed;
            sum += off;
            far += off > 0.3 ? 1 : 0;
        }
    EXPECT_GT(crossed, 300);
    EXPECT_LT(sum / crossed, 0.03);
    EXPECT_LE(far, crossed / 100);
}

// Which costs less.
TEST_P(TrimmedPictures, AreOfWholePixelsWhereThatIsAskedFor)
{
    const Scene scene = sceneOf(platter(loopsOf(kRim, kHole)));
    Frame frame = frameFor(scene);
    frame.camera = namedView("top", scene.hullPoints(), 4.0 / 3, true).value();
    const Picture smooth = drawn(*renderer, scene, frame).picture;
    const KsQuadIndices shown = renderer->captureKsQuads().value();
    frame.smoothEdges = false;
    const Picture sharp = drawn(*renderer, scene, frame).picture;
    const KsQuadIndices shownSharply = renderer->captureKsQuads().value();
    size_t mixed = 0;
    size_t differ = 0;
    for (size_t k = 0; k < shown.indices.size(); ++k) {
        const bool isBack = isBackground(sharp, static_cast<int>(k % kWidth), static_cast<int>(k / kWidth));
        EXPECT_EQ(isBack, shownSharply.indices[k] == 0);
        mixed += smooth.rgba[4 * k] != sharp.rgba[4 * k] ? 1 : 0;
        differ += shown.indices[k] != shownSharply.indices[k] ? 1 : 0;
    }
    EXPECT_GT(mixed, 200U);
    EXPECT_LE(differ, 8U);  // whose centre is as good as on a loop
}

TEST_P(TrimmedPictures, LetPicksThroughTheirHoles)
{
    Scene scene;
    const ObjectId above = scene.add(platter(loopsOf(kRim, kHole)));
    SceneObject floor = platter({});
    floor.transform[3].z = -0.3;
    const ObjectId below = scene.add(floor);
    Frame frame = frameFor(scene);
    frame.camera = namedView("top", scene.hullPoints(), 4.0 / 3, true).value();
    (void)drawn(*renderer, scene, frame);
    const auto pickedAt = [&](const Vec2& place) {
        const Vec2 at = frame.camera.toPixel({place.x, place.y, 0}, kWidth, kHeight).value();
        return renderer->pick(at.x, at.y).value().place;
    };
    ASSERT_TRUE(pickedAt(kHole.centre));
    EXPECT_EQ(pickedAt(kHole.centre)->object, below);
    EXPECT_NEAR(pickedAt(kHole.centre)->position.z, -0.3, 1e-4);
    EXPECT_EQ(pickedAt({0.3, 0.3})->object, below);
    EXPECT_EQ(pickedAt({2, 0.4})->object, above);
    EXPECT_NEAR(pickedAt({2, 0.4})->position.z, 0, 1e-4);
}

TEST_P(TrimmedPictures, StayTrimmedWhenAControlPointMoves)
{
    Scene scene = sceneOf(platter(loopsOf(kRim, kHole)));
    const ObjectId id = scene.objects().begin()->first;
    const Frame frame = frameFor(scene);
    const Drawn before = drawn(*renderer, scene, frame);
    const SharedObject object = scene.find(id);
    scene.exchange(id, withControlPointAt(*object, {4, 1}, {2, 0.5, 0.4}).value());
    const Drawn moved = drawn(*renderer, scene, frame);
    EXPECT_GT(changedPixels(before.picture, moved.picture), 50U);
    if (pathInfo(GetParam()).drawsFromDevice) {
        EXPECT_EQ(moved.stats.uploadBytesPerFrame, 16U);
    }
    // Sent anew its points count from another origin, so that other bits are rounded.
    (void)drawn(*renderer, Scene(), frame);
    const Difference difference = compare(moved.picture, drawn(*renderer, scene, frame).picture);
    EXPECT_EQ(difference.silhouetteOff, 0U);
    EXPECT_LT(difference.meanShaded, 1);
    const Vec2 hole = frame.camera.toPixel(Vec3(kHole.centre, 0), kWidth, kHeight).value();
    EXPECT_TRUE(isBackground(moved.picture, static_cast<int>(hole.x), static_cast<int>(hole.y)));
}

TEST_P(TrimmedPictures, FollowLoopsThatAnEditChanges)
{
    Scene scene = sceneOf(platter({}));
    const ObjectId id = scene.objects().begin()->first;
    const Frame frame = frameFor(scene);
    const Drawn whole = drawn(*renderer, scene, frame);
    EXPECT_EQ(whole.stats.surfacesTrimmed, 0U);
    const auto exchange = [&](const std::vector<TrimLoop>& loops) {
        scene.exchange(id, std::make_shared<const SceneObject>(platter(loops)));
    };
    exchange(loopsOf(kRim, kHole));
    expectShown(scene, frame, layers(metOnPlane, onPlatter));
    const Disc otherHole{{1.5, 1.25}, 0.4};
    exchange(loopsOf(kRim, otherHole));
    expectShown(scene, frame, layers(metOnPlane, [&](const Vec3& place) {
                    return kRim.has(Vec2(place)) && !otherHole.has(Vec2(place));
                }));
    EXPECT_EQ(drawn(*renderer, scene, frame).stats.surfacesTrimmed, 1U);
    exchange({});
    EXPECT_EQ(changedPixels(whole.picture, drawn(*renderer, scene, frame).picture), 0U);
}

TEST_P(TrimmedPictures, ChangeNothingOfSurfacesThatAreNotTrimmed)
{
    Scene scene = findSample("hull")->make();
    Frame frame = frameFor(scene);
    frame.overlays.knotLines = true;
    frame.overlays.isoCurves = 3;
    const Drawn alone = drawn(*renderer, scene, frame);
    SceneObject behind = platter(loopsOf(kRim, kHole));
    behind.transform[3] = Vec4(frame.camera.eye - 40.0 * frame.camera.forward(), 1);
    scene.add(behind);
    const Drawn both = drawn(*renderer, scene, frame);
    EXPECT_EQ(both.stats.surfacesTrimmed, 1U);
    EXPECT_EQ(changedPixels(alone.picture, both.picture), 0U);
}

TEST_P(TrimmedPictures, AreTheSameWhateverIsCulled)
{
    // Through its hole one sees the inside of a closed body.
    SceneObject ring = *findSample("torus")->make().objects().begin()->second;
    const KnotVector& u = ring.surface.knotsU();
    const Vec2 domain(u.domainEnd() - u.domainStart(),
                      ring.surface.knotsV().domainEnd() - ring.surface.knotsV().domainStart());
    const double radius = 0.2 * std::min(domain.x, domain.y);
    for (const double along : {0.25, 0.75})
        ring.trimLoops.push_back({false,
                                  {circle({u.domainStart() + along * domain.x,
                                           ring.surface.knotsV().domainStart() + 0.5 * domain.y},
                                          radius, false)}});
    for (const Scene& scene : {sceneOf(platter(loopsOf(kRim, kHole))), sceneOf(ring)})
        for (const char* view : {"iso", "front"}) {
            Frame frame = frameOf(scene, GetParam(), kWidth, kHeight, view);
            const Drawn without = drawn(*renderer, scene, frame);
            EXPECT_EQ(without.stats.surfacesTrimmed, 1U);
            for (const char* modes :
                 {"trimmed", "sqc,frustum,small,occlusion", "trimmed,sqc,frustum,small,occlusion"}) {
                frame.culling = parseCullSet(modes).value();
                for (int k = 0; k < 2; ++k)
                    EXPECT_EQ(changedPixels(without.picture, drawn(*renderer, scene, frame).picture), 0U)
                        << modes << ", " << view;
            }
        }
}

TEST_P(TrimmedPictures, CountKsQuadsOfWhichNothingIsLeft)
{
    const Scene scene = sceneOf(platter(loopsOf(kRim, kHole)));
    const SceneObject& object = *scene.objects().begin()->second;
    const TrimRegion region(object.trimLoops, object.surface);
    const TrimIndex index = TrimIndex::create(region).value();
    std::uint64_t outside = 0;
    for (std::uint32_t k = 0; k < index.ksquadCount(); ++k)
        outside += index.classOf(k) == KsQuadTrim::outside ? 1 : 0;
    ASSERT_GT(outside, 8U);
    Frame frame = frameFor(scene);
    frame.culling = parseCullSet("trimmed").value();
    const FrameStats stats = drawn(*renderer, scene, frame).stats;
    const bool follows = GetParam() != PathId::surface;  // it knows no KSQuads
    EXPECT_EQ(stats.ksquadsCulled[8], follows ? outside : 0U);
    EXPECT_EQ(stats.ksquadsDrawn, stats.ksquads - stats.ksquadsCulled[8]);
}

TEST_P(TrimmedPictures, AreOfWholeSurfacesWhereLoopsCannotBeFollowedAndSaySo)
{
    const Scene whole = sceneOf(platter({}));
    const Scene open = sceneOf(platter({{true, {polyline({{1, 1}, {3, 1}, {3, 2}})}}}));
    const Frame frame = frameFor(whole);
    const Drawn wanted = drawn(*renderer, whole, frame);
    EXPECT_FALSE(wanted.stats.drawnWhole);
    const Drawn refused = drawn(*renderer, open, frame);
    EXPECT_EQ(changedPixels(wanted.picture, refused.picture), 0U);
    EXPECT_EQ(refused.stats.surfacesTrimmed, 0U);
    ASSERT_TRUE(refused.stats.drawnWhole);
    EXPECT_TRUE(refused.stats.drawnWhole->starts_with("1 surface is drawn without trim loops: "));
}

// A loop along the border, as files have them.
TEST_P(TrimmedPictures, CostNothingWhereLoopsLeaveAll)
{
    const Scene scene = sceneOf(platter({{true, {polyline({{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}})}}}));
    const Frame frame = frameFor(scene);
    const Drawn along = drawn(*renderer, scene, frame);
    EXPECT_EQ(along.stats.surfacesTrimmed, 0U);
    EXPECT_FALSE(along.stats.drawnWhole);
    EXPECT_EQ(changedPixels(along.picture, drawn(*renderer, sceneOf(platter({})), frame).picture), 0U);
}

std::string pathName(const ::testing::TestParamInfo<PathId>& test)
{
    std::string name = pathInfo(test.param).name;
    name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
    return name;
}

std::vector<PathId> allPaths()
{
    std::vector<PathId> found;
    for (const PathInfo& path : paths())
        found.push_back(path.id);
    return found;
}

INSTANTIATE_TEST_SUITE_P(Path, TrimmedPictures, ::testing::ValuesIn(allPaths()), pathName);

}  // namespace
}  // namespace knotspan::testing
