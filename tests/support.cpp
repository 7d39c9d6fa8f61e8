#include "tests/support.h"

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <unistd.h>

namespace knotspan::testing {
namespace fs = std::filesystem;

namespace {

std::optional<fs::path> sharedFolder(const char* name)
{
    if (const char* models = std::getenv("KNOTSPAN_MODELS")) {
        const fs::path folder = fs::path(models).lexically_normal().parent_path() / name;
        return fs::is_directory(folder) ? std::optional(folder) : std::nullopt;
    }
    const fs::path folder = fs::path(KNOTSPAN_SOURCE_DIR).parent_path() / "shared" / name;
    return fs::is_directory(folder) ? std::optional(folder) : std::nullopt;
}

}  // namespace

std::optional<fs::path> modelsFolder()
{
    if (const char* models = std::getenv("KNOTSPAN_MODELS"))
        return fs::is_directory(models) ? std::optional<fs::path>(models) : std::nullopt;
    return sharedFolder("models");
}

std::optional<fs::path> oraclesFolder()
{
    return sharedFolder("oracles");
}

TemporaryFolder::TemporaryFolder()
{
    static std::atomic<int> count = 0;
    path_ = fs::temp_directory_path() /
            ("knotspan-test-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string readFile(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void writeFile(const fs::path& path, const std::string& content)
{
    std::ofstream(path, std::ios::binary) << content;
}

}  // namespace knotspan::testing
