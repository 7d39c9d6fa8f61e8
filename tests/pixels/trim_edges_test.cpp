// How borders of trimmed surfaces look, on every path: the suite and its paths are of trimming_test.cpp.
#include <algorithm>
#include <cmath>

#include "renderer/overlays/trim_edges.h"
#include "tests/model/trimming/loop_samples.h"
#include "tests/pixels/trimmed_pictures.h"

namespace knotspan::testing {

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

// Three pixels wide, wherever pixels lie: what closes gaps between faces leaves them alone.
TEST_P(TrimmedPictures, ShowSmallHoles)
{
    constexpr double kPixels = 3;
    const Scene whole = sceneOf(platter({}));
    Frame frame = frameFor(whole);
    frame.camera = namedView("top", whole.hullPoints(), 4.0 / 3, true).value();
    const auto pixelOf = [&](const Vec2& place) {
        return frame.camera.toPixel(Vec3(place, 0), kWidth, kHeight).value();
    };
    const double pixel = 1 / (pixelOf({1, 0}).x - pixelOf({0, 0}).x);
    std::vector<TrimLoop> loops = loopsOf(kRim, {{2, 1.5}, kPixels / 2 * pixel});
    std::vector<Vec2> places{{2, 1.5}};
    for (int k = 0; k < 24; ++k) {
        places.emplace_back(1.1 + 0.23 * (k % 6) + 0.13 * pixel * k, 0.8 + 0.31 * (k / 6) + 0.29 * pixel * k);
        loops.push_back(loopsOf(kRim, {places.back(), kPixels / 2 * pixel}).back());
    }
    const Picture picture = drawn(*renderer, sceneOf(platter(loops)), frame).picture;
    for (const Vec2& place : places) {
        const Vec2 at = pixelOf(place);
        EXPECT_TRUE(isBackground(picture, static_cast<int>(at.x), static_cast<int>(at.y)))
            << at.x << ", " << at.y;
    }
}

// Both of its sides run through the same pixels.
TEST_P(TrimmedPictures, ShowStripsAsWideAsAPixel)
{
    constexpr int kParts = 12;
    Frame frame = frameFor(sceneOf(platter({})));
    frame.camera = namedView("top", sceneOf(platter({})).hullPoints(), 4.0 / 3, true).value();
    const auto pixelOf = [&](const Vec2& place) {
        return frame.camera.toPixel(Vec3(place, 0), kWidth, kHeight).value();
    };
    const double pixel = 1 / (pixelOf({1, 0}).x - pixelOf({0, 0}).x);
    for (const double width : {0.7, 1.0, 1.3, 1.8}) {
        const double half = 0.5 * width * pixel;
        const auto middle = [](double u) { return 1.1 + 0.23 * u; };  // flat enough for stairs of four pixels
        const Scene scene = sceneOf(platter({{true,
                                              {polyline({{0.5, middle(0.5) - half},
                                                         {3.5, middle(3.5) - half},
                                                         {3.5, middle(3.5) + half},
                                                         {0.5, middle(0.5) + half},
                                                         {0.5, middle(0.5) - half}})}}}));
        const Picture picture = drawn(*renderer, scene, frame).picture;
        double covered = 0;
        double wanted = 0;
        double worst = 0;
        const auto redAt = [&](int x, int y) {
            return static_cast<double>(
                       picture.rgba[4 * (static_cast<size_t>(y) * kWidth + static_cast<size_t>(x))]) -
                   kBackground[0];
        };
        const int left = static_cast<int>(pixelOf({0.6, 0}).x);
        const int right = static_cast<int>(pixelOf({3.4, 0}).x);
        double most = 1;
        for (int x = left; x < right; ++x)
            for (int y = 0; y < kHeight; ++y)
                most = std::max(most, redAt(x, y));
        for (int x = left; x < right; ++x) {
            double column = 0;
            double hits = 0;
            for (int y = 0; y < kHeight; ++y) {
                column += redAt(x, y) / most;
                for (int k = 0; k < kParts * kParts; ++k) {
                    const auto places = metOnPlane(
                        rayThrough(frame, x + (k % kParts + 0.5) / kParts, y + (k / kParts + 0.5) / kParts));
                    hits += !places.empty() && std::abs(places.front().y - middle(places.front().x)) < half;
                }
            }
            hits /= kParts * kParts;
            covered += column;
            wanted += hits;
            worst = std::max(worst, std::abs(column - hits));
        }
        if (width >= 1) {
            EXPECT_LT(worst, 0.3) << width;  // of a column
            EXPECT_NEAR(covered / wanted, 1, 0.1) << width;
        } else {
            EXPECT_GT(covered / wanted, 0.5) << width;
        }
    }
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
    for (size_t k = 0; k < shown.indices.size(); ++k) {
        const bool isBack = isBackground(sharp, static_cast<int>(k % kWidth), static_cast<int>(k / kWidth));
        EXPECT_EQ(isBack, shownSharply.indices[k] == 0);
        mixed += smooth.rgba[4 * k] != sharp.rgba[4 * k] ? 1 : 0;
    }
    EXPECT_GT(mixed, 200U);
    EXPECT_EQ(shown.indices, shownSharply.indices);
}

// Which are smoothed some rows at a time: where these meet nothing shows.
TEST(LargeTrimmedPictures, AreSmoothWhereTheyEndInAllRows)
{
    Renderer* renderer = sharedRenderer();
    if (renderer == nullptr)
        GTEST_SKIP() << "no Vulkan device here";
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh);
    constexpr int kWidth = 2200;
    constexpr int kHeight = 1700;
    const int border = static_cast<int>(TrimEdges::rowsAtOnce({kWidth, kHeight}));
    ASSERT_LT(border, kHeight - 20);
    const Scene scene = sceneOf(platter(loopsOf(kRim, kHole)));
    Frame frame = frameOf(scene, PathId::mesh, kWidth, kHeight);
    frame.camera = namedView("top", scene.hullPoints(), 1.0 * kWidth / kHeight, true).value();
    const Picture picture = drawn(*renderer, scene, frame).picture;
    const auto redAt = [&](int x, int y) {
        return static_cast<double>(
            picture.rgba[4 * (static_cast<size_t>(y) * kWidth + static_cast<size_t>(x))]);
    };
    const auto share = [&](int x, int y, int parts) {
        int hits = 0;
        for (int k = 0; k < parts * parts; ++k) {
            const auto places =
                metOnPlane(rayThrough(frame, x + (k % parts + 0.5) / parts, y + (k / parts + 0.5) / parts));
            hits += !places.empty() && onPlatter(places.front()) ? 1 : 0;
        }
        return static_cast<double>(hits) / (parts * parts);
    };
    const Vec2 inside = frame.camera.toPixel({1.2, 1, 0}, kWidth, kHeight).value();
    const double covered = redAt(static_cast<int>(inside.x), static_cast<int>(inside.y));
    const double background = kBackground[0];
    int crossed = 0;
    double sum = 0;
    for (int y = border - 8; y < border + 8; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double rough = share(x, y, 3);
            if (rough == 0 || rough == 1)
                continue;
            ++crossed;
            sum += std::abs((redAt(x, y) - background) / (covered - background) - share(x, y, 12));
        }
    EXPECT_GT(crossed, 20);
    EXPECT_LT(sum / crossed, 0.03);
}

}  // namespace knotspan::testing
