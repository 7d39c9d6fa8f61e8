#include "model/mesh/tessellation.h"

#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/primitives.h"
#include "model/mesh/deviation_measuring.h"
#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"
#include "tests/model/mesh/half_edge_mesh.h"
#include "tests/model/trimming/loop_samples.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

using testing::halfEdgesOf;

Tessellation meshOf(const Scene& scene, double deviation)
{
    auto mesh = tessellate(scene, {.deviation = deviation});
    EXPECT_TRUE(mesh) << mesh.error().sentence();
    return mesh ? *std::move(mesh) : Tessellation{};
}

// A few spots: (share of the model's size), finer where that stays quick.
const std::vector<double> kShares{10, 0.1, 1e-2, 1e-3, 1e-4};

void expectClosed(const TriangleMesh& mesh, long euler)
{
    const MeshTopology topology = topologyOf(mesh);
    EXPECT_EQ(topology.boundaryEdges, 0U);
    EXPECT_EQ(topology.nonManifoldEdges, 0U);
    EXPECT_EQ(topology.turnedEdges, 0U);
    EXPECT_EQ(topology.degenerate, 0U);
    EXPECT_EQ(topology.usedVertices, mesh.vertices.size());
    EXPECT_EQ(topology.euler, euler);
    const testing::HalfEdgeFigures other = halfEdgesOf(mesh);
    EXPECT_TRUE(other.read);
    EXPECT_TRUE(other.manifold);
    EXPECT_EQ(other.boundaryEdges, 0U);
    EXPECT_EQ(other.edges, topology.edges);
    EXPECT_GT(volumeOf(mesh), 0);
}

TEST(Tessellation, KeepsEverySampleWithinTheDeviationThatIsAsked)
{
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        const double size = scene.bounds().diagonal();
        for (const double share : kShares) {
            if (share < 1e-3 && (sample.name == "extremes" || sample.name == "knot"))
                continue;
            const Tessellation mesh = meshOf(scene, share * size);
            const double measured = measuredDeviation(mesh, scene).largest;
            EXPECT_LE(mesh.bound, share * size) << sample.name;
            EXPECT_LE(measured, mesh.bound + 1e-12 * size) << sample.name << " at " << share;
            EXPECT_TRUE(mesh.notes.empty()) << mesh.notes.front();
        }
    }
}

TEST(Tessellation, GivesClosedSamplesAsClosedManifoldsThatLookOutwards)
{
    const std::vector<std::pair<std::string, long>> closed{{"sphere", 2}, {"torus", 0}, {"knot", 0}};
    for (const auto& [name, euler] : closed) {
        const Scene scene = findSample(name)->make();
        for (const double share : kShares)
            if (share > 1e-4 || name != "knot") {
                SCOPED_TRACE(name + " at " + std::to_string(share));
                expectClosed(meshOf(scene, share * scene.bounds().diagonal()).mesh, euler);
            }
    }
}

TEST(Tessellation, LeavesNoEdgeOpenAtTJoints)
{
    const Scene scene = testing::torusWithTJoints();
    for (const double deviation : {1.0, 0.1, 0.01, 1e-3, 1e-4}) {
        SCOPED_TRACE(deviation);
        const Tessellation mesh = meshOf(scene, deviation);
        expectClosed(mesh.mesh, 0);
        EXPECT_LE(measuredDeviation(mesh, scene).largest, mesh.bound * (1 + 1e-12));
    }
}

TEST(Tessellation, OpensOnlyEdgesThatNobodyShares)
{
    for (const testing::Joined& joined : testing::joinedSurfaces()) {
        Scene scene;
        for (const NurbsSurface& surface : joined.surfaces)
            scene.add({.name = joined.name, .surface = surface});
        const CoincidentEdges edges(testing::placed(joined.surfaces));
        const Tessellation mesh = meshOf(scene, 0.003);
        // Every boundary edge lies along a side that is its surface's alone, at least in part.
        EXPECT_LE(measuredDeviation(mesh, scene).largest, mesh.bound + 1e-12) << joined.name;
        Scene apart;
        for (size_t k = 0; k < joined.surfaces.size(); ++k) {
            Mat4 moved(1.0);
            moved[3] = Vec4(100.0 * static_cast<double>(k), 0, 0, 1);
            apart.add({.name = joined.name, .transform = moved, .surface = joined.surfaces[k]});
        }
        EXPECT_LT(topologyOf(mesh.mesh).boundaryEdges, topologyOf(meshOf(apart, 0.003).mesh).boundaryEdges)
            << joined.name;
        EXPECT_EQ(topologyOf(mesh.mesh).degenerate, 0U);
    }
}

