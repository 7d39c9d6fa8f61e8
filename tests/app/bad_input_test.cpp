// What no model is, through the program: one sentence, exit code 1, nothing written.
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/support.h"

using namespace knotspan::testing;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

class BadInput : public ::testing::Test {
protected:
    void SetUp() override
    {
        ASSERT_EQ(runProgram({"sample", "sphere", "-o", folder / "good.knotspan"}).exitCode, 0);
        good = readFile(folder / "good.knotspan");
        fs::create_directory(folder / "out");
    }

    // Every command that reads a model refuses it.
    void expectRefused(const fs::path& path)
    {
        const std::string out = folder / "out";
        expectFailure({"info", path}, path.string());
        expectFailure({"analyze", path}, path.string());
        expectFailure({"convert", path, out + "/out.knotspan"}, path.string());
        expectFailure({"evaluate", path, "--surface", "0", "--at", "0,0"}, path.string());
        expectFailure({"render", path, "-o", out + "/out.png", "--stats", out + "/out.json"}, path.string());
        expectFailure({"measure", path, "--plot", out + "/out.svg"}, path.string());
        EXPECT_TRUE(fs::is_empty(out));
    }

    void expectRefusedText(const std::string& text, const std::string& name = "bad.knotspan")
    {
        SCOPED_TRACE(text.substr(0, 200));
        writeFile(folder / name, text);
        expectRefused(folder / name);
    }

    // The good file with one change.
    template <class Change>
    void expectRefusedAfter(const Change& change)
    {
        Json json = Json::parse(good);
        change(json);
        expectRefusedText(json.dump());
    }

    static Json& surfaceOf(Json& json) { return json.at("objects").at(0).at("surface"); }

    TemporaryFolder folder;
    std::string good;
};

}  // namespace

TEST_F(BadInput, AnEmptyFile)
{
    expectRefusedText("");
    expectRefusedText("", "bad.step");
}

TEST_F(BadInput, ATruncatedFile)
{
    for (size_t k = 1; k < 8; ++k)
        expectRefusedText(good.substr(0, good.size() * k / 8));
}

TEST_F(BadInput, NoModelAtAll)
{
    expectRefusedText("[1, 2, 3]");
    expectRefusedText("null");
    expectRefusedText(std::string(100000, '['));
    expectRefusedText(std::string("\0\1\2\3\xff\xfe", 6));
    expectRefusedText("solid nothing", "bad.step");
    expectRefusedText(good, "bad.banana");
    expectRefusedText(good, "bad");
}

TEST_F(BadInput, TheWrongVersion)
{
    expectRefusedAfter([](Json& json) { json.at("version") = 2; });
    expectRefusedAfter([](Json& json) { json.erase("version"); });
    expectRefusedAfter([](Json& json) { json.at("format") = "banana"; });
}

TEST_F(BadInput, NumbersThatAreNone)
{
    expectRefusedAfter([](Json& json) { surfaceOf(json).at("control_points").at(0).at(1) = nullptr; });
    std::string text = good;
    const size_t number = text.find('[', text.find("\"control_points\"")) + 2;
    expectRefusedText(text.substr(0, number) + "NaN" + text.substr(text.find(',', number)));
    expectRefusedText(text.substr(0, number) + "1e999" + text.substr(text.find(',', number)));
}

TEST_F(BadInput, DecreasingKnots)
{
    expectRefusedAfter([](Json& json) { surfaceOf(json).at("knots_u").at(0) = 1e6; });
}

TEST_F(BadInput, AZeroWeight)
{
    expectRefusedAfter([](Json& json) { surfaceOf(json).at("control_points").at(2).at(3) = 0.0; });
    expectRefusedAfter([](Json& json) { surfaceOf(json).at("control_points").at(2).at(3) = -1.0; });
}

TEST_F(BadInput, TooFewControlPointsOrAnImpossibleDegree)
{
    expectRefusedAfter([](Json& json) { surfaceOf(json).at("control_points").erase(0); });
    for (const long long degree : {-1LL, 0LL, 16LL, 1000000000LL, 1000000000000000000LL})
        expectRefusedAfter([&](Json& json) { surfaceOf(json).at("degree_u") = degree; });
}

TEST_F(BadInput, AFolderOrAMissingFile)
{
    fs::create_directory(folder / "folder.knotspan");
    fs::create_directory(folder / "folder.step");
    expectRefused(folder / "folder.knotspan");
    expectRefused(folder / "folder.step");
    expectRefused(folder / "absent.knotspan");
}

TEST_F(BadInput, AnUnreadableFile)
{
    if (::geteuid() == 0)
        GTEST_SKIP() << "root may read everything: run this test as an ordinary user";
    writeFile(folder / "secret.knotspan", good);
    fs::permissions(folder / "secret.knotspan", fs::perms::none);
    expectRefused(folder / "secret.knotspan");
}

TEST_F(BadInput, TenGigabytesThatAreNotThere)
{
    const fs::path path = folder / "hollow.knotspan";
    writeFile(path, good);
    fs::resize_file(path, 10'000'000'000);
    expectRefused(path);
    fs::copy_file(folder / "good.knotspan", folder / "hollow.step");
    fs::resize_file(folder / "hollow.step", 10'000'000'000);
    expectRefused(folder / "hollow.step");
}
