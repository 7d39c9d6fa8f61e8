#include "model/scene/mesh_object.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/scene/edit.h"
#include "tests/model/scene/simple_object.h"

namespace knotspan {
namespace {

MeshObject triangle(const std::string& name)
{
    return meshObject(name, {{{0, 0, 0}, {4, 0, 0}, {0, 0, 2}}, {{0, 1, 2}}});
}

TEST(Meshes, StandBesideTheObjectsUnderIdsOfTheirOwn)
{
    Scene scene;
    const ObjectId surface = scene.add(testing::simpleObject("surface"));
    const Box before = scene.bounds();
    const ObjectId mesh = scene.addMesh(triangle("mesh"));
    EXPECT_NE(surface, mesh);
    EXPECT_EQ(scene.find(mesh), nullptr);
    ASSERT_EQ(scene.meshes().count(mesh), 1U);
    EXPECT_EQ(scene.bounds().high.x, std::max(before.high.x, 4.0));
    EXPECT_NE(scene.add(testing::simpleObject("later")), mesh);
}

TEST(Meshes, AreBoundedWhereTheyArePlaced)
{
    MeshObject mesh = triangle("mesh");
    mesh.transform = glm::translate(Mat4(1.0), Vec3(10, 0, 0));
    EXPECT_EQ(mesh.bounds().low, Vec3(10, 0, 0));
    EXPECT_EQ(mesh.bounds().high, Vec3(14, 0, 2));
}

TEST(Meshes, AreEqualByValue)
{
    Scene a;
    a.addMesh(triangle("mesh"));
    Scene b;
    b.addMesh(triangle("mesh"));
    EXPECT_TRUE(a == b);
    MeshObject other = triangle("mesh");
    other.mesh =
        std::make_shared<const TriangleMesh>(TriangleMesh{{{0, 0, 0}, {4, 0, 0}, {0, 0, 3}}, {{0, 1, 2}}});
    b.exchangeMesh(ObjectId{0}, std::make_shared<const MeshObject>(other));
    EXPECT_FALSE(a == b);
    Scene c = a;
    c = b;
    EXPECT_TRUE(c == b);
    const Scene moved = std::move(c);
    EXPECT_TRUE(moved == b);
}

TEST(Meshes, AreSwappedByEditsAndSwappedBack)
{
    Scene scene;
    const ObjectId removed = scene.addMesh(triangle("removed"));
    const Scene before = scene;
    Edit edit;
    edit.setMesh(removed, nullptr);
    edit.setMesh(ObjectId{5}, std::make_shared<const MeshObject>(triangle("added")));
    EXPECT_FALSE(edit.isEmpty());
    edit.applyTo(scene);
    EXPECT_EQ(scene.meshes().size(), 1U);
    EXPECT_EQ(scene.meshes().at(ObjectId{5})->name, "added");
    Edit more;
    more.setMesh(ObjectId{5}, nullptr);
    more.applyTo(scene);
    edit.absorb(more);
    edit.applyTo(scene);
    EXPECT_TRUE(scene == before);
    EXPECT_EQ(scene.meshes().at(removed), before.meshes().at(removed)) << "the very same, so nothing is sent";
}

}  // namespace
}  // namespace knotspan