TEST(Tessellation, ConvergesToTheVolumeOfTheSphere)
{
    const double radius = 3;
    const Scene scene = testing::sceneOf(sphere({5, -2, 1}, radius));
    const double volume = 4.0 / 3 * M_PI * radius * radius * radius;
    for (const double deviation : {0.3, 0.03, 0.003}) {
        const double found = volumeOf(meshOf(scene, deviation).mesh);
        EXPECT_LT(found, volume);
        EXPECT_GT(found, volume - 4 * M_PI * radius * radius * deviation);
    }
}

TEST(Tessellation, TurnsMirroredAndInvertedBodiesOutwards)
{
    const NurbsSurface body = torus({0, 0, 0}, 3, 1);
    for (const NurbsSurface& surface : {body, testing::reversedU(body), testing::exchanged(body)})
        for (const bool mirrored : {false, true}) {
            Scene scene;
            scene.add({.name = "torus",
                       .transform = glm::scale(Mat4(1.0), Vec3(1, mirrored ? -2 : 2, 1)),
                       .surface = surface});
            expectClosed(meshOf(scene, 0.05).mesh, 0);
        }
}

TEST(Tessellation, LooksWhereTheSurfacePointsWhereItIsOpen)
{
    const Vec3 up(0, 0, 1);
    const NurbsSurface sheet = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (const bool mirrored : {false, true}) {
        Scene scene;
        scene.add({.name = "sheet",
                   .transform = glm::scale(Mat4(1.0), Vec3(mirrored ? -1 : 1, 1, 1)),
                   .surface = sheet});
        const TriangleMesh mesh = meshOf(scene, 0.1).mesh;
        ASSERT_EQ(mesh.triangles.size(), 2U);
        for (const Triangle& t : mesh.triangles)
            EXPECT_GT(glm::dot(up, glm::cross(mesh.vertices[t[1]] - mesh.vertices[t[0]],
                                              mesh.vertices[t[2]] - mesh.vertices[t[0]])),
                      0);
    }
}

TEST(Tessellation, TurnsNormalsNoFurtherThanAboutTheAngleThatIsAsked)
{
    const Scene scene = testing::sceneOf(sphere({0, 0, 0}, 1));
    size_t before = 0;
    for (const double degrees : {20.0, 10.0, 5.0}) {
        const auto mesh = tessellate(scene, {.deviation = 10, .angleDegrees = degrees});
        ASSERT_TRUE(mesh);
        EXPECT_LE(measuredDeviation(*mesh, scene, true).largestAngle, 1.1 * degrees);
        EXPECT_GT(mesh->mesh.triangles.size(), 2 * before);
        before = mesh->mesh.triangles.size();
    }
}

TEST(Tessellation, SaysWhatItDoesNotDo)
{
    Scene scene = findSample("sphere")->make();
    EXPECT_FALSE(tessellate(Scene{}, {.deviation = 1}));
    const auto tooFine = tessellate(scene, {.deviation = 1e-9, .mostTriangles = 1000});
    ASSERT_FALSE(tooFine);
    EXPECT_NE(tooFine.error().sentence().find("larger deviation"), std::string::npos);
    const ObjectId id = scene.objects().begin()->first;
    SceneObject object = *scene.find(id);
    object.trimLoops = {{true, {testing::polyline({{0.1, 0.1}, {0.9, 0.1}, {0.5, 0.9}})}}};
    scene.exchange(id, std::make_shared<const SceneObject>(object));
    const Tessellation whole = meshOf(scene, 0.1);
    ASSERT_EQ(whole.notes.size(), 1U);
    EXPECT_NE(whole.notes.front().find("trim loops cannot be followed"), std::string::npos);
    EXPECT_EQ(whole.uncut, 1U);
    EXPECT_EQ(topologyOf(whole.mesh).boundaryEdges, 0U);
    object.visible = false;
    scene.exchange(id, std::make_shared<const SceneObject>(object));
    EXPECT_FALSE(tessellate(scene, {.deviation = 1}));
    EXPECT_TRUE(tessellate(scene, {.deviation = 1, .hiddenToo = true}));
}

}  // namespace
}  // namespace knotspan
