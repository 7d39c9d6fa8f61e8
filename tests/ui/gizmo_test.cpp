// The gizmo's geometry and what a hand's way means, without a window.
#include "ui/tools/gizmo.h"

#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace knotspan {
namespace {

PictureView viewFrom(const Vec3& eye, bool orthographic)
{
    PictureView view;
    view.camera.eye = eye;
    view.camera.target = Vec3(0.4, -0.2, 0.3);
    view.camera.up = Vec3(0, 0, 1);
    view.camera.orthographic = orthographic;
    view.width = 640;
    view.height = 400;
    return view;
}

Vec2 pixelOf(const PictureView& view, const Vec3& place)
{
    return view.camera.toPixel(place, view.width, view.height).value();
}

std::vector<GizmoHandle> allHandles()
{
    std::vector<GizmoHandle> handles;
    for (const HandleKind kind : {HandleKind::move, HandleKind::turn, HandleKind::scale})
        for (int k = 0; k < 3; ++k) {
            Vec3 direction(0);
            direction[k] = 1;
            handles.push_back({kind, static_cast<DragAxis>(static_cast<int>(DragAxis::x) + k), direction});
        }
    handles.push_back({HandleKind::scaleEvenly, DragAxis::free, Vec3(0)});
    return handles;
}

const Vec3 kCentre(0.5, -0.4, 0.6);

TEST(Gizmo, IsOfOneSizeOnThePictureHoweverFarTheEye)
{
    for (const bool orthographic : {false, true})
        for (const double far : {3.0, 30.0, 3000.0})
            for (const double ratio : {1.0, 2.0}) {
                PictureView view = viewFrom(Vec3(0.4, -0.2 - far, 0.3), orthographic);
                view.pixelRatio = ratio;
                const Vec3 at = view.camera.target;
                const Gizmo gizmo(view, at, allHandles());
                for (const size_t handle : {size_t(0), size_t(2)})  // X and Z face the eye
                    EXPECT_NEAR(glm::distance(pixelOf(view, at), gizmo.shape(handle)[1].to), kArrowPx * ratio,
                                1e-6);
                EXPECT_TRUE(gizmo.shape(1).empty());  // Y points at it, and so does its bar
                EXPECT_TRUE(gizmo.shape(7).empty());
                EXPECT_FALSE(gizmo.shape(4).empty());
            }
}

TEST(Gizmo, FindsEachHandleUnderItsOwnPixelsAndNoneElsewhere)
{
    const PictureView view = viewFrom(Vec3(5, -7, 4), false);
    const Gizmo gizmo(view, kCentre, allHandles());
    for (size_t handle = 0; handle < allHandles().size(); ++handle) {
        ASSERT_FALSE(gizmo.shape(handle).empty()) << handle;
        size_t found = 0;
        for (const Stroke& stroke : gizmo.shape(handle)) {
            const auto hit = gizmo.under(0.5 * (stroke.from + stroke.to));
            ASSERT_TRUE(hit.has_value());
            EXPECT_LE(hit->distancePx, 1e-9);
            found += hit->handle == handle ? 1 : 0;
        }
        EXPECT_GT(found, 0U) << handle;
    }
    EXPECT_FALSE(gizmo.under(pixelOf(view, kCentre) + Vec2(150, 0)).has_value());
    const auto beside = gizmo.under(gizmo.shape(8)[0].to + Vec2(0, -3));
    ASSERT_TRUE(beside.has_value());
    EXPECT_GT(beside->distancePx, 1);
    EXPECT_LE(beside->distancePx, 3 + 1e-9);
}

TEST(Gizmo, LightsOneHandleAndIsNotThereBehindTheEye)
{
    const PictureView view = viewFrom(Vec3(5, -7, 4), false);
    const Gizmo gizmo(view, kCentre, allHandles());
    const auto plain = gizmo.strokes({});
    const auto lit = gizmo.strokes(2);
    ASSERT_EQ(plain.size(), lit.size());
    size_t changed = 0;
    for (size_t k = 0; k < plain.size(); ++k)
        changed += plain[k].colour != lit[k].colour ? 1 : 0;
    EXPECT_EQ(changed, gizmo.shape(2).size());
    const Vec3 behind = view.camera.eye - 3.0 * view.camera.forward();
    EXPECT_TRUE(Gizmo(view, behind, allHandles()).strokes({}).empty());
}

TEST(PictureMoves, APlaceAlongAnAxisStaysUnderTheHand)
{
    for (const bool orthographic : {false, true}) {
        const PictureView view = viewFrom(Vec3(5, -7, 4), orthographic);
        for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 0, 1), glm::normalize(Vec3(2, -1, 3))})
            for (const double far : {-1.5, 0.0, 1e-6, 2.0}) {
                const Vec2 way = pixelOf(view, kCentre + far * axis) - pixelOf(view, kCentre);
                const auto distance = movedAlong(view, kCentre, axis, way);
                ASSERT_TRUE(distance.has_value());
                EXPECT_NEAR(*distance, far, 1e-10);
                // What the hand does across does not count.
                const auto across = movedAlong(view, kCentre, axis, way + 0.3 * Vec2(-way.y, way.x));
                EXPECT_NEAR(across.value(), far, 1e-10);
            }
        const Vec3 atEye = orthographic ? view.camera.forward() : glm::normalize(kCentre - view.camera.eye);
        EXPECT_FALSE(movedAlong(view, kCentre, atEye, Vec2(9, 9)).has_value());
        EXPECT_EQ(movedAlong(view, kCentre, Vec3(1, 0, 0), Vec2(0)).value(), 0);
    }
}

