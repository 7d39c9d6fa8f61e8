// What the path cpu draws, looked at without a device.
#include <array>
#include <cstring>
#include <map>

#include <gtest/gtest.h>

#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "renderer/scene/adaptive_grids.h"
#include "renderer/scene/cell_indices.h"
#include "renderer/scene/uniform_grids.h"

namespace knotspan::testing {
namespace {

std::vector<PlacedSurface> placed(const std::vector<Resident>& residents)
{
    std::vector<PlacedSurface> surfaces;
    for (const Resident& resident : residents)
        surfaces.push_back({&resident.object->surface, resident.object->transform});
    return surfaces;
}

// A scene as it is on the CPU, and one picture of it.
struct Drawing {
    explicit Drawing(Scene drawnScene, double tolerance = 0.5)
        : scene(std::move(drawnScene)),
          camera(*namedView("iso", scene.hullPoints(), 4.0 / 3.0, false)),
          tolerancePx(tolerance),
          residents(makeResidents(visibleObjects(scene))),
          edges(placed(residents))
    {
    }

    AdaptiveGrids::Work update()
    {
        const auto changes = cpuScene.update(residents, edges.tables(), Evaluator::triangular);
        return grids.update(cpuScene, changes,
                            GridView::of(residents, camera, 640, 480, scene.bounds(), tolerancePx, cullBits,
                                         ShownSides::asTold(residents)));
    }

    void moveControlPoint(ObjectId id, ControlPointIndex index, const Vec3& by)
    {
        const SharedObject before = scene.find(id);
        scene.exchange(id,
                       withControlPointAt(*before, index, controlPointInModel(*before, index) + by).value());
        std::vector<CoincidentEdges::Change> changes;
        for (std::uint32_t k = 0; k < residents.size(); ++k)
            if (residents[k].id == id) {
                residents[k].object = scene.find(id);
                changes.push_back({k, {&residents[k].object->surface, residents[k].object->transform}});
            }
        (void)edges.update(changes);
    }

