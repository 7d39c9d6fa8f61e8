#include "source_tree.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "tests/support.h"

namespace knotspan::architecture {

namespace {

bool endsIn(const std::string& file, const std::vector<std::string>& extensions)
{
    const std::string extension = std::filesystem::path(file).extension().string();
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

// The words of a path: model/scene/control_point.h has model, scene, control, point, h.
std::vector<std::string> wordsOf(const std::string& path)
{
    std::vector<std::string> words(1);
    for (const char c : path) {
        if (c == '/' || c == '_' || c == '.') {
            words.emplace_back();
        } else {
            words.back() += c;
        }
    }
    return words;
}

}  // namespace

const std::vector<std::string>& topFolders()
{
    static const std::vector<std::string> kFolders{"app",     "ui",    "renderer",  "model",
                                                   "shaders", "tests", "benchmarks"};
    return kFolders;
}

std::vector<std::string> sourceFiles()
{
    const std::filesystem::path root = KNOTSPAN_SOURCE_DIR;
    std::vector<std::string> files;
    for (const std::string& top : topFolders()) {
        if (!std::filesystem::is_directory(root / top)) {
            continue;
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / top)) {
            if (entry.is_regular_file()) {
                files.push_back(entry.path().lexically_relative(root).generic_string());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string contentOf(const std::string& file)
{
    return testing::readFile(std::filesystem::path(KNOTSPAN_SOURCE_DIR) / file);
}

bool isCpp(const std::string& file)
{
    return endsIn(file, {".cpp", ".h"});
}

bool isShader(const std::string& file)
{
    return endsIn(file, {".glsl", ".vert", ".frag", ".tesc", ".tese", ".geom", ".task", ".mesh", ".comp"});
}

std::string namingFault(const std::string& path)
{
    if (std::filesystem::path(path).filename() == "CMakeLists.txt") {
        return {};
    }
    const auto isPlain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '/';
    };
    if (!std::all_of(path.begin(), path.end(), isPlain)) {
        return path + ": names are lower case words joined by underscores";
    }
    constexpr std::array kEmptyWords{"util",    "utils",    "helper", "helpers",
                                     "manager", "managers", "common", "misc"};
    for (const std::string& word : wordsOf(path)) {
        if (std::find(kEmptyWords.begin(), kEmptyWords.end(), word) != kEmptyWords.end()) {
            return path + ": '" + word + "' says nothing of what is in it; name the idea";
        }
    }
    return {};
}

std::string depthFault(const std::string& path)
{
    const auto depth = std::count(path.begin(), path.end(), '/');
    const auto allowed = path.rfind("tests/", 0) == 0 ? 3 : 2;
    return depth <= allowed ? std::string() : path + ": lies too deep, folders go two deep";
}

}  // namespace knotspan::architecture
