#include "model/mesh/tessellation.h"
#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

Scene meshOf(const Scene& scene, double deviation)
{
    MeshObject mesh = meshObject("mesh", tessellate(scene, {.deviation = deviation}).value().mesh);
    mesh.colour = scene.objects().begin()->second->colour;
    Scene result;
    result.addMesh(std::move(mesh));
    return result;
}

TEST(ReferenceMeshes, CoverWhatTheirSurfacesDo)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene surfaces = findSample("torus")->make();
    const Scene mesh = meshOf(surfaces, 1e-3);
    const Frame frame = frameOf(surfaces, renderer->bestPath());
    const Picture expected = drawn(*renderer, surfaces, frame).picture;
    const Drawn seen = drawn(*renderer, mesh, frame);
    const Difference difference = compare(seen.picture, expected);
    EXPECT_EQ(difference.silhouetteOff, 0U);
    EXPECT_LT(difference.meanShaded, 3) << "flat triangles, the same light";
    EXPECT_EQ(seen.stats.ksquads, 0U);
    EXPECT_TRUE(renderer->validationMessages().empty());
}

TEST(ReferenceMeshes, HideWhatIsBehindThemAndAreNotPicked)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    Scene both = findSample("sphere")->make();
    const Frame frame = frameOf(both, renderer->bestPath(), 160, 120, "top");
    ASSERT_TRUE(drawn(*renderer, both, frame).stats.triangles > 0);
    ASSERT_TRUE(renderer->pick(80, 60)->place) << "the sphere, before anything is above it";
    const Box box = both.bounds();
    const double up = box.high.z + 0.01 * box.diagonal();
    const Vec3 low(box.low.x, box.low.y, up);
    const Vec3 high(box.high.x, box.high.y, up);
    MeshObject lid =
        meshObject("lid", {{low, {high.x, low.y, up}, high, {low.x, high.y, up}}, {{0, 1, 2}, {0, 2, 3}}});
    lid.colour = {0.1, 0.9, 0.1};
    const ObjectId id = both.addMesh(lid);
    const Picture covered = drawn(*renderer, both, frame).picture;
    const std::uint32_t colour = colourAt(covered, 80, 60);
    EXPECT_GT(colour >> 8U & 255U, (colour >> 16U & 255U) + 50) << "the lid's green";
    EXPECT_FALSE(renderer->pick(80, 60)->place);
    const auto indices = renderer->captureKsQuads();
    EXPECT_EQ(indices->indices[60 * 160 + 80], 0U);

    auto hidden = std::make_shared<MeshObject>(*both.meshes().at(id));
    hidden->visible = false;
    both.exchangeMesh(id, hidden);
    (void)drawn(*renderer, both, frame);
    EXPECT_TRUE(renderer->pick(80, 60)->place);
}

TEST(ReferenceMeshes, TravelOnceAndMoveForNothing)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene surfaces = findSample("sphere")->make();
    Scene mesh = meshOf(surfaces, 1e-2);
    const Frame frame = frameOf(surfaces, renderer->bestPath());
    (void)drawn(*renderer, mesh, frame);
    EXPECT_EQ(drawn(*renderer, mesh, frame).stats.uploadBytesPerFrame, 0U);
    auto coloured = std::make_shared<MeshObject>(*mesh.meshes().begin()->second);
    coloured->colour = {1, 0, 0};
    mesh.exchangeMesh(mesh.meshes().begin()->first, coloured);
    EXPECT_EQ(drawn(*renderer, mesh, frame).stats.uploadBytesPerFrame, 0U);
    EXPECT_TRUE(renderer->validationMessages().empty());
}

// In float the vertices themselves would be 60 apart.
TEST(ReferenceMeshes, KeepTheirShapeFarFromTheOrigin)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene surfaces = findSample("sphere")->make();
    const Scene mesh = meshOf(surfaces, 1e-2);
    Frame frame = frameOf(surfaces, renderer->bestPath());
    const Picture near = drawn(*renderer, mesh, frame).picture;
    const Vec3 away(1e9, -2e9, 1e9);
    TriangleMesh moved = *mesh.meshes().begin()->second->mesh;
    for (Vec3& vertex : moved.vertices)
        vertex += away;
    Scene far;
    far.addMesh(meshObject("far", std::move(moved)));
    frame.camera.eye += away;
    frame.camera.target += away;
    EXPECT_EQ(compare(drawn(*renderer, far, frame).picture, near).silhouetteOff, 0U);
}

}  // namespace
}  // namespace knotspan::testing