TEST(PictureMoves, ThePlaceInTheViewPlaneStaysUnderTheHand)
{
    for (const bool orthographic : {false, true}) {
        const PictureView view = viewFrom(Vec3(5, -7, 4), orthographic);
        const Vec2 way(37, -21);
        const Vec3 by = movedInViewPlane(view, kCentre, way);
        EXPECT_NEAR(glm::distance(pixelOf(view, kCentre + by), pixelOf(view, kCentre) + way), 0, 1e-9);
        EXPECT_NEAR(glm::dot(by, view.camera.forward()), 0, 1e-12);
    }
}

// Where the end of a unit vector is seen around the middle.
Vec2 seenAs(const Camera& camera, const Vec3& v)
{
    return {glm::dot(v, camera.right()), -glm::dot(v, camera.upward())};
}

TEST(PictureMoves, ARingTurnsWithTheHandAndCountsWholeTurns)
{
    const PictureView view = viewFrom(Vec3(5, -7, 4), false);
    const auto onRing = [&](double degrees) {
        const double radians = degrees * 3.14159265358979323846 / 180;
        return 64.0 * seenAs(view.camera, Vec3(std::cos(radians), std::sin(radians), 0));
    };
    double last = 0;
    for (int degrees = 0; degrees <= 800; degrees += 40) {
        last = turnedBy(view, Vec3(0, 0, 1), onRing(-65), onRing(degrees - 65) - onRing(-65), 64, last);
        EXPECT_NEAR(last, degrees, 1e-9);
    }
    EXPECT_EQ(turnedBy(view, Vec3(0, 0, 1), onRing(-65), Vec2(0), 64, 12), 0);
}

TEST(PictureMoves, ARingSeenFromItsSideTurnsAsAWheel)
{
    const PictureView view = viewFrom(Vec3(0.4, -10, 0.3), true);
    ASSERT_TRUE(RingSeen(view.camera, Vec3(0, 0, 1)).isEdgeOn());
    // Looking along +y: the front goes to the right when it turns about z.
    EXPECT_NEAR(turnedBy(view, Vec3(0, 0, 1), Vec2(0), Vec2(64, 5), 64, 0), 180 / 3.14159265358979323846,
                1e-6);
}

}  // namespace
}  // namespace knotspan
