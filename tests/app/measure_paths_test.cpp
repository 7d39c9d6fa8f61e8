// `knotspan measure`, its part on paths. No test asks how fast anything is: machines that run tests are busy.
#include <map>

#include "renderer/renderer.h"
#include "tests/app/measure_fixture.h"
#include "tests/app/svg_file.h"

using namespace knotspan;
using namespace knotspan::testing;
using Json = nlohmann::json;

namespace {

constexpr int kTolerances = 2;

// In a small picture.
class MeasurePaths : public MeasureFixture<MeasurePaths> {
protected:
    static void SetUpTestSuite()
    {
        measure("torus", "torus.knotspan",
                {"--only", "paths", "--size", "96x64", "--frames", "1", "--tolerances", "0.5,4"});
    }

    static std::vector<Json> measuredRows() { return measuredOf(json.at("paths")); }

    // A quick run, with these besides.
    static ProgramRun runSmall(const std::string& file, std::vector<std::string> more)
    {
        more.insert(more.begin(), {"measure", file, "--only", "paths", "--size", "64x64", "--frames", "1",
                                   "--tolerances", "4", "--paths", "tessellation"});
        return runProgram(more);
    }

    static const PathInfo& pathOf(const Json& row)
    {
        return pathInfo(*findPath(row.at("path").get<std::string>()));
    }

    // "mesh none": a path in one motion.
    static std::string seriesOf(const Json& row)
    {
        return row.at("path").get<std::string>() + " " + row.at("deform").get<std::string>();
    }
};

}  // namespace

TEST_F(MeasurePaths, EachPathHasARowForEachToleranceItFollowsInEachMotion)
{
    EXPECT_EQ(run.messages, "");
    EXPECT_EQ(json.at("width"), 96);
    EXPECT_EQ(json.at("height"), 64);
    EXPECT_FALSE(json.contains("evaluators"));
    std::map<std::string, int> rows;
    for (const Json& row : json.at("paths"))
        ++rows[seriesOf(row)];
    for (const Json& row : measuredRows())
        EXPECT_EQ(row.at("tolerance_px").is_null(), !pathOf(row).followsTolerance) << row;
    for (const PathInfo& path : paths())
        for (const char* motion : {" none", " all"}) {
            const int count = rows[path.name + motion];
            EXPECT_TRUE(count == 1 || (path.followsTolerance && count == kTolerances)) << path.name << count;
        }
    EXPECT_EQ(rows.size(), 2 * paths().size());
}

TEST_F(MeasurePaths, EveryRowHasFiguresOrTheDevicesReasonWhyNot)
{
    const auto renderer = Renderer::create();
    for (const Json& row : json.at("paths"))
        if (row.contains("unavailable")) {
            const std::string why =
                renderer ? (*renderer)->whyUnavailable(pathOf(row).id) : renderer.error().sentence();
            EXPECT_EQ(row.at("unavailable"), why) << row;
        }
    for (const Json& row : measuredRows()) {
        EXPECT_GT(row.at("frame_ms").at("median"), 0) << row;
        EXPECT_GT(row.at("cpu_ms").at("median"), 0) << row;
        EXPECT_GT(row.at("triangles"), 0) << row;
        if (row.at("deform") == "all") {  // at rest a path may know its points already
            EXPECT_GT(row.at("evaluations"), 0) << row;
        }
        EXPECT_GE(row.at("error_px_mean"), 0) << row;
        EXPECT_GE(row.at("error_px_max"), row.at("error_px_mean")) << row;
        EXPECT_EQ(row.at("frames"), 1) << row;
        EXPECT_NE(row.at("evaluator"), "auto") << row;
    }
}

TEST_F(MeasurePaths, AFinerToleranceNeverTakesFewerTriangles)
{
    Json before;
    for (const Json& row : measuredRows()) {
        if (row.at("tolerance_px").is_null())
            continue;
        if (!before.is_null() && seriesOf(before) == seriesOf(row)) {
            EXPECT_LT(row.at("tolerance_px"), before.at("tolerance_px")) << row;
            EXPECT_GE(row.at("triangles"), before.at("triangles")) << row;
        }
        before = row;
    }
}

// The error shading compares at the drawn parameters, so that it is a float's rounding above the promise.
TEST_F(MeasurePaths, ErrorsAreWithinWhatTheRulePromises)
{
    constexpr double kRounding = 1e-3;
    for (const Json& row : measuredRows())
        if (!row.at("error_bound_px").is_null()) {
            EXPECT_LE(row.at("error_px_max").get<double>(),
                      row.at("error_bound_px").get<double>() * (1 + kRounding))
                << row;
        }
}

