#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/renderer.h"
#include "tests/app/run_program.h"
#include "tests/support.h"

using namespace knotspan;
using namespace knotspan::testing;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

class RenderCommand : public ::testing::Test {
protected:
    void SetUp() override
    {
        ASSERT_EQ(runProgram({"sample", "nine-16", "-o", model}).exitCode, 0);
        fs::create_directory(folder / "out");
    }

    void needDevice()
    {
        if (const auto renderer = Renderer::create(); !renderer)
            GTEST_SKIP() << renderer.error().sentence();
    }

    // Renders a small picture; returns its bytes.
    std::string render(std::vector<std::string> more)
    {
        more.insert(more.begin(), {"render", model, "-o", picture, "--size", "96x64"});
        const ProgramRun run = runProgram(more);
        EXPECT_EQ(run.exitCode, 0) << run.messages;
        EXPECT_EQ(run.messages, "");
        output = run.output;
        return readFile(picture);
    }

    TemporaryFolder folder;
    std::string model = folder / "model.knotspan";
    std::string picture = folder / "out/picture.png";
    std::string output;
};

}  // namespace

TEST_F(RenderCommand, WritesAPictureAndTheFiguresOfTheContract)
{
    needDevice();
    if (IsSkipped())
        return;
    const std::string png = render({"--stats", "-", "--culling", "none"});
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const Json stats = Json::parse(output);
    for (const char* name :
         {"device", "path", "culling", "tolerance_px", "width", "height", "surfaces", "ksquads",
          "ksquads_drawn", "ksquads_culled", "ksdice", "triangles", "evaluations", "frames", "cpu_ms",
          "gpu_ms", "upload_bytes_first", "upload_bytes_per_frame", "device_bytes"})
        EXPECT_TRUE(stats.contains(name)) << name;
    for (const char* name : {"min", "median", "max"})
        EXPECT_TRUE(stats.at("gpu_ms").contains(name));
    EXPECT_EQ(stats.at("width"), 96);
    EXPECT_EQ(stats.at("height"), 64);
    EXPECT_EQ(stats.at("surfaces"), 9);
    EXPECT_EQ(stats.at("ksquads_drawn"), 9);
    EXPECT_EQ(stats.at("culling"), Json::array({"none"}));
    EXPECT_GT(stats.at("triangles"), 0);
    EXPECT_EQ(stats.at("upload_bytes_per_frame"), 0);
}

TEST_F(RenderCommand, CountsWrongDecisionsOfCullingWhenAsked)
{
    needDevice();
    if (IsSkipped())
        return;
    const std::vector<std::string> lookingUp{"--view", "bottom", "--culling", "lqc", "--stats", "-"};
    const std::string plain = render(lookingUp);
    EXPECT_FALSE(Json::parse(output).contains("wrongly_culled"));
    std::vector<std::string> counting = lookingUp;
    counting.emplace_back("--count-wrong");
    EXPECT_EQ(render(counting), plain);
    // Both sides of a sheet show: all that was dropped should have been drawn.
    const Json stats = Json::parse(output);
    EXPECT_GT(stats.at("wrongly_culled").at("lqc"), 0);
    EXPECT_EQ(stats.at("wrongly_culled").at("lqc"), stats.at("ksquads_culled").at("lqc"));
}

TEST_F(RenderCommand, EachOptionChangesThePicture)
{
    needDevice();
    if (IsSkipped())
        return;
    const std::string plain = render({});
    EXPECT_EQ(render({}), plain);
    for (const std::vector<std::string>& more :
         std::vector<std::vector<std::string>>{{"--view", "top"},
                                               {"--orthographic"},
                                               {"--fov", "60"},
                                               {"--eye", "-3,-4,5"},
                                               {"--eye", "-3,-4,5", "--target", "0,0,0", "--up", "1,0,0"},
                                               {"--shading", "normals"},
                                               {"--net"},
                                               {"--knots"}})
        EXPECT_NE(render(more), plain) << more[0];
}

TEST_F(RenderCommand, ADeformationMovesTheSurfaceAndUploadsOnlyWhatMoved)
{
    needDevice();
    if (IsSkipped())
        return;
    const auto uploaded = [&](const std::string& what) {
        render({"--frames", "3", "--deform", what, "--stats", folder / "out/stats.json"});
        const Json stats = Json::parse(readFile(folder / "out/stats.json"));
        EXPECT_EQ(stats.at("frames"), 3);
        return stats.at("upload_bytes_per_frame").get<long>();
    };
    EXPECT_EQ(uploaded("none"), 0);
    const long point = uploaded("point");
    EXPECT_GT(point, 0);
    EXPECT_LT(point, uploaded("all"));
}

