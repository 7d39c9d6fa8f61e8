// Meshes in .knotspan files.
#include <array>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "model/files/base64.h"
#include "model/formats/format_list.h"
#include "tests/support.h"

namespace knotspan {
namespace {

Scene withMesh()
{
    MeshObject mesh =
        meshObject("scan \xc3\xa9", {{{0.1, -0.0, 5e-324}, {1.0 / 3, 1e300, 2}, {-7, 8, 9}, {1, 1, 1}},
                                     {{0, 1, 2}, {2, 1, 3}}});
    mesh.colour = {0.1, 0.2, 0.3};
    mesh.transform[3] = {1, 2, 3, 1};
    mesh.visible = false;
    Scene scene;
    scene.addMesh(std::move(mesh));
    return scene;
}

TEST(Base64, IsRfc4648s)
{
    // The examples of its section 10.
    const std::vector<std::pair<std::string, std::string>> examples{
        {"", ""},        {"f", "Zg=="},        {"fo", "Zm8="},
        {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : examples) {
        EXPECT_EQ(formats::base64Of(std::as_bytes(std::span(bytes))), text);
        const auto back = formats::bytesOfBase64(text);
        ASSERT_TRUE(back);
        EXPECT_EQ(std::string(reinterpret_cast<const char*>(back->data()), back->size()), bytes);
    }
    for (const char* wrong : {"Z", "Zg=", "Zg", "Z===", "====", "Zg==Zg==", "Zm9\n", "Zm9v!mFy"})
        EXPECT_FALSE(formats::bytesOfBase64(wrong)) << wrong;
}

TEST(KnotspanMeshes, ComeBackToTheBit)
{
    const testing::TemporaryFolder folder;
    const Scene scene = withMesh();
    ASSERT_TRUE(formats::write(scene, folder / "a.knotspan"));
    const auto back = formats::read(folder / "a.knotspan");
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_TRUE(*back == scene);
    EXPECT_TRUE(std::signbit(back->meshes().begin()->second->mesh->vertices[0].y));
    ASSERT_TRUE(formats::write(*back, folder / "b.knotspan"));
    EXPECT_EQ(testing::readFile(folder / "a.knotspan"), testing::readFile(folder / "b.knotspan"));
}

TEST(KnotspanMeshes, AreRefusedWithTheirPlaceWhereTheyAreNone)
{
    const testing::TemporaryFolder folder;
    ASSERT_TRUE(formats::write(withMesh(), folder / "a.knotspan"));
    const auto good = nlohmann::json::parse(testing::readFile(folder / "a.knotspan"));
    const auto sentenceOf = [&](const std::string& member, const nlohmann::json& value) {
        nlohmann::json json = good;
        json["meshes"][0][member] = value;
        testing::writeFile(folder / "b.knotspan", json.dump());
        const auto read = formats::read(folder / "b.knotspan");
        return read ? std::string() : read.error().sentence();
    };
    const std::array<double, 3> infinite{1, std::numeric_limits<double>::infinity(), 2};
    const std::array<std::uint32_t, 3> beyond{0, 1, 4};
    const auto text = [](const auto& numbers) {
        return formats::base64Of(std::as_bytes(std::span(numbers)));
    };
    EXPECT_NE(sentenceOf("vertices", "AAA").find("is no base64"), std::string::npos);
    EXPECT_NE(sentenceOf("vertices", "AAAA").find("whole number"), std::string::npos);
    EXPECT_NE(sentenceOf("vertices", text(infinite)).find("meshes[0], vertices"), std::string::npos);
    EXPECT_NE(sentenceOf("triangles", text(beyond)).find("names a vertex that is not there"),
              std::string::npos);
    EXPECT_NE(sentenceOf("triangles", 7).find("is not a text"), std::string::npos);
    EXPECT_NE(sentenceOf("name", nullptr).find("is not a text"), std::string::npos);
}

}  // namespace
}  // namespace knotspan
