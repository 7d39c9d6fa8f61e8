// Lines that follow from surfaces: where a parameter has a value, inside KSQuads, along normals.
#include <algorithm>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr std::uint32_t kOrange = 0xe69f00;
constexpr std::uint32_t kNormalColour = 0x73deb5;

// A square in the plane z = 0 around the origin, of side 2, with `spans` spans each way.
SceneObject square(int spans)
{
    NurbsSurface surface = plane({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    for (int k = 1; k < spans; ++k)
        for (const Direction direction : {Direction::U, Direction::V})
            surface = withKnotInserted(surface, direction, double(k) / spans);
    return {.surface = surface};
}

class SurfaceLines : public ::testing::TestWithParam<PathId> {
protected:
    void SetUp() override
    {
        if (sharedRenderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        KNOTSPAN_NEED_PATH(*sharedRenderer(), GetParam());
    }

    [[nodiscard]] Picture picture() const { return drawn(*sharedRenderer(), scene, frame).picture; }

    Scene scene;
    Frame frame;
};

class IsoLines : public SurfaceLines {
protected:
    void SetUp() override
    {
        SurfaceLines::SetUp();
        scene = findSample("single-100")->make();
        id = scene.objects().begin()->first;
        frame = frameOf(scene, GetParam(), 240, 180, "top");  // from where nothing hides them
    }

    // Of places along the line across `direction` at `parameter`, how many the picture shows it near.
    [[nodiscard]] int placesNear(const Picture& shown, Direction direction, double parameter) const
    {
        const SceneObject& object = *scene.find(id);
        const bool isU = direction == Direction::U;
        const KnotVector& along = isU ? object.surface.knotsV() : object.surface.knotsU();
        int count = 0;
        for (int k = 0; k < kPlaces; ++k) {
            const double s = glm::mix(along.domainStart(), along.domainEnd(), (k + 0.5) / kPlaces);
            const Vec3 point = evaluate(object.surface, isU ? parameter : s, isU ? s : parameter).position;
            const Vec2 at =
                frame.camera.toPixel(transformed(point, object.transform), frame.width, frame.height).value();
            count += isNear(shown, at, kOrange) ? 1 : 0;
        }
        return count;
    }

    static constexpr int kPlaces = 40;
    ObjectId id{};
};

TEST_P(IsoLines, RunWhereTheParameterStandsStill)
{
    for (const Direction direction : {Direction::U, Direction::V}) {
        const NurbsSurface& surface = scene.find(id)->surface;
        const KnotVector& knots = direction == Direction::U ? surface.knotsU() : surface.knotsV();
        const double size = knots.domainEnd() - knots.domainStart();
        const double atKnot = knots[knots.spans()[3]];
        for (const double parameter : {knots.domainStart() + 0.23 * size, atKnot, knots.domainEnd()}) {
            frame.overlays.isoLines = {{id, direction, parameter, kOrange, 3}};
            const Picture shown = picture();
            EXPECT_EQ(placesNear(shown, direction, parameter), kPlaces) << parameter;
            EXPECT_EQ(placesNear(shown, direction, parameter - 0.1 * size), 0) << parameter;
        }
    }
}

TEST_P(IsoLines, StayOnTheSurface)
{
    const KnotVector& knots = scene.find(id)->surface.knotsU();
    frame.overlays.isoLines = {{id, Direction::U, knots.domainStart() - 7, kOrange, 3}};
    EXPECT_EQ(placesNear(picture(), Direction::U, knots.domainStart()), kPlaces);
    frame.overlays.isoLines = {{id, Direction::U, knots.domainEnd() + 7, kOrange, 3}};
    EXPECT_EQ(placesNear(picture(), Direction::U, knots.domainEnd()), kPlaces);
    frame.overlays.isoLines = {{ObjectId(99), Direction::U, 0.5, kOrange, 3}};
    EXPECT_EQ(pixelsOf(picture(), kOrange), 0U);
}

TEST_P(IsoLines, TravelOnlyWhereTheyChanged)
{
    frame.overlays.isoLines = {{id, Direction::U, 0.4, kOrange, 3}};
    (void)picture();
    EXPECT_EQ(sharedRenderer()->draw(frame)->uploadBytesPerFrame, 0U);
    frame.overlays.isoLines[0].parameter = 0.41;
    const size_t spans = scene.find(id)->surface.knotsV().spans().size();
    EXPECT_EQ(sharedRenderer()->draw(frame)->uploadBytesPerFrame, spans * 28);
}

// Of each way to pack a scene one.
INSTANTIATE_TEST_SUITE_P(Path, IsoLines, ::testing::Values(PathId::tessellation, PathId::bezier, PathId::cpu),
                         pathTestName);

class IsoCurves : public SurfaceLines {
protected:
    // How often the picture gets darker than `bare` along a row, and by how much at most.
    struct Darker {
        int times = 0;
        int most = 0;
    };
    [[nodiscard]] static Darker darkerAlong(const Picture& bare, const Picture& lined, int row)
    {
        Darker found;
        bool inside = false;
        for (int x = 0; x < bare.width; ++x) {
            const int by = int(colourAt(bare, x, row) & 255U) - int(colourAt(lined, x, row) & 255U);
            found.most = std::max(found.most, by);
            found.times += by > 5 && !inside ? 1 : 0;
            inside = by > 5;
        }
        return found;
    }
};

TEST_P(IsoCurves, CutEveryKsQuadIntoAsManyPartsAsAsked)
{
    for (const int spans : {1, 2}) {
        scene = Scene();
        scene.add(square(spans));
        frame = frameOf(scene, GetParam(), 201, 201, "top");
        const Picture bare = picture();
        for (const int parts : {2, 4, 5}) {
            frame.overlays.isoCurves = parts;
            const Picture lined = picture();
            const auto row = [&](double v) {
                return int(frame.camera.toPixel({0, 2 * v - 1, 0}, frame.width, frame.height)->y);
            };
            // In a row between two of the lines across it.
            EXPECT_EQ(darkerAlong(bare, lined, row(0.5 / parts / spans)).times, spans * (parts - 1));
            // Every line is where it should be: the whole of this row is one.
            EXPECT_GT(changedPixels(bare, lined), 150U);
            const int onLine = row(1.0 / parts / spans);
            const Darker run = darkerAlong(bare, lined, onLine);
            EXPECT_LE(run.times, 2 * spans) << "of " << parts << " parts, row " << onLine;
        }
    }
}

TEST_P(IsoCurves, AreFainterAndThinnerThanKnotLines)
{
    scene.add(square(2));
    frame = frameOf(scene, GetParam(), 200, 200, "top");
    const Picture bare = picture();
    frame.overlays.isoCurves = 2;
    const Picture iso = picture();
    const int row = int(frame.camera.toPixel({0, 0.3, 0}, frame.width, frame.height)->y);
    const int mostIso = darkerAlong(bare, iso, row).most;
    frame.overlays.isoCurves = 0;
    frame.overlays.knotLines = true;
    const int mostKnot = darkerAlong(bare, picture(), row).most;
    EXPECT_GT(mostIso, 20);
    EXPECT_GT(mostKnot, mostIso + 20);
}

TEST_P(IsoCurves, OfLessThanTwoPartsAreNone)
{
    scene.add(square(2));
    frame = frameOf(scene, GetParam(), 100, 100, "top");
    const Picture bare = picture();
    for (const int parts : {-3, 0, 1}) {
        frame.overlays.isoCurves = parts;
        EXPECT_EQ(bare.rgba, picture().rgba) << parts;
    }
    frame.overlays.isoCurves = 1000;  // too close to be told apart
    EXPECT_EQ(bare.rgba, picture().rgba);
    frame.shading = Shading::error;
    const Picture bareErrors = picture();
    frame.overlays.isoCurves = 3;
    EXPECT_GT(changedPixels(bareErrors, picture()), 100U);
}

// Whole surfaces as primitives count spans in their parameters.
INSTANTIATE_TEST_SUITE_P(Path, IsoCurves, ::testing::Values(PathId::tessellation, PathId::surface),
                         pathTestName);

class Normals : public SurfaceLines {
protected:
    // Looks at the square, aslant from above or below.
    void look(double height, bool orthographic)
    {
        frame.path = GetParam();
        frame.width = 400;
        frame.height = 300;
        frame.camera = {.eye = {0.5, -6, height}, .target = {0, 0, 0}, .up = {0, 0, 1}};
        frame.camera.orthographic = orthographic;
        frame.overlays.normals = true;
    }

    // Where the line from `foot` along `front` is at a part of its length.
    [[nodiscard]] Vec2 onLine(const Vec3& foot, const Vec3& front, double part) const
    {
        const double length = 18 * frame.camera.unitsPerPixel(foot, frame.height);
        return frame.camera.toPixel(foot + front * (length * part), frame.width, frame.height).value();
    }
};

TEST_P(Normals, PointToTheFrontFromTheMiddleOfEachKsQuad)
{
    scene.add(square(3));
    for (const bool orthographic : {false, true}) {
        look(8, orthographic);
        const Picture shown = picture();
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j) {
                const Vec3 foot(i * 2 / 3.0, j * 2 / 3.0, 0);
                for (const double part : {0.2, 0.5, 0.85})
                    EXPECT_TRUE(isNear(shown, onLine(foot, {0, 0, 1}, part), kNormalColour))
                        << i << j << part;
                for (const double part : {-0.5, 1.5})
                    EXPECT_FALSE(isNear(shown, onLine(foot, {0, 0, 1}, part), kNormalColour))
                        << i << j << part;
            }
        EXPECT_EQ(sharedRenderer()->draw(frame)->uploadBytesPerFrame, 0U);
        look(-8, orthographic);  // the surface hides them
        EXPECT_EQ(pixelsOf(picture(), kNormalColour), 0U);
    }
}

// A mirror takes the front along: what was the outside of a body still is.
TEST_P(Normals, PointToTheFrontOfMirroredObjects)
{
    SceneObject mirrored = square(1);
    mirrored.transform[0][0] = -1;
    const ObjectId id = scene.add(mirrored);
    look(8, false);
    EXPECT_TRUE(isNear(picture(), onLine(Vec3(0), {0, 0, 1}, 0.7), kNormalColour));
    mirrored.transform = Mat4(1);
    mirrored.transform[2][2] = -1;
    scene.exchange(id, std::make_shared<const SceneObject>(mirrored));
    EXPECT_EQ(pixelsOf(picture(), kNormalColour), 0U);
    look(-8, false);
    EXPECT_TRUE(isNear(picture(), onLine(Vec3(0), {0, 0, -1}, 0.7), kNormalColour));
}

TEST_P(Normals, AreThoseOfCurvedSurfaces)
{
    scene = findSample("single-100")->make();
    frame = frameOf(scene, GetParam(), 320, 240, "top");
    frame.overlays.normals = true;
    const SceneObject& object = *scene.objects().begin()->second;
    const Picture shown = picture();
    int seen = 0;
    for (const int spanU : object.surface.knotsU().spans())
        for (const int spanV : object.surface.knotsV().spans()) {
            const auto middle = [](const KnotVector& knots, int span) {
                return 0.5 * (knots[span] + knots[span + 1]);
            };
            const double u = middle(object.surface.knotsU(), spanU);
            const double v = middle(object.surface.knotsV(), spanV);
            const Vec3 foot = evaluate(object.surface, u, v).position;
            const Vec3 normal = evaluateNormal(object.surface, u, v).direction;
            const Vec2 end = onLine(foot, normal, 0.9);
            if (glm::length(end - onLine(foot, normal, 0)) < 6)
                continue;  // it points at the eye
            ++seen;
            EXPECT_TRUE(isNear(shown, end, kNormalColour)) << spanU << ", " << spanV;
            EXPECT_FALSE(isNear(shown, onLine(foot, normal, -0.9), kNormalColour)) << spanU << ", " << spanV;
        }
    EXPECT_GT(seen, 10);
}

// Where loops leave the middle not, from another place; where they leave nothing, none.
TEST_P(Normals, StartWhereSomethingIsLeft)
{
    const auto polygon = [](const std::vector<Vec2>& corners) {
        std::vector<TrimPoint> points;
        for (const Vec2& corner : corners)
            points.push_back({corner, 1});
        points.push_back(points.front());
        const int spans = static_cast<int>(corners.size());
        return TrimLoop{true, {TrimCurve::create(KnotVector::clampedUniform(1, spans), points).value()}};
    };
    SceneObject object = square(2);
    // A corner of the first KSQuad, and all of the last.
    object.trimLoops = {polygon({{0.05, 0.05}, {0.15, 0.05}, {0.05, 0.15}}),
                        polygon({{0.5, 0.5}, {1, 0.5}, {1, 1}, {0.5, 1}})};
    scene.add(object);
    look(8, false);
    const Picture shown = picture();
    EXPECT_TRUE(isNear(shown, onLine({0.5, 0.5, 0}, {0, 0, 1}, 0.8), kNormalColour));
    size_t ofCorner = 0;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            if (colourAt(shown, x, y) != kNormalColour)
                continue;
            const auto isOf = [&](const Vec3& low, const Vec3& high) {
                const Vec2 a = onLine(low, {0, 0, 1}, 0) + Vec2(-2, 2);
                const Vec2 b = onLine(high, {0, 0, 1}, 1.1) + Vec2(2, -2);
                return x >= a.x && x <= b.x && y <= a.y && y >= b.y;
            };
            const bool isCorner = isOf({-0.9, -0.9, 0}, {-0.7, -0.7, 0});
            ofCorner += isCorner;
            EXPECT_TRUE(isCorner || isOf({0.5, 0.5, 0}, {0.5, 0.5, 0})) << x << ", " << y;
        }
    EXPECT_GT(ofCorner, 5U);
}

INSTANTIATE_TEST_SUITE_P(Path, Normals, ::testing::Values(PathId::tessellation, PathId::bezier),
                         pathTestName);

}  // namespace
}  // namespace knotspan::testing
