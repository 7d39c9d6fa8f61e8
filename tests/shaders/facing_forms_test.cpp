// The facing tests of the culling modes, by the shaders' own text in float: what they drop, against dense
// samples in double of the surface that was given, before anything was rounded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/samples/sample_list.h"
#include "renderer/scene/facing_forms.h"
#include "renderer/scene/patch_table.h"
#include "tests/facing_samples.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

// A surface as the device holds it.
class DeviceSurface {
public:
    explicit DeviceSurface(const NurbsSurface& surface)
        : surface_(surface),
          frame_(PointFrame::of(surface)),
          packed_(packPoints<float>(frame_, surface.controlPoints())),
          rounded_(roundedSurface()),
          conversion_(rounded_)
    {
    }

    struct Forms {
        gpu::FacingBox box;
        gpu::vec3 origin;
        std::vector<std::uint32_t> words;

        [[nodiscard]] gpu::uint facingWord(gpu::uint index) const { return words[index]; }
    };
    [[nodiscard]] Forms formsOf(const KsQuad& quad) const
    {
        const int p = surface_.degreeU();
        const int q = surface_.degreeV();
        const glm::vec4 middle = packed_[static_cast<size_t>((quad.spanU - p + p / 2) * surface_.countV() +
                                                             quad.spanV - q + q / 2)];
        Forms forms;
        forms.origin = gpu::vec3(middle) / middle.w;
        forms.words.resize(gpu::facingWordCount(static_cast<gpu::uint>(p), static_cast<gpu::uint>(q)));
        forms.box = gpu::facingBoxOf(makeFacingForms(
            conversion_.net(quad), Vec3(middle) / static_cast<double>(middle.w), forms.words));
        return forms;
    }
    [[nodiscard]] gpu::vec4 deviceEye(const Vec4& eye) const
    {
        return gpu::vec4(Vec4(Vec3(eye) - eye.w * frame_.origin, eye.w));
    }

private:
    // Of the floats, weights and all.
    [[nodiscard]] NurbsSurface roundedSurface() const
    {
        std::vector<ControlPoint> points;
        for (const glm::vec4& point : packed_)
            points.push_back({Vec3(point) / static_cast<double>(point.w), point.w});
        return NurbsSurface::create(surface_.knotsU(), surface_.knotsV(), std::move(points)).value();
    }

    const NurbsSurface& surface_;
    PointFrame frame_;
    std::vector<glm::vec4> packed_;
    NurbsSurface rounded_;
    BezierConversion conversion_;
};

struct FormCounts {
    FacingCount box;
    FacingCount full;

    void add(const DeviceSurface& device, const DeviceSurface::Forms& forms, const FacingSamples& samples,
             const Vec4& eye)
    {
        const bool shows = samples.showTo(eye);
        const gpu::FacingEye seen = gpu::facingEye(forms.box, forms.origin, device.deviceEye(eye));
        const bool byBox = gpu::boxFacesAway(forms.box, seen);
        const bool byRays =
            gpu::raysFaceAway(forms, forms.box, seen, 0, static_cast<gpu::uint>(forms.words.size()));
        box.add(shows, byBox);
        full.add(shows, byBox || byRays);
    }
    void record(const std::string& name) const
    {
        EXPECT_EQ(box.wrong, 0) << name;
        EXPECT_EQ(full.wrong, 0) << name;
        ::testing::Test::RecordProperty(name + "_views", std::to_string(full.views));
        ::testing::Test::RecordProperty(name + "_away", std::to_string(full.away));
        ::testing::Test::RecordProperty(name + "_box", std::to_string(box.share()));
        ::testing::Test::RecordProperty(name + "_full", std::to_string(full.share()));
    }
};

constexpr int kEyes = 40;

void look(std::mt19937& random, const NurbsSurface& surface, const Box& box, int quads, FormCounts& counts)
{
    const DeviceSurface device(surface);
    const auto all = ksQuads(surface);
    for (int k = 0; k < quads; ++k) {
        const KsQuad& quad = all[random() % all.size()];
        const FacingSamples samples(surface, quad, 14);
        const DeviceSurface::Forms forms = device.formsOf(quad);
        for (int view = 0; view < kEyes; ++view)
            counts.add(device, forms, samples,
                       view % 2 == 0 ? samples.randomEye(random, box) : samples.tangentEye(random, box));
    }
}