TEST_F(RenderCommand, SaysAndShowsHowFarTheModelIsFromAnother)
{
    needDevice();
    if (IsSkipped())
        return;
    const std::string other = folder / "other.knotspan";
    ASSERT_EQ(runProgram({"sample", "single-100", "-o", other}).exitCode, 0);
    std::vector<std::string> pictures;
    for (const std::string& against : {model, other}) {
        const ProgramRun run = runProgram({"render", model, "-o", picture, "--size", "96x64", "--shading",
                                           "deviation", "--range", "0,1", "--against", against});
        EXPECT_EQ(run.exitCode, 0) << run.messages;
        EXPECT_NE(run.messages.find("largest distance "), std::string::npos) << run.messages;
        EXPECT_NE(run.messages.find("colours to within about "), std::string::npos) << run.messages;
        pictures.push_back(readFile(picture));
    }
    EXPECT_NE(pictures[0], pictures[1]);
}

TEST_F(RenderCommand, RefusesWrongCalls)
{
    const std::vector<std::string> good{"render", model, "-o", picture};
    for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
             {"--size", "96"},
             {"--size", "0x64"},
             {"--size", "96x99999"},
             {"--size", "96x64x"},
             {"--path", "banana"},
             {"--culling", "banana"},
             {"--sampling", "fixed:0"},
             {"--sampling", "x"},
             {"--tolerance", "0"},
             {"--tolerance", "nan"},
             {"--evaluator", "banana"},
             {"--view", "banana"},
             {"--eye", "1,2"},
             {"--target", "1,2,3"},
             {"--eye", "1,2,3", "--target", "1,2,3"},
             {"--eye", "1,2,3", "--up", "0,0,0"},
             {"--eye", "1,2,3", "--view", "top"},
             {"--fov", "0"},
             {"--fov", "180"},
             {"--shading", "banana"},
             {"--stripes", "3"},
             {"--shading", "zebra", "--stripes", "0"},
             {"--shading", "zebra", "--matcap", "clay"},
             {"--shading", "matcap", "--matcap", "banana"},
             {"--shading", "curvature", "--curvature", "banana"},
             {"--shading", "curvature", "--range", "2,1"},
             {"--shading", "curvature", "--range", "2"},
             {"--shading", "draft", "--pull", "0,0,0"},
             {"--shading", "draft", "--draft", "0"},
             {"--shading", "deviation"},
             {"--against", model},
             {"--shading", "checker", "--square-length", "2"},
             {"--shading", "checker", "--checker", "length", "--squares", "3"},
             {"--frames", "0"},
             {"--frames", "1.5"},
             {"--deform", "banana"},
             {"--count-wrong"},
             {"--device", "-1"},
             {"--device", "banana"},
             {"--friends", "G1"}}) {
        std::vector<std::string> call = good;
        call.insert(call.end(), more.begin(), more.end());
        expectWrongCall(call);
    }
    expectWrongCall({"render", model});
    expectWrongCall({"render", model, "-o", folder / "out/picture.jpg"});
    EXPECT_TRUE(fs::is_empty(folder / "out"));
}

TEST_F(RenderCommand, NeverWritesOverTheModelOrOneFileTwice)
{
    const std::string before = readFile(model);
    expectWrongCall({"render", model, "-o", picture, "--stats", model});
    expectWrongCall({"render", model, "-o", picture, "--stats", picture});
    expectWrongCall(
        {"render", model, "-o", picture, "--stats", (folder / "out/../out/picture.png").string()});
    EXPECT_EQ(readFile(model), before);
    EXPECT_FALSE(fs::exists(picture));
}

TEST_F(RenderCommand, SaysSoWhereTheToleranceChangesNothing)
{
    needDevice();
    const auto messagesOf = [&](const char* path) {
        return runProgram(
                   {"render", model, "-o", picture, "--size", "96x64", "--path", path, "--tolerance", "2"})
            .messages;
    };
    EXPECT_EQ(messagesOf("tessellation"), "");
    EXPECT_NE(messagesOf("mesh-9x9").find("mesh-9x9"), std::string::npos);
}

TEST_F(RenderCommand, WritesNothingWhereItFails)
{
    needDevice();
    if (IsSkipped())
        return;
    expectFailure({"render", model, "-o", folder / "absent/picture.png", "--size", "32x32"},
                  folder / "absent/picture.png");
    expectFailure({"render", model, "-o", picture, "--size", "32x32", "--stats", folder / "absent/s.json"},
                  folder / "absent/s.json");
    expectFailure({"render", model, "-o", picture, "--size", "32x32", "--device", "99"}, "99");
    EXPECT_TRUE(fs::is_empty(folder / "out"));
}

// What colours they have: tests/ui/friends_panel_test.cpp.
TEST_F(RenderCommand, DrawsFriendEdgesWhereAsked)
{
    needDevice();
    if (IsSkipped())
        return;
    const std::string bare = render({});
    EXPECT_NE(render({"--friends"}), bare);
    EXPECT_EQ(render({}), bare);
}
