#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "tests/app/run_program.h"
#include "tests/support.h"

using namespace knotspan;
using namespace knotspan::testing;

TEST(Program, HelpAndVersionGoToStandardOutput)
{
    for (const std::vector<std::string>& call :
         std::vector<std::vector<std::string>>{{"--help"},
                                               {"--version"},
                                               {"render", "--help"},
                                               {"convert", "--help"},
                                               {"info", "--help"},
                                               {"sample", "--help"},
                                               {"evaluate", "--help"},
                                               {"measure", "--help"}}) {
        const ProgramRun run = runProgram(call);
        EXPECT_EQ(run.exitCode, 0);
        EXPECT_NE(run.output, "");
        EXPECT_EQ(run.messages, "");
    }
}

TEST(Program, AnUnknownOptionOrCommandIsAWrongCall)
{
    expectWrongCall({"--nonsense"});
    expectWrongCall({"nonsense"});
    expectWrongCall({"info", "model.knotspan", "--nonsense"});
    expectWrongCall({"info"});
    expectWrongCall({"info", "a.knotspan", "b.knotspan"});
    expectWrongCall({"info", "a.knotspan", "sample"});
}

TEST(Program, AWindowWithoutADisplayFailsWithASentence)
{
    expectFailure({}, "display");
}

TEST(SampleCommand, ListsEverySample)
{
    const ProgramRun run = runProgram({"sample"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.messages, "");
    for (const Sample& sample : samples())
        EXPECT_NE(run.output.find(sample.name + "\t" + sample.description + "\n"), std::string::npos);
}

TEST(SampleCommand, WritesASample)
{
    const TemporaryFolder folder;
    const ProgramRun run = runProgram({"sample", "torus", "-o", folder / "torus.knotspan"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.output + run.messages, "");
    const auto scene = formats::read(folder / "torus.knotspan");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(*scene, findSample("torus")->make());
}

TEST(SampleCommand, RefusesWrongCallsAndPlaces)
{
    const TemporaryFolder folder;
    expectWrongCall({"sample", "torus"});
    expectWrongCall({"sample", "-o", folder / "a.knotspan"});
    expectWrongCall({"sample", "banana", "-o", folder / "a.knotspan"});
    expectFailure({"sample", "torus", "-o", folder / "absent/a.knotspan"}, folder / "absent");
    expectWrongCall({"sample", "torus", "-o", folder / "a.banana"});
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}