TEST(FacingForms, DropNothingThatShowsOfRandomSurfaces)
{
    constexpr double kOffsets[] = {0, 1e3, 1e5, 1e7};
    std::mt19937 random(61);
    FormCounts counts;
    for (int trial = 0; trial < soakOf(70000) / (3 * kEyes); ++trial) {
        const NurbsSurface surface = randomSurface(random, {.degreeU = 1 + trial % 9,
                                                            .degreeV = 1 + (trial * 4 + trial / 9) % 9,
                                                            .spans = 1 + trial % 4,
                                                            .rational = trial % 3 != 0,
                                                            .offset = kOffsets[trial / 2 % 4],
                                                            .spanRatio = trial % 4 == 0 ? 1e3 : 4.0,
                                                            .clamped = trial % 5 != 0,
                                                            .weightRatio = trial % 7 == 0 ? 100.0 : 4.0});
        look(random, surface, surface.bounds(), 3, counts);
    }
    counts.record("random");
    EXPECT_GT(counts.full.culled, counts.full.views / 20);
}

TEST(FacingForms, DropNothingThatShowsOfSamples)
{
    std::mt19937 random(62);
    FormCounts counts;
    const int each = soakOf(30000) / (kEyes * static_cast<int>(samples().size()));
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        std::vector<const NurbsSurface*> surfaces;
        for (const auto& [id, object] : scene.objects())
            surfaces.push_back(&object->surface);
        const int count = std::min(each, 12);  // DeviceSurface takes longest
        for (int k = 0; k < count; ++k)
            look(random, *surfaces[random() % surfaces.size()], scene.bounds(), each / count, counts);
    }
    counts.record("samples");
    EXPECT_GT(counts.full.culled, counts.full.views / 10);
}

// Bent so little that nothing but the test's own margin stands between its rounding and a wrong answer.
NurbsSurface nearlyPlane(std::mt19937& random, int trial)
{
    const Vec3 normal = randomDirection(random);
    const NurbsSurface surface = randomSurface(
        random, {.degreeU = 1 + trial % 4, .degreeV = 1 + trial / 4 % 4, .spans = 40, .spanRatio = 2});
    std::vector<ControlPoint> points = surface.controlPoints();
    for (ControlPoint& point : points)
        point.position -= (1 - 1e-6) * glm::dot(normal, point.position) * normal;
    return NurbsSurface::create(surface.knotsU(), surface.knotsV(), std::move(points)).value();
}

TEST(FacingForms, DropNothingThatShowsOfWhatIsNearlyAPlane)
{
    std::mt19937 random(65);
    FormCounts counts;
    for (int trial = 0; trial < soakOf(8000) / (10 * kEyes); ++trial) {
        const NurbsSurface surface = nearlyPlane(random, trial);
        look(random, surface, surface.bounds(), 10, counts);
    }
    counts.record("planes");
    EXPECT_GT(counts.full.culled, counts.full.views / 5);
}

struct Shares {
    double box;
    double full;
};

Shares sharesOf(const std::string& name, const std::vector<const NurbsSurface*>& surfaces)
{
    std::mt19937 random(63);
    Box around;
    size_t quadCount = 0;
    for (const NurbsSurface* surface : surfaces) {
        around.add(surface->bounds());
        quadCount += ksQuadCount(*surface);
    }
    const size_t step = 1 + quadCount / 80;
    FormCounts counts;
    for (const NurbsSurface* surface : surfaces) {
        const DeviceSurface device(*surface);
        const auto quads = ksQuads(*surface);
        for (size_t k = random() % step; k < quads.size(); k += step) {
            const FacingSamples samples(*surface, quads[k], 50);  // fewer miss what shows beside a pole
            const DeviceSurface::Forms forms = device.formsOf(quads[k]);
            for (int view = 0; view < kEyes; ++view)
                counts.add(device, forms, samples, samples.randomEye(random, around));
        }
    }
    counts.record(name);
    return {counts.box.share(), counts.full.share()};
}

