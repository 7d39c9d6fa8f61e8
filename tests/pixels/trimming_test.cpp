// Trimmed surfaces in the picture, on every path: each pixel against closed forms of the loops, what is
// picked there, and that nothing else changes.
#include <algorithm>

#include "model/geometry/knot_insertion.h"
#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "shaders/shared/cull_list.h"
#include "tests/model/trimming/loop_samples.h"
#include "tests/pixels/trimmed_pictures.h"

namespace knotspan::testing {
namespace {

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

INSTANTIATE_TEST_SUITE_P(Path, TrimmedPictures, ::testing::ValuesIn(allPaths()), pathTestName);

}  // namespace
}  // namespace knotspan::testing