    Scene scene;
    Camera camera;
    double tolerancePx;
    std::uint32_t cullBits = 0;
    std::vector<Resident> residents;
    SharedEdges edges;
    CpuScene cpuScene;
    AdaptiveGrids grids;
};

// A point by its surface and its bits.
using PointBits = std::array<std::uint32_t, 4>;

PointBits bitsOf(const CpuScene& scene, const gpu::ObjectVertex& vertex)
{
    PointBits bits{scene.ksquad(vertex.source).surface};
    std::memcpy(&bits[1], &vertex.position, sizeof(vertex.position));
    return bits;
}

// How often triangles go along each edge one way more than the other. Nowhere where they close without a gap.
std::map<std::pair<PointBits, PointBits>, int> openEdges(Drawing& drawing)
{
    std::map<std::pair<PointBits, PointBits>, int> edges;
    CellIndices cells;
    cells.provide(drawing.grids.grids());
    for (const VertexGrid& grid : drawing.grids.grids()) {
        if (grid.u == 0)
            continue;
        const gpu::ObjectVertex* vertices = drawing.grids.store().at(grid);
        const std::uint32_t first = cells.firstOf(grid);
        for (std::uint32_t k = 0; k < 6 * grid.cells(); ++k) {
            const std::uint32_t next = k % 3 == 2 ? k - 2 : k + 1;
            const auto a = bitsOf(drawing.cpuScene, vertices[cells.indices()[first + k]]);
            const auto b = bitsOf(drawing.cpuScene, vertices[cells.indices()[first + next]]);
            if (a != b)
                edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    for (auto edge = edges.begin(); edge != edges.end();)
        edge = edge->second == 0 ? edges.erase(edge) : std::next(edge);
    return edges;
}

TEST(CpuGrids, OfClosedSamplesCloseToTheBit)
{
    for (const char* name : {"torus", "sphere"})
        for (const double tolerance : {4.0, 0.5, 0.05}) {
            Drawing drawing(findSample(name)->make(), tolerance);
            EXPECT_GT(drawing.update().evaluations, 0U) << name;
            EXPECT_EQ(openEdges(drawing).size(), 0U) << name << " at " << tolerance;
        }
}

TEST(CpuGrids, LeaveWorkThatIsDoneAlone)
{
    Drawing drawing(findSample("nine-16")->make());
    EXPECT_GT(drawing.update().evaluations, 0U);
    const auto again = drawing.update();
    EXPECT_EQ(again.chosen, 0U);
    EXPECT_EQ(again.built, 0U);
    EXPECT_EQ(again.evaluations, 0U);
}

TEST(CpuGrids, KeepThoseThatASmallMotionOfTheCameraLeavesAsTheyAre)
{
    Drawing drawing(findSample("single-100")->make());
    const auto first = drawing.update();
    drawing.camera.orbit(0.01, 0.0);
    const auto second = drawing.update();
    EXPECT_EQ(second.chosen, drawing.cpuScene.ksquadCount());
    EXPECT_LT(second.evaluations, first.evaluations / 2);
}

// Bit for bit as if made anew.
void expectSameVertices(Drawing& held, Drawing& fresh)
{
    const auto& grids = held.grids.grids();
    ASSERT_EQ(grids.size(), fresh.grids.grids().size());
    for (size_t k = 0; k < grids.size(); ++k) {
        ASSERT_EQ(grids[k].u, fresh.grids.grids()[k].u) << k;
        ASSERT_EQ(grids[k].v, fresh.grids.grids()[k].v) << k;
        if (grids[k].u > 0) {
            ASSERT_EQ(std::memcmp(held.grids.store().at(grids[k]),
                                  fresh.grids.store().at(fresh.grids.grids()[k]),
                                  grids[k].vertexCount() * sizeof(gpu::ObjectVertex)),
                      0)
                << "KSQuad " << k;
        }
    }
}

void expectAsIfMadeAnew(Drawing& drawing)
{
    Drawing fresh(drawing.scene, drawing.tolerancePx);
    fresh.camera = drawing.camera;
    fresh.cullBits = drawing.cullBits;
    fresh.residents = drawing.residents;  // packed from the same origins
    (void)fresh.update();
    expectSameVertices(drawing, fresh);
}

TEST(CpuGrids, MakeThoseOfAMovedControlPointAnewAndNoOthers)
{
    Drawing drawing(findSample("single-100")->make());
    (void)drawing.update();
    const ObjectId id = drawing.residents.front().id;
    const NurbsSurface& surface = drawing.residents.front().object->surface;
    const auto most = static_cast<std::uint32_t>((surface.degreeU() + 1) * (surface.degreeV() + 1));
    drawing.moveControlPoint(id, {5, 6}, {0, 0, 1e-5});  // so little that no count of cells changes
    const auto work = drawing.update();
    EXPECT_EQ(work.chosen, most);
    EXPECT_EQ(work.built, most);
    expectAsIfMadeAnew(drawing);
    drawing.moveControlPoint(id, {5, 6}, {0, 0, 0.2});
    EXPECT_LT(drawing.update().built, drawing.cpuScene.ksquadCount() / 2);
    expectAsIfMadeAnew(drawing);
}

TEST(CpuGrids, FollowBordersThatMove)
{
    for (const char* name : {"nine-16", "torus", "hull"}) {
        Drawing drawing(findSample(name)->make());
        (void)drawing.update();
        for (const double by : {0.1, -0.1, 0.01}) {
            for (const Resident& resident : std::vector<Resident>(drawing.residents)) {
                drawing.moveControlPoint(resident.id, {0, 1}, {0, 0, by});
                (void)drawing.update();
                ASSERT_NO_FATAL_FAILURE(expectAsIfMadeAnew(drawing)) << name;
            }
        }
    }
}

// What turns away is dropped at once, by a surface's corner or a KSQuad's.
TEST(CpuGrids, FollowWhatIsCulled)
{
    Drawing drawing(findSample("nine-16")->make());
    for (const std::uint32_t bits : {1U, 2U, 3U, 0U}) {
        drawing.cullBits = bits;
        (void)drawing.update();
        for (const double by : {6.0, -6.0}) {
            drawing.moveControlPoint(drawing.residents[4].id, {0, 0}, {by, by, 0});
            (void)drawing.update();
            ASSERT_NO_FATAL_FAILURE(expectAsIfMadeAnew(drawing)) << bits;
        }
    }
}

TEST(CpuGrids, FollowCamerasAndTolerances)
{
    Drawing drawing(findSample("hull")->make());
    for (const double tolerance : {8.0, 0.2, 1.0, 0.2})
        for (int step = 0; step < 3; ++step) {
            drawing.tolerancePx = tolerance;
            drawing.camera.orbit(0.7, 0.1);
            drawing.camera.zoomAt(step == 0 ? 0.3 : 1.5, {0, 0});
            (void)drawing.update();
            ASSERT_NO_FATAL_FAILURE(expectAsIfMadeAnew(drawing));
        }
}

TEST(CpuGrids, UniformlyMakeOnlyWhatChanged)
{
    Drawing drawing(findSample("nine-16")->make());
    UniformGrids uniform;
    EXPECT_EQ(uniform.update(drawing.residents, 10), 9U * 11 * 11);
    EXPECT_EQ(uniform.update(drawing.residents, 10), 0U);
    drawing.moveControlPoint(drawing.residents[4].id, {1, 1}, {0, 0, 0.1});
    EXPECT_EQ(uniform.update(drawing.residents, 10), 11U * 11);
    EXPECT_EQ(uniform.update(drawing.residents, 11), 9U * 12 * 12);
}

TEST(VertexStore, UsesPlacesAgainAndClosesGaps)
{
    VertexStore store;
    std::vector<VertexGrid> grids(3);
    for (VertexGrid& grid : grids)
        store.place(grid, 2, 3);
    EXPECT_EQ(store.vertices().size(), 36U);
    store.at(grids[2])->ksquad = 7;
    store.place(grids[0], 0, 0);
    store.place(grids[1], 0, 0);
    store.place(grids[0], 3, 2);  // as many vertices: in a gap
    EXPECT_EQ(grids[0].first, 12U);
    EXPECT_EQ(store.vertices().size(), 36U);
    store.compact(grids, true);
    EXPECT_EQ(store.vertices().size(), 24U);
    EXPECT_EQ(store.at(grids[2])->ksquad, 7U);
    const auto ranges = store.takeChanged();
    ASSERT_EQ(ranges.size(), 1U);
    EXPECT_EQ(ranges[0].count, 24U);
    EXPECT_TRUE(store.takeChanged().empty());
}

}  // namespace
}  // namespace knotspan::testing
