#include "model/formats/mesh_export.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "model/formats/verified_writing.h"
#include "model/samples/sample_list.h"
#include "tests/support.h"

namespace knotspan::formats {
namespace {

TEST(MeshExport, IsWithinTheDeviationAndSaysWhatWasReadBackFromEveryFormat)
{
    const testing::TemporaryFolder folder;
    const Scene scene = findSample("torus")->make();
    const double asked = 0.003 * scene.bounds().diagonal();
    for (const MeshFormat& format : meshFormats()) {
        const MeshExportOptions options{format.kind, asked, {}, true};
        const auto report = exportMesh(scene, folder / ("a." + format.extension), options);
        ASSERT_TRUE(report) << report.error().sentence();
        EXPECT_EQ(report->boundaryEdges + report->nonManifoldEdges, 0U) << format.name;
        ASSERT_TRUE(report->deviation) << format.name;
        EXPECT_EQ(report->deviation->asked, asked) << format.name;
        EXPECT_LE(report->deviation->measured, report->deviation->bound) << format.name;
        EXPECT_LE(report->deviation->measured, asked) << format.name;
        EXPECT_GT(report->deviation->measured, 0.1 * asked) << format.name;
        const auto counts = meshCounts(scene, options);
        ASSERT_TRUE(counts) << format.name;
        EXPECT_EQ(counts->triangles, report->counts.triangles) << format.name;
        EXPECT_EQ(counts->vertices, report->counts.vertices) << format.name;
    }
}

TEST(MeshExport, WritesMeshesOfTheSceneAsTheyAreBesideItsSurfaces)
{
    const testing::TemporaryFolder folder;
    Scene scene = findSample("sphere")->make();
    MeshObject tile = meshObject("tile", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    tile.transform = glm::scale(glm::translate(Mat4(1.0), Vec3(10, 0, 0)), Vec3(1, 1, -1));
    scene.addMesh(tile);
    const MeshExportOptions options{MeshKind::ply, 0.01, {}, true};
    const auto both = exportMesh(scene, folder / "both.ply", options);
    ASSERT_TRUE(both) << both.error().sentence();
    EXPECT_EQ(both->boundaryEdges, 3U);
    EXPECT_LE(both->deviation->measured, 0.01);
    Scene alone;
    alone.addMesh(tile);
    const auto mesh = exportMesh(alone, folder / "mesh.ply", options);
    ASSERT_TRUE(mesh) << mesh.error().sentence();
    EXPECT_EQ(mesh->counts.triangles, 1U);
    EXPECT_FALSE(mesh->deviation);
    // Mirrored: turned over, so that its front stays the front.
    const Scene back = read(folder / "mesh.ply").value();
    EXPECT_EQ(back.meshes().begin()->second->mesh->triangles[0], (Triangle{0, 2, 1}));
    EXPECT_FALSE(exportMesh(Scene(), folder / "none.ply", options));
}

TEST(MeshExport, BeyondItsDeviationInTheFilesNumbersLeavesTheOldFile)
{
    const testing::TemporaryFolder folder;
    testing::writeFile(folder / "a.stl", "old");
    // A sphere of radius 1 in a place where float's numbers are 1 apart.
    Scene scene;
    SceneObject far = *findSample("sphere")->make().objects().begin()->second;
    far.transform = glm::translate(Mat4(1.0), Vec3(1e7, 0, 0)) * far.transform;
    scene.add(far);
    const auto refused = exportMesh(scene, folder / "a.stl", {MeshKind::stl, 0.01, {}, true});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().what.find("7 digits"), std::string::npos) << refused.error().sentence();
    EXPECT_EQ(testing::readFile(folder / "a.stl"), "old");
    // glTF's numbers are those from one of its vertices.
    const auto kept = exportMesh(scene, folder / "a.glb", {MeshKind::glb, 0.01, {}, true});
    ASSERT_TRUE(kept) << kept.error().sentence();
    EXPECT_LE(kept->deviation->measured, 0.01);
}

TEST(VerifiedWriting, TellsTheDifferenceAndKeepsTheOldFileWhereSomethingIsLost)
{
    const testing::TemporaryFolder folder;
    const Scene scene = findSample("hull")->make();
    for (const char* name : {"a.knotspan", "a.obj"}) {
        const auto difference = writeVerified(scene, folder / name);
        ASSERT_TRUE(difference) << difference.error().sentence();
        EXPECT_LE(difference->largest(), kLostNothing) << name;
    }
    testing::writeFile(folder / "b.knotspan", "old");
    EXPECT_FALSE(writeVerified(scene, folder / "absent" / "b.knotspan"));
    EXPECT_EQ(testing::readFile(folder / "b.knotspan"), "old");
}

}  // namespace
}  // namespace knotspan::formats
