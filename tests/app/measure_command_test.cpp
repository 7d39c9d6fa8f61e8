// No test asks how fast anything is: machines that run tests are busy.
#include <cstdlib>
#include <memory>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/renderer.h"
#include "tests/app/run_program.h"
#include "tests/app/svg_file.h"
#include "tests/support.h"

using namespace knotspan;
using namespace knotspan::testing;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr double kMostUnits = 16;

// One measurement of a sample with few points, for several tests.
class MeasureCommand : public ::testing::Test {
protected:
    static void SetUpTestSuite()
    {
        folder = std::make_unique<TemporaryFolder>();
        model = *folder / "nine & 16.knotspan";
        plot = *folder / "plot.svg";
        ASSERT_EQ(runProgram({"sample", "nine-16", "-o", model}).exitCode, 0);
        run = runProgram(
            {"measure", model, "--only", "evaluators", "--points", "500", "--json", "--plot", plot});
        ASSERT_EQ(run.exitCode, 0) << run.messages;
        json = Json::parse(run.output);
    }

    static void TearDownTestSuite() { folder.reset(); }

    // "stair double gpu"
    static std::string nameOf(const Json& row)
    {
        return row.at("evaluator").get<std::string>() + " " + row.at("precision").get<std::string>() + " " +
               row.at("processor").get<std::string>();
    }

    static std::set<std::string> namesOfAllRows()
    {
        std::set<std::string> names{"grid float cpu", "grid double cpu"};
        for (const EvaluatorInfo& info : evaluators())
            if (info.id != Evaluator::automatic)
                for (const char* rest : {" float cpu", " float gpu", " double cpu", " double gpu"})
                    names.insert(info.name + rest);
        return names;
    }

    static inline std::unique_ptr<TemporaryFolder> folder;
    static inline std::string model;
    static inline std::string plot;
    static inline ProgramRun run;
    static inline Json json;
};

}  // namespace

TEST_F(MeasureCommand, HasARowForEachEvaluatorInEachNumberTypeOnEachProcessor)
{
    EXPECT_EQ(run.messages, "");
    EXPECT_EQ(json.at("points"), 500);
    EXPECT_FALSE(json.at("simd").get<std::string>().empty());
    std::set<std::string> names;
    for (const Json& row : json.at("evaluators"))
        EXPECT_TRUE(names.insert(nameOf(row)).second) << nameOf(row);
    EXPECT_EQ(names, namesOfAllRows());
}

TEST_F(MeasureCommand, EveryRowHasFiguresOrTheReasonWhyNot)
{
    for (const Json& row : json.at("evaluators")) {
        if (row.contains("unavailable")) {
            EXPECT_FALSE(row.at("unavailable").get<std::string>().empty()) << nameOf(row);
            EXPECT_EQ(row.at("processor"), "gpu") << row.at("unavailable");
            continue;
        }
        EXPECT_GT(row.at("million_points_per_second"), 0) << nameOf(row);
        const double unit = row.at("precision") == "float" ? 0x1p-24 : 0x1p-53;
        const double error = row.at("error_max");
        EXPECT_GT(error, 0) << nameOf(row);
        EXPECT_LE(row.at("error_mean"), error) << nameOf(row);
        EXPECT_DOUBLE_EQ(row.at("error_max_units"), error / unit) << nameOf(row);
        // Of degree 3, with all weights alike.
        EXPECT_LE(row.at("error_max_units"), kMostUnits) << nameOf(row);
    }
}

TEST_F(MeasureCommand, MarksWhatAutoTakes)
{
    for (const Json& row : json.at("evaluators")) {
        const Precision precision = row.at("precision") == "float" ? Precision::float32 : Precision::float64;
        const std::string& chosen = evaluatorInfo(chosenEvaluator(Evaluator::automatic, 3, precision)).name;
        EXPECT_EQ(row.at("automatic"), row.at("evaluator") == chosen) << nameOf(row);
    }
}

