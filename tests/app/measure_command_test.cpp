// No test asks how fast anything is: machines that run tests are busy.
#include <set>

#include "renderer/renderer.h"
#include "tests/app/measure_fixture.h"
#include "tests/app/svg_file.h"

using namespace knotspan;
using namespace knotspan::testing;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr double kMostUnits = 16;

// Of a sample with few points.
class MeasureCommand : public MeasureFixture<MeasureCommand> {
protected:
    static void SetUpTestSuite()
    {
        measure("nine-16", "nine & 16.knotspan", {"--only", "evaluators", "--points", "500"});
    }

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
    EXPECT_EQ(svg->markers, measuredOf(json.at("evaluators")).size());
}

TEST_F(MeasureCommand, WithoutADeviceMeasuresTheCpuWithTheSameErrors)
{
    ProgramRun bare;
    ProgramRun table;
    {
        const WithoutDevice none;
        bare = runProgram({"measure", model, "--only", "evaluators", "--points", "500", "--json"});
        table = runProgram({"measure", model, "--only", "evaluators", "--points", "1"});
        expectFailure({"measure", model, "--points", "1", "--device", "0"}, "Vulkan");
    }
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
    expectFailure({"measure", *folder / "hidden.knotspan"}, "no surface to measure");
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
