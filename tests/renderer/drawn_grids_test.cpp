// The grids that are drawn, looked at triangle by triangle in double: those the CPU makes, those the device
// makes, and what the device says of them.
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <glm/matrix.hpp>

#include "model/geometry/bezier_conversion.h"
#include "model/samples/sample_list.h"
#include "renderer/scene/adaptive_grids.h"
#include "renderer/scene/cell_indices.h"
#include "shaders/shared/layouts.h"
#include "tests/model/analysis/measured_error.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr const char* kSamples[] = {"extremes", "sphere", "torus", "hull"};

// What the path cpu draws of a frame.
struct Drawing {
    Drawing(const Scene& scene, const Frame& frame) : residents(makeResidents(visibleObjects(scene)))
    {
        std::vector<PlacedSurface> placed;
        for (const Resident& resident : residents)
            placed.push_back({&resident.object->surface, resident.object->transform});
        const SharedEdges edges(placed);
        const auto changes = cpuScene.update(residents, edges.tables(), Evaluator::triangular);
        view = GridView::of(residents, frame.camera, frame.width, frame.height, scene.bounds(),
                            frame.tolerancePx, 0, ShownSides::asTold(residents));
        (void)grids.update(cpuScene, changes, view);
        middle = {0.5 * frame.width, 0.5 * frame.height};
    }

    [[nodiscard]] Mat4 toPixels(std::uint32_t surface) const
    {
        const auto& map = view.maps[surface];
        return glm::transpose(Mat4(map.x, map.y, map.z, map.w));
    }

    [[nodiscard]] KsQuad ksquad(std::uint32_t number) const
    {
        const std::uint32_t surface = cpuScene.ksquad(number).surface;
        return ksQuads(residents[surface].object->surface)[number - cpuScene.surface(surface).firstKsquad];
    }

    // In the coordinates of its surface.
    [[nodiscard]] BezierNet net(std::uint32_t number) const
    {
        const Resident& resident = residents[cpuScene.ksquad(number).surface];
        return BezierConversion(resident.object->surface, resident.frame.origin).net(ksquad(number));
    }

    std::vector<Resident> residents;
    CpuScene cpuScene;
    GridView view;
    AdaptiveGrids grids;
    Vec2 middle{};
};

// The largest distance between points of a triangle and the surface. A point's parameters are linear with the
// vertices' weights (surface_io.glsl).
double errorOfTriangle(const Drawing& drawing, const BezierNet& net, const Mat4& toPixels,
                       const std::array<const gpu::ObjectVertex*, 3>& vertices)
{
    constexpr int kSteps = 10;
    std::array<Vec4, 3> corners{};
    std::array<double, 3> share{};
    for (size_t k = 0; k < 3; ++k) {
        const std::uint32_t surface = drawing.cpuScene.ksquad(vertices[k]->source).surface;
        corners[k] = drawing.toPixels(surface) * Vec4(Vec3(vertices[k]->position), 1);
        share[k] = 1.0 / double{vertices[k]->weight};
    }
    double largest = 0;
    for (int a = 0; a <= kSteps; ++a)
        for (int b = 0; a + b <= kSteps; ++b) {
            const std::array<int, 3> at{a, b, kSteps - a - b};
            Vec4 point(0);
            Vec2 t(0);
            double shares = 0;
            for (size_t k = 0; k < 3; ++k) {
                point += static_cast<double>(at[k]) / kSteps * corners[k];
                t += at[k] * share[k] * Vec2(vertices[k]->t);
                shares += at[k] * share[k];
            }
            const Vec4 exact = toPixels * evaluate(net, t.x / shares, t.y / shares);
            largest = std::max(largest, glm::distance(Vec2(point) / point.w, Vec2(exact) / exact.w));
        }
    return largest;
}

// Snapped borders, points of neighbours and all. Float vertices are off by less than a hundredth of a pixel.
TEST(DrawnGrids, KeepEveryTriangleWithinTheTolerance)
{
    for (const char* name : kSamples)
        for (const double tolerance : {4.0, 0.5}) {
            const Scene scene = findSample(name)->make();
            Frame frame = frameOf(scene, PathId::cpu, 640, 480);
            frame.tolerancePx = tolerance;
            const Drawing drawing(scene, frame);
            CellIndices cells;
            cells.provide(drawing.grids.grids());
            double largest = 0;
            for (std::uint32_t k = 0; k < drawing.cpuScene.ksquadCount(); ++k) {
                const VertexGrid& grid = drawing.grids.grids()[k];
                if (grid.u == 0)
                    continue;
                const BezierNet net = drawing.net(k);
                const Mat4 toPixels = drawing.toPixels(drawing.cpuScene.ksquad(k).surface);
                const gpu::ObjectVertex* vertices = &drawing.grids.store().vertices()[grid.first];
                const std::uint32_t* index = &cells.indices()[cells.firstOf(grid)];
                for (const std::uint32_t* end = index + 6 * grid.cells(); index != end; index += 3)
                    largest = std::max(largest, errorOfTriangle(drawing, net, toPixels,
                                                                {vertices + index[0], vertices + index[1],
                                                                 vertices + index[2]}));
            }
            EXPECT_LE(largest, tolerance + 0.01) << name;
            EXPECT_GT(largest, 0.4 * tolerance) << name;
        }
}

