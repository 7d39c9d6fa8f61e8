#include "tests/renderer/render_support.h"

#include <cstdlib>

namespace knotspan::testing {

namespace {

std::unique_ptr<Renderer> openRenderer()
{
    auto made = Renderer::create({.device = {}, .validation = true});
    if (!made)
        made = Renderer::create();
    return made ? std::move(*made) : nullptr;
}

std::unique_ptr<Renderer>& heldRenderer()
{
    static std::unique_ptr<Renderer> renderer = openRenderer();
    return renderer;
}

// Whatever the tests of a program did with the shared renderer, the validation layer had nothing to say of
// it. It is closed before the program ends: drivers and layers put their own things away then, in an order of
// their own.
class SharedRendererEnd : public ::testing::Environment {
public:
    void TearDown() override
    {
        if (heldRenderer()) {
            EXPECT_EQ(heldRenderer()->validationMessages(), std::vector<std::string>());
        }
        heldRenderer().reset();
    }
};
[[maybe_unused]] const auto* const kEnd = ::testing::AddGlobalTestEnvironment(new SharedRendererEnd);

}  // namespace

Renderer* sharedRenderer()
{
    return heldRenderer().get();
}

Frame frameOf(const Scene& scene, PathId path, int width, int height, std::string_view view)
{
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.path = path;
    frame.camera = namedView(view, scene.hullPoints(), static_cast<double>(width) / height, false).value();
    return frame;
}

Drawn drawn(Renderer& renderer, const Scene& scene, const Frame& frame)
{
    if (const auto synced = renderer.sync(scene); !synced) {
        ADD_FAILURE() << synced.error().sentence();
        return {};
    }
    const auto stats = renderer.draw(frame);
    if (!stats) {
        ADD_FAILURE() << stats.error().sentence();
        return {};
    }
    auto picture = renderer.capture();
    if (!picture) {
        ADD_FAILURE() << picture.error().sentence();
        return {};
    }
    return {std::move(*picture), *stats};
}

bool isBackground(const Picture& picture, int x, int y)
{
    const size_t at =
        4 * (static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x));
    return picture.rgba[at] == kBackground[0] && picture.rgba[at + 1] == kBackground[1] &&
           picture.rgba[at + 2] == kBackground[2];
}

size_t shownPixels(const Picture& picture)
{
    size_t count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            count += isBackground(picture, x, y) ? 0 : 1;
    return count;
}

std::uint32_t colourAt(const Picture& picture, int x, int y)
{
    const size_t at =
        4 * (static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x));
    return std::uint32_t{picture.rgba[at]} << 16U | std::uint32_t{picture.rgba[at + 1]} << 8U |
           picture.rgba[at + 2];
}

size_t pixelsOf(const Picture& picture, std::uint32_t colour)
{
    size_t count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::uint32_t here = colourAt(picture, x, y);
            const auto near = [&](unsigned shift) {
                return std::abs(int(here >> shift & 255U) - int(colour >> shift & 255U)) <= 1;
            };
            count += near(0) && near(8) && near(16) ? 1 : 0;
        }
    return count;
}

bool isNear(const Picture& picture, const Vec2& at, std::uint32_t colour)
{
    for (int y = int(at.y) - 2; y <= int(at.y) + 2; ++y)
        for (int x = int(at.x) - 2; x <= int(at.x) + 2; ++x)
            if (x >= 0 && y >= 0 && x < picture.width && y < picture.height &&
                colourAt(picture, x, y) == colour)
                return true;
    return false;
}

size_t changedPixels(const Picture& a, const Picture& b)
{
    EXPECT_EQ(a.rgba.size(), b.rgba.size());
    size_t count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            count += colourAt(a, x, y) != colourAt(b, x, y) ? 1 : 0;
    return count;
}

namespace {

// Whether anything within a pixel of (x, y) is shown (or, for background, is not).
bool nearby(const Picture& picture, int x, int y, bool background)
{
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const int nx = x + dx;
            const int ny = y + dy;
            if (nx >= 0 && ny >= 0 && nx < picture.width && ny < picture.height &&
                isBackground(picture, nx, ny) == background)
                return true;
        }
    return false;
}

}  // namespace

Difference compare(const Picture& a, const Picture& b)
{
    Difference difference;
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    double sum = 0;
    size_t both = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const bool backgroundA = isBackground(a, x, y);
            const bool backgroundB = isBackground(b, x, y);
            if (!nearby(b, x, y, backgroundA) || !nearby(a, x, y, backgroundB))
                ++difference.silhouetteOff;
            if (backgroundA || backgroundB)
                continue;
            ++both;
            const size_t at =
                4 * (static_cast<size_t>(y) * static_cast<size_t>(a.width) + static_cast<size_t>(x));
            for (size_t channel = 0; channel < 3; ++channel)
                sum += std::abs(int(a.rgba[at + channel]) - int(b.rgba[at + channel])) / 3.0;
        }
    difference.meanShaded = both > 0 ? sum / static_cast<double>(both) : 0.0;
    return difference;
}

std::vector<PathId> allPaths()
{
    std::vector<PathId> all;
    for (const PathInfo& path : paths())
        all.push_back(path.id);
    return all;
}

std::string pathTestName(const ::testing::TestParamInfo<PathId>& test)
{
    std::string name = pathInfo(test.param).name;
    std::erase(name, '-');
    return name;
}

}  // namespace knotspan::testing
