#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "tests/app/run_program.h"
#include "tests/support.h"

using namespace knotspan;
using namespace knotspan::testing;
namespace fs = std::filesystem;

TEST(ConvertCommand, KnotspanToKnotspanIsTheSameFile)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runProgram({"sample", "extremes", "-o", folder / "a.knotspan"}).exitCode, 0);
    for (const bool verify : {false, true}) {
        std::vector<std::string> call{"convert", folder / "a.knotspan", folder / "b.knotspan"};
        if (verify)
            call.emplace_back("--verify");
        const ProgramRun run = runProgram(call);
        EXPECT_EQ(run.exitCode, 0) << run.messages;
        EXPECT_EQ(run.output + run.messages, "");
        EXPECT_EQ(readFile(folder / "a.knotspan"), readFile(folder / "b.knotspan"));
        fs::remove(folder / "b.knotspan");
    }
}

TEST(ConvertCommand, StepBecomesAnEqualKnotspanFile)
{
    KNOTSPAN_NEED_MODELS(models);
    const TemporaryFolder folder;
    const ProgramRun run =
        runProgram({"convert", *models / "screw.step", folder / "screw.knotspan", "--verify"});
    ASSERT_EQ(run.exitCode, 0) << run.messages;
    EXPECT_EQ(*formats::read(folder / "screw.knotspan"), *formats::read(*models / "screw.step"));
}

TEST(ConvertCommand, ManyFilesGoIntoAFolder)
{
    const TemporaryFolder folder;
    for (const char* name : {"sphere", "torus"})
        ASSERT_EQ(runProgram({"sample", name, "-o", folder / (std::string(name) + ".knotspan")}).exitCode, 0);
    fs::create_directory(folder / "out");
    const std::vector<std::string> call{
        "convert",     folder / "sphere.knotspan", folder / "torus.knotspan", "--to", "knotspan", "-d",
        folder / "out"};
    EXPECT_EQ(runProgram(call).exitCode, 0);
    EXPECT_TRUE(fs::exists(folder / "out" / "sphere.knotspan"));
    EXPECT_TRUE(fs::exists(folder / "out" / "torus.knotspan"));
}

TEST(ConvertCommand, WritesNothingWhereItFails)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runProgram({"sample", "sphere", "-o", folder / "a.knotspan"}).exitCode, 0);
    fs::create_directory(folder / "out");
    const std::string a = folder / "a.knotspan";
    const std::string out = folder / "out";
    expectWrongCall({"convert", a});
    expectWrongCall({"convert", a, out + "/b.banana"});
    expectWrongCall({"convert", a, out + "/b.step"});
    expectWrongCall({"convert", a, "--to", "knotspan"});
    expectWrongCall({"convert", a, "-d", out});
    expectWrongCall({"convert", a, a, "--to", "knotspan", "-d", out});
    expectWrongCall({"convert", a, out + "/b.knotspan", "--deviation", "0"});
    expectWrongCall({"convert", a, out + "/b.knotspan", "--angle", "nan"});
    expectFailure({"convert", folder / "absent.step", out + "/b.knotspan"}, folder / "absent.step");
    expectFailure({"convert", a, out + "/absent/b.knotspan"}, out + "/absent");
    expectFailure({"convert", a, out + "/absent/b.knotspan", "--verify"}, out + "/absent");
    expectFailure({"convert", a, "--to", "knotspan", "-d", folder / "absent"}, folder / "absent");
    EXPECT_TRUE(fs::is_empty(out));
}
