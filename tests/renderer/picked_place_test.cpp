// Places of surfaces that are picked: on the surface, at the pixel, and in the KSQuad that they name.
#include <algorithm>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

// How far the point is from a KSQuad.
double distanceFrom(const SceneObject& object, const PickedPlace& place)
{
    const KnotVector& knotsU = object.surface.knotsU();
    const KnotVector& knotsV = object.surface.knotsV();
    const auto distanceAt = [&](const Vec2& t) {
        const Vec3 point =
            evaluate(object.surface, glm::mix(knotsU[place.spanU], knotsU[place.spanU + 1], t.x),
                     glm::mix(knotsV[place.spanV], knotsV[place.spanV + 1], t.y))
                .position;
        return glm::length(transformed(point, object.transform) - place.position);
    };
    Vec2 nearest(0.5);
    double least = distanceAt(nearest);
    // Around the best place so far, ever more closely.
    for (double step = 0.25; step > 1e-6;) {
        const Vec2 centre = nearest;
        for (int i = -2; i <= 2; ++i)
            for (int j = -2; j <= 2; ++j) {
                const Vec2 t = glm::clamp(centre + step * Vec2(i, j), Vec2(0), Vec2(1));
                const double distance = distanceAt(t);
                if (distance < least) {
                    least = distance;
                    nearest = t;
                }
            }
        if (nearest == centre)
            step *= 0.5;
    }
    return least;
}

class PickedPlaces : public ::testing::TestWithParam<PathId> {
protected:
    void SetUp() override
    {
        if (sharedRenderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        KNOTSPAN_NEED_PATH(*sharedRenderer(), GetParam());
    }
};

TEST_P(PickedPlaces, LieOnTheSurfaceToThePicturesTolerance)
{
    Scene scene = findSample("hull")->make();
    SceneObject turned = *findSample("torus")->make().objects().begin()->second;
    turned.transform = Mat4(Vec4(0, 0.8, 0.6, 0), Vec4(-1, 0, 0, 0), Vec4(0, -0.6, 0.8, 0), Vec4(0, 0, 3, 1));
    scene.add(turned);
    for (const bool orthographic : {false, true}) {
        Frame frame = frameOf(scene, GetParam(), 200, 150);
        frame.camera = namedView("iso", scene.hullPoints(), 200.0 / 150, orthographic).value();
        frame.tolerancePx = 0.5;
        (void)drawn(*sharedRenderer(), scene, frame);
        const KsQuadIndices shown = sharedRenderer()->captureKsQuads().value();
        int found = 0;
        for (int y = 4; y < frame.height; y += 10)
            for (int x = 4; x < frame.width; x += 10) {
                const auto pick = sharedRenderer()->pick(x + 0.5, y + 0.5);
                ASSERT_TRUE(pick);
                EXPECT_EQ(bool(pick->place), shown.indices[static_cast<size_t>(y * shown.width + x)] != 0);
                if (!pick->place)
                    continue;
                ++found;
                const Vec2 at =
                    frame.camera.toPixel(pick->place->position, frame.width, frame.height).value();
                EXPECT_LT(glm::length(at - Vec2(x + 0.5, y + 0.5)), 1e-3);
                const double pixel = frame.camera.unitsPerPixel(pick->place->position, frame.height);
                EXPECT_LE(distanceFrom(*scene.find(pick->place->object), *pick->place),
                          (frame.tolerancePx + 0.02) * pixel)
                    << x << ", " << y;
            }
        EXPECT_GT(found, 40);
    }
}

INSTANTIATE_TEST_SUITE_P(Path, PickedPlaces,
                         ::testing::Values(PathId::mesh, PathId::tessellation, PathId::compute, PathId::cpu,
                                           PathId::bezier),
                         [](const auto& test) { return pathInfo(test.param).name; });

TEST(PickedPlace, IsNoneOffTheModel)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("sphere")->make();
    Frame frame = frameOf(scene, renderer->bestPath(), 160, 120);
    (void)drawn(*renderer, scene, frame);
    EXPECT_TRUE(renderer->pick(80, 60)->place);
    for (const Vec2 at : {Vec2(1, 1), Vec2(-1, 60), Vec2(80, -0.5), Vec2(160, 60), Vec2(80, 120)})
        EXPECT_FALSE(renderer->pick(at.x, at.y)->place) << at.x << ", " << at.y;
}

TEST(PickedPlace, NamesTheKsQuadOfThePictureThoughTheSurfaceHasOthersSince)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    Scene scene = findSample("single-100")->make();
    const ObjectId id = scene.objects().begin()->first;
    const Frame frame = frameOf(scene, renderer->bestPath(), 160, 120, "top");
    (void)drawn(*renderer, scene, frame);
    const PickedPlace before = renderer->pick(120, 40)->place.value();
    SceneObject finer = *scene.find(id);
    const KnotVector& knots = finer.surface.knotsU();
    finer.surface = withKnotInserted(finer.surface, Direction::U,
                                     0.5 * (knots[knots.spans()[0]] + knots[knots.spans()[0] + 1]));
    scene.exchange(id, std::make_shared<const SceneObject>(finer));
    ASSERT_TRUE(renderer->sync(scene));
    const PickedPlace still = renderer->pick(120, 40)->place.value();
    EXPECT_EQ(still.spanU, before.spanU);
    EXPECT_EQ(still.position, before.position);
    ASSERT_TRUE(renderer->draw(frame));
    EXPECT_EQ(renderer->pick(120, 40)->place->spanU, before.spanU + 1);
}

}  // namespace
}  // namespace knotspan::testing