TEST_F(MeasureCommand, MeasuresOnTheDeviceWhereThereIsOne)
{
    const auto renderer = Renderer::create();
    if (!renderer)
        GTEST_SKIP() << renderer.error().sentence();
    EXPECT_EQ(json.at("device"), (*renderer)->deviceName());
    for (const Json& row : json.at("evaluators"))
        if (row.at("precision") == "float" || (*renderer)->whyUnavailable(Precision::float64).empty()) {
            EXPECT_FALSE(row.contains("unavailable")) << nameOf(row) << row;
        }
}

TEST_F(MeasureCommand, DrawsAMarkerForEachMeasuredRow)
{
    const auto svg = readSvg(plot);
    ASSERT_TRUE(svg);
    EXPECT_NE(svg->text.find("nine & 16.knotspan"), std::string::npos) << svg->text;
    size_t measured = 0;
    for (const Json& row : json.at("evaluators"))
        measured += row.contains("unavailable") ? 0 : 1;
    EXPECT_EQ(svg->markers, measured);
}

TEST_F(MeasureCommand, WithoutADeviceMeasuresTheCpuWithTheSameErrors)
{
    // The loader's variable is one of these, by its age.
    ::setenv("VK_DRIVER_FILES", "/absent.json", 1);
    ::setenv("VK_ICD_FILENAMES", "/absent.json", 1);
    const ProgramRun bare =
        runProgram({"measure", model, "--only", "evaluators", "--points", "500", "--json"});
    const ProgramRun table = runProgram({"measure", model, "--only", "evaluators", "--points", "1"});
    expectFailure({"measure", model, "--points", "1", "--device", "0"}, "Vulkan");
    ::unsetenv("VK_DRIVER_FILES");
    ::unsetenv("VK_ICD_FILENAMES");
    ASSERT_EQ(bare.exitCode, 0) << bare.messages;
    const Json other = Json::parse(bare.output);
    EXPECT_TRUE(other.at("device").is_null());
    ASSERT_EQ(other.at("evaluators").size(), json.at("evaluators").size());
    for (size_t k = 0; k < json.at("evaluators").size(); ++k) {
        const Json& row = other.at("evaluators").at(k);
        EXPECT_EQ(nameOf(row), nameOf(json.at("evaluators").at(k)));
        if (row.at("processor") == "gpu")
            EXPECT_NE(row.at("unavailable").get<std::string>().find("Vulkan"), std::string::npos) << row;
        else
            EXPECT_EQ(row.at("error_max"), json.at("evaluators").at(k).at("error_max")) << nameOf(row);
    }
    EXPECT_EQ(table.exitCode, 0) << table.messages;
    for (const EvaluatorInfo& info : evaluators())
        if (info.id != Evaluator::automatic) {
            EXPECT_NE(table.output.find("\n" + info.name), std::string::npos) << table.output;
        }
    EXPECT_NE(table.output.find("not measured: "), std::string::npos) << table.output;
}

TEST_F(MeasureCommand, RefusesWhatCannotBeMeasuredOrWritten)
{
    const std::string good = readFile(model);
    Json hidden = Json::parse(good);
    for (Json& object : hidden.at("objects"))
        object["visible"] = false;
    writeFile(*folder / "hidden.knotspan", hidden.dump());
    expectFailure({"measure", *folder / "hidden.knotspan"}, "nothing to measure");
    expectFailure({"measure", model, "--plot", *folder / "absent/plot.svg"}, "absent/plot.svg");
    expectFailure({"measure", model, "--points", "1", "--device", "200"}, "200");
    for (const char* wrong : {"0", "-1", "0.5", "1e99", "nan", "many", ""})
        expectWrongCall({"measure", model, "--points", wrong});
    expectWrongCall({"measure"});
    expectWrongCall({"measure", model, "--plot", *folder / "plot.png"});
    expectWrongCall({"measure", model, "--plot", ""});
    fs::create_symlink(model, *folder / "link.svg");
    expectWrongCall({"measure", model, "--plot", *folder / "link.svg"});
    EXPECT_EQ(readFile(model), good);
}