// The cells of each KSQuad's drawn grid, by object and span, from the vertices that a stage computed: rows
// inside have all of the grid's, those along an edge no more.
using KsQuadKey = std::array<int, 3>;

std::map<KsQuadKey, Grid> gridsOf(const std::vector<CapturedVertex>& vertices)
{
    std::map<KsQuadKey, std::array<std::array<std::set<double>, 3>, 2>> lines;
    const auto row = [](double t) { return size_t{t == 0.0 ? 0U : (t == 1.0 ? 2U : 1U)}; };
    for (const CapturedVertex& vertex : vertices) {
        auto& found = lines[{static_cast<int>(vertex.object), vertex.spanU, vertex.spanV}];
        found[0][row(vertex.v)].insert(vertex.u);
        found[1][row(vertex.u)].insert(vertex.v);
    }
    const auto cells = [](const std::array<std::set<double>, 3>& rows) {
        return static_cast<int>(std::max({rows[0].size(), rows[1].size(), rows[2].size()})) - 1;
    };
    std::map<KsQuadKey, Grid> grids;
    for (const auto& [key, found] : lines)
        grids[key] = {cells(found[0]), cells(found[1])};
    return grids;
}

struct Comparison {
    size_t seen = 0;
    size_t same = 0;
    double largest = 0;  // error of the device's grids
    long cells = 0;
    long cellsOnDevice = 0;
};

Comparison compared(const Drawing& drawing, const std::map<KsQuadKey, Grid>& device)
{
    Comparison sum;
    for (std::uint32_t k = 0; k < drawing.cpuScene.ksquadCount(); ++k) {
        const std::uint32_t surface = drawing.cpuScene.ksquad(k).surface;
        const KsQuad quad = drawing.ksquad(k);
        const auto found =
            device.find({static_cast<int>(drawing.residents[surface].id), quad.spanU, quad.spanV});
        const VertexGrid& own = drawing.grids.grids()[k];
        if (found == device.end()) {
            EXPECT_EQ(own.u, 0U) << "KSQuad " << k << " is not drawn";
            continue;
        }
        const Grid& grid = found->second;
        ++sum.seen;
        sum.same += grid == Grid{static_cast<int>(own.u), static_cast<int>(own.v)} ? 1 : 0;
        sum.cells += static_cast<long>(own.cells());
        sum.cellsOnDevice += grid.cells();
        const Mat4 toPixels = drawing.toPixels(surface);
        const ScreenView view{toPixels, -drawing.middle, drawing.middle};
        sum.largest =
            std::max(sum.largest, measuredError(transformed(drawing.net(k), toPixels), view, grid, false, 4));
    }
    return sum;
}

TEST(DrawnGrids, OfTheDeviceAreThoseOfTheSameTextInCpp)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::compute);
    for (const char* name : kSamples)
        for (const double tolerance : {4.0, 0.5}) {
            SCOPED_TRACE(std::string(name) + " at " + std::to_string(tolerance));
            const Scene scene = findSample(name)->make();
            Frame frame = frameOf(scene, PathId::compute, 640, 480);
            frame.tolerancePx = tolerance;
            ASSERT_TRUE(renderer->sync(scene));
            const auto vertices = renderer->captureVertices(frame);
            ASSERT_TRUE(vertices) << vertices.error().sentence();
            const Comparison sum = compared(Drawing(scene, frame), gridsOf(*vertices));
            EXPECT_GT(sum.seen, 0U);
            EXPECT_LE(sum.largest, tolerance * 1.0001);
            // Float makes some grids a little finer.
            EXPECT_GE(sum.same, sum.seen * 9 / 10);
            EXPECT_GE(static_cast<double>(sum.cellsOnDevice), 0.99 * static_cast<double>(sum.cells));
            EXPECT_LE(static_cast<double>(sum.cellsOnDevice), 1.05 * static_cast<double>(sum.cells));
        }
}

// Where weights differ by orders of magnitude within a KSQuad a triangle's parameters run unevenly.
TEST(DrawnGrids, AreMeasuredWithTheTruthOfUnequalWeights)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("extremes")->make();
    for (const PathId path : {PathId::mesh, PathId::tessellation, PathId::compute, PathId::cpu}) {
        if (!renderer->whyUnavailable(path).empty())
            continue;
        Frame frame = frameOf(scene, path, 640, 480);
        frame.shading = Shading::error;
        frame.tolerancePx = 4;
        const FrameStats stats = drawn(*renderer, scene, frame).stats;
        EXPECT_LE(*stats.errorPxMax, 4 + KNOTSPAN_ERROR_NOISE_PX) << static_cast<int>(path);
        EXPECT_GT(*stats.errorPxMax, 1.0);
    }
}

}  // namespace
}  // namespace knotspan::testing