TEST(FacingForms, DropNearlyAllThatFacesAway)
{
    for (const char* name : {"torus", "sphere", "knot", "hull", "single-100"}) {
        const Scene scene = findSample(name)->make();
        std::vector<const NurbsSurface*> surfaces;
        for (const auto& [id, object] : scene.objects())
            if (surfaces.size() < 4)
                surfaces.push_back(&object->surface);
        const Shares shares = sharesOf(name, surfaces);
        EXPECT_GE(shares.box, 0.75) << name;
        EXPECT_GE(shares.full, 0.98) << name;
    }
    std::mt19937 random(64);
    const NurbsSurface bumps = bumpyBall(random, 12, 0.1, false);
    const NurbsSurface fineBumps = bumpyBall(random, 32, 0.03, true);
    EXPECT_GE(sharesOf("bumps", {&bumps}).full, 0.98);
    EXPECT_GE(sharesOf("fine_bumps", {&fineBumps}).full, 0.98);
}

TEST(FacingForms, TakeTheBytesThatTheDocumentsName)
{
    EXPECT_EQ(sizeof(gpu::FacingRecord), 16u);
    EXPECT_EQ(4 * gpu::facingWordCount(3, 3), 192u);
    EXPECT_EQ(gpu::facingWordCount(1, 1), 3u);
    EXPECT_EQ(gpu::facingRayCount(2, 5), 5u * 14u);
}

BezierNet bilinear(const Vec4& a, const Vec4& b, const Vec4& c, const Vec4& d)
{
    return {1, 1, {a, b, c, d}};
}

bool isDropped(const BezierNet& net, const gpu::vec4& eye)
{
    DeviceSurface::Forms forms;
    forms.words.resize(3);
    forms.box = gpu::facingBoxOf(makeFacingForms(net, Vec3(net.points[0]) / net.points[0].w, forms.words));
    forms.origin = gpu::vec3(Vec3(net.points[0]) / net.points[0].w);
    const gpu::FacingEye seen = gpu::facingEye(forms.box, forms.origin, eye);
    return gpu::boxFacesAway(forms.box, seen) || gpu::raysFaceAway(forms, forms.box, seen, 0, 3);
}

// S_u x S_v points up.
const BezierNet kSquare = bilinear({0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1});

TEST(FacingForms, OfAPlaneTheEyeMustBeBelowIt)
{
    EXPECT_TRUE(isDropped(kSquare, {0.5F, 0.5F, -2, 1}));
    EXPECT_TRUE(isDropped(kSquare, {5, 8, -0.01F, 1}));
    EXPECT_FALSE(isDropped(kSquare, {0.5F, 0.5F, 2, 1}));
    EXPECT_FALSE(isDropped(kSquare, {5, 8, 0, 1}));
    EXPECT_TRUE(isDropped(kSquare, {0, 0.9F, -0.01F, 0}));
    EXPECT_FALSE(isDropped(kSquare, {0, 1, -1e-5F, 0}));
    EXPECT_FALSE(isDropped(kSquare, {0, 0, 1, 0}));
}

TEST(FacingForms, AnEyeThatIsNoNumberOrTooFarDropsNothing)
{
    const float nan = std::nanf("");
    EXPECT_FALSE(isDropped(kSquare, {nan, 0, -2, 1}));
    EXPECT_FALSE(isDropped(kSquare, {0, 0, -INFINITY, 1}));
    EXPECT_FALSE(isDropped(kSquare, {0, 0, -3e38F, 1}) && isDropped(kSquare, {0, 0, 3e38F, 1}));
}

TEST(FacingForms, WhatIsNoSurfaceOrFacesEverywhereIsNeverDropped)
{
    const Vec4 at(3, 4, 5, 1);
    const BezierNet point = bilinear(at, at, at, at);
    const BezierNet line = bilinear(at, at, {4, 4, 5, 1}, {4, 4, 5, 1});
    // Its triangles face opposite ways.
    const BezierNet folded = bilinear({0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {-0.5, -0.5, 0, 1});
    // Smaller than floats there can tell.
    BezierNet lost = kSquare;
    for (Vec4& corner : lost.points)
        corner = Vec4(Vec3(corner) * 1e-6 + 1000.0, 1);
    for (const BezierNet& net : {point, line, folded, lost})
        for (const gpu::vec4& eye : {gpu::vec4(0, 0, 9, 1), gpu::vec4(0, 0, -9, 1), gpu::vec4(0, 0, 1, 0),
                                     gpu::vec4(0, 0, -1, 0), gpu::vec4(9, 1, 0, 1)})
            EXPECT_FALSE(isDropped(net, eye));
}

}  // namespace
}  // namespace knotspan::testing
