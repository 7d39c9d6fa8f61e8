// What the tests of `knotspan measure` share.
#pragma once

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/support.h"

namespace knotspan::testing {

// One measurement of a sample, for all tests of the fixture `Derived`: its SetUpTestSuite calls measure().
template <class Derived>
class MeasureFixture : public ::testing::Test {
protected:
    static void measure(const std::string& sample, const std::string& file,
                        std::vector<std::string> arguments)
    {
        folder = std::make_unique<TemporaryFolder>();
        model = *folder / file;
        plot = *folder / "plot.svg";
        ASSERT_EQ(runProgram({"sample", sample, "-o", model}).exitCode, 0);
        arguments.insert(arguments.begin(), {"measure", model, "--json", "--plot", plot});
        run = runProgram(arguments);
        ASSERT_EQ(run.exitCode, 0) << run.messages;
        json = nlohmann::json::parse(run.output);
    }

    static void TearDownTestSuite() { folder.reset(); }

    static inline std::unique_ptr<TemporaryFolder> folder;
    static inline std::string model;
    static inline std::string plot;
    static inline ProgramRun run;
    static inline nlohmann::json json;
};

// Those that could be measured.
inline std::vector<nlohmann::json> measuredOf(const nlohmann::json& rows)
{
    std::vector<nlohmann::json> measured;
    for (const nlohmann::json& row : rows)
        if (!row.contains("unavailable"))
            measured.push_back(row);
    return measured;
}

// No Vulkan device for the programs that are run, as long as it lives.
class WithoutDevice {
public:
    WithoutDevice()
    {
        for (const char* name : kNames)
            ::setenv(name, "/absent.json", 1);
    }
    ~WithoutDevice()
    {
        for (const char* name : kNames)
            ::unsetenv(name);
    }
    WithoutDevice(const WithoutDevice&) = delete;
    WithoutDevice& operator=(const WithoutDevice&) = delete;

private:
    // The loader's variable is one of these, by its age.
    static constexpr const char* kNames[] = {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"};
};

}  // namespace knotspan::testing