TEST_F(MeasurePaths, AMovedModelIsSentAgainInEachFrame)
{
    for (const Json& row : measuredRows())
        if (row.at("deform") == "all") {
            EXPECT_GT(row.at("upload_bytes_per_frame"), 0) << row;
        }
}

TEST_F(MeasurePaths, CountsLeaksOfClosedModelsOnly)
{
    for (const Json& row : measuredRows())
        EXPECT_TRUE(row.at("leak_pixels").is_number_unsigned()) << row;
    ASSERT_EQ(runProgram({"sample", "single-100", "-o", *folder / "sheet.knotspan"}).exitCode, 0);
    const ProgramRun sheet = runSmall(*folder / "sheet.knotspan", {"--deform", "point", "--json"});
    ASSERT_EQ(sheet.exitCode, 0) << sheet.messages;
    const Json rows = Json::parse(sheet.output).at("paths");
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].at("deform"), "point");
    if (!rows[0].contains("unavailable")) {
        EXPECT_TRUE(rows[0].at("leak_pixels").is_null());
    }
}

TEST_F(MeasurePaths, DrawsAMarkerForEachMeasuredRowAndACurveForEachPath)
{
    const auto svg = readSvg(plot);
    ASSERT_TRUE(svg);
    std::map<std::string, int> series;
    for (const Json& row : measuredRows())
        ++series[seriesOf(row)];
    size_t curves = 0;
    for (const auto& [name, rows] : series)
        curves += rows > 1 ? 1 : 0;
    EXPECT_EQ(svg->markers, measuredRows().size());
    EXPECT_EQ(svg->curves, curves);
    EXPECT_NE(svg->text.find("torus.knotspan"), std::string::npos) << svg->text;
    EXPECT_NE(svg->text.find("every control point moves"), std::string::npos) << svg->text;
}

TEST_F(MeasurePaths, TheTableNamesEveryPathAndTakesThoseThatAreAskedFor)
{
    const ProgramRun table = runSmall(model, {"--evaluators", "auto,triangular", "--deform", "none"});
    ASSERT_EQ(table.exitCode, 0) << table.messages;
    const size_t first = table.output.find("\ntessellation");
    ASSERT_NE(first, std::string::npos) << table.output;
    EXPECT_NE(table.output.find("\ntessellation", first + 1), std::string::npos) << table.output;
    EXPECT_NE(table.output.find(" triangular "), std::string::npos) << table.output;
    EXPECT_EQ(table.output.find("\nmesh"), std::string::npos) << table.output;
}

TEST_F(MeasurePaths, WithoutADeviceEachRowSaysWhy)
{
    const WithoutDevice none;
    const std::string empty = *folder / "empty.svg";
    const ProgramRun bare = runProgram({"measure", model, "--only", "paths", "--json", "--plot", empty});
    ASSERT_EQ(bare.exitCode, 0) << bare.messages;
    const Json rows = Json::parse(bare.output).at("paths");
    EXPECT_EQ(rows.size(), 2 * paths().size());
    for (const Json& row : rows)
        EXPECT_NE(row.at("unavailable").get<std::string>().find("Vulkan"), std::string::npos) << row;
    EXPECT_EQ(readSvg(empty)->markers, 0U);
}

TEST_F(MeasurePaths, RefusesWrongOptions)
{
    const auto wrong = [](const char* option, const char* value) {
        expectWrongCall({"measure", model, "--only", "paths", option, value});
    };
    for (const char* tolerances : {"0", "-1", "nan", "0.5,", "1;2", "1e9", "half", ""})
        wrong("--tolerances", tolerances);
    for (const char* list : {"best", "mesh,best", "tessellation,tessellation", ""})
        wrong("--paths", list);
    wrong("--evaluators", "fast");
    wrong("--deform", "some");
    wrong("--sampling", "fixed:0");
    wrong("--size", "640");
    wrong("--view", "inside");
    wrong("--frames", "0");
    wrong("--only", "nothing");
    expectFailure({"measure", *folder / "absent.knotspan", "--only", "paths"}, "absent.knotspan");
}

TEST_F(MeasurePaths, AFlightHasAFrameForEachView)
{
    const ProgramRun flown = runSmall(model, {"--flight", "3", "--deform", "none", "--json"});
    ASSERT_EQ(flown.exitCode, 0) << flown.messages;
    const Json report = Json::parse(flown.output);
    EXPECT_EQ(report.at("views"), 3);
    EXPECT_EQ(json.at("views"), 1);
    EXPECT_EQ(report.at("ksquads"), json.at("ksquads"));
    for (const Json& row : measuredOf(report.at("paths")))
        EXPECT_EQ(row.at("frames"), 3) << row;
}
