#include "include_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <string_view>

namespace knotspan::architecture {

namespace {

using Folders = std::vector<std::string>;

Folders operator+(Folders left, const Folders& right)
{
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

bool startsWith(std::string_view text, std::string_view beginning)
{
    return text.substr(0, beginning.size()) == beginning;
}

bool endsWith(std::string_view text, std::string_view end)
{
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

// "model" covers "model/core/result.h", not "modeling.h"; a header covers itself.
bool covers(const std::string& allowed, const std::string& included)
{
    return included == allowed || startsWith(included, allowed + "/");
}

std::string folderOf(const std::string& file)
{
    const auto slash = file.rfind('/');
    return slash == std::string::npos ? std::string() : file.substr(0, slash);
}

std::string stemOf(const std::string& file)
{
    const auto name = file.substr(file.rfind('/') + 1);
    return name.substr(0, name.find('.'));
}

// Every path is a file of its own that sees the interface and no other path.
bool isPathFile(const std::string& file)
{
    return folderOf(file) == "renderer/paths" && endsWith(stemOf(file), "_path") &&
           stemOf(file) != "surface_path";
}

bool isQt(std::string_view included)
{
    return included.size() > 1 && included[0] == 'Q' &&
           (std::isupper(static_cast<unsigned char>(included[1])) != 0 || startsWith(included, "Qt"));
}

bool isVulkan(std::string_view included)
{
    return startsWith(included, "vulkan/") || startsWith(included, "vk_");
}

bool isOpenCascade(std::string_view included)
{
    return endsWith(included, ".hxx");
}

bool isMeshLibrary(std::string_view included)
{
    return startsWith(included, "OpenMesh/") || startsWith(included, "vtk");
}

bool namesDisk(std::string_view included)
{
    constexpr std::array kHeaders{"filesystem", "QFileInfo", "QDir", "QStandardPaths"};
    return std::find(kHeaders.begin(), kHeaders.end(), included) != kHeaders.end();
}

bool opensDisk(std::string_view included)
{
    constexpr std::array kHeaders{"fstream",    "unistd.h", "fcntl.h",        "sys/stat.h",
                                  "sys/mman.h", "QFile",    "QTemporaryFile", "QSaveFile"};
    return std::find(kHeaders.begin(), kHeaders.end(), included) != kHeaders.end();
}

// Nothing where the rule lets the library in, otherwise why it does not.
std::string libraryRefusal(const FolderRule& rule, const std::string& included)
{
    if (isQt(included) && !rule.qt) {
        return "sees no Qt";
    }
    if (isVulkan(included) && !rule.vulkan) {
        return "sees no Vulkan";
    }
    if (isOpenCascade(included) && !rule.openCascade) {
        return "sees no OpenCASCADE";
    }
    if (isMeshLibrary(included) && !rule.meshLibraries) {
        return "sees neither OpenMesh nor VTK";
    }
    if (opensDisk(included) && rule.disk != Disk::yes) {
        return "opens no files";
    }
    if (namesDisk(included) && rule.disk == Disk::no) {
        return "knows of no files";
    }
    if (startsWith(included, "CLI/") && rule.folder != "app" && !covers("benchmarks", rule.folder)) {
        return "reads no command line";
    }
    if (startsWith(included, "hwy/") && rule.folder != "model/geometry" &&
        !covers("benchmarks", rule.folder)) {
        return "leaves SIMD to model/geometry";
    }
    if (startsWith(included, "gtest/")) {
        return "is no test";
    }
    return {};
}

bool isOurs(const std::string& included)
{
    constexpr std::array kTops{"app/", "ui/", "renderer/", "model/", "shaders/", "tests/", "benchmarks/"};
    return std::any_of(kTops.begin(), kTops.end(),
                       [&](const char* top) { return startsWith(included, top); });
}

// The path from the root of the tree. Quoted ones are that already, but for the shaders: glslc knows no root,
// so theirs start at their own folder.
std::string pathOf(const std::string& file, const Include& include)
{
    if (!include.quoted || !startsWith(file, "shaders/") || isOurs(include.name)) {
        return include.name;
    }
    return (std::filesystem::path(folderOf(file)) / include.name).lexically_normal().generic_string();
}

std::string refusal(const FolderRule& rule, const std::string& file, const Include& include)
{
    const std::string included = pathOf(file, include);
    if (!isOurs(included)) {
        return include.quoted && !endsWith(included, ".moc") ? "quotes paths from the root of the tree"
                                                             : libraryRefusal(rule, included);
    }
    if (isPathFile(file) && isPathFile(included) && stemOf(file) != stemOf(included)) {
        return "has paths that know nothing of each other";
    }
    const bool allowed = folderOf(included) == rule.folder ||
                         std::any_of(rule.mayInclude.begin(), rule.mayInclude.end(),
                                     [&](const std::string& folder) { return covers(folder, included); });
    return allowed ? std::string() : "may not see that folder";
}

std::vector<FolderRule> makeRules()
{
    const Folders geometry{"model/core", "shaders/shared"};
    const Folders values = geometry + Folders{"model/geometry"};
    const Folders scene = values + Folders{"model/analysis", "model/friends", "model/scene"};
    const Folders drawing = scene + Folders{"model/trimming",
                                            "renderer/vulkan",
                                            "renderer/scene",
                                            "renderer/frame.h",
                                            "renderer/culling/cull_modes.h",
                                            "renderer/paths/path_list.h"};
    const Folders window{"model",
                         "renderer/renderer.h",
                         "renderer/swapchain.h",
                         "renderer/frame.h",
                         "renderer/stats",
                         "renderer/culling/cull_modes.h",
                         "renderer/paths/path_list.h",
                         "renderer/scene/camera.h",
                         "renderer/scene/framed_points.h",
                         "renderer/scene/look.h",
                         "renderer/scene/render_lists.h",
                         "renderer/measurement"};
    const Folders front{"renderer/renderer.h",
                        "renderer/frame.h",
                        "renderer/leak_count.h",
                        "renderer/stats",
                        "renderer/scene/framed_points.h",
                        "renderer/paths/path_list.h"};
    const Folders viewing = window + Folders{"ui/tools"};
    const Folders panels = viewing + Folders{"ui/viewport"};
    return {
        {.folder = "model/core", .mayInclude = {}},
        {.folder = "model/geometry", .mayInclude = geometry},
        {.folder = "model/analysis", .mayInclude = values + Folders{"model/trimming"}},
        {.folder = "model/trimming", .mayInclude = values},
        {.folder = "model/matching", .mayInclude = scene},
        {.folder = "model/making", .mayInclude = values + Folders{"model/scene"}},
        {.folder = "model/refining", .mayInclude = values + Folders{"model/scene", "model/trimming"}},
        {.folder = "model/friends", .mayInclude = values + Folders{"model/analysis", "model/scene"}},
        {.folder = "model/scene", .mayInclude = values},
        {.folder = "model/sculpting", .mayInclude = values + Folders{"model/scene"}},
        {.folder = "model/samples", .mayInclude = values + Folders{"model/scene"}},
        {.folder = "model/mesh", .mayInclude = scene + Folders{"model/trimming"}},
        {.folder = "model/files", .mayInclude = scene, .disk = Disk::yes},
        {.folder = "model/cad",
         .mayInclude = scene + Folders{"model/files"},
         .disk = Disk::yes,
         .openCascade = true},
        {.folder = "model/mesh_files",
         .mayInclude = scene + Folders{"model/files"},
         .disk = Disk::yes,
         .meshLibraries = true},
        {.folder = "model/formats",
         .mayInclude =
             scene + Folders{"model/cad", "model/files", "model/mesh", "model/mesh_files", "model/trimming"},
         .disk = Disk::yes},
        {.folder = "model/document",
         .mayInclude = scene + Folders{"model/files", "model/formats", "model/mesh"},
         .disk = Disk::names,
         .qt = true},
        {.folder = "renderer/vulkan", .mayInclude = scene + Folders{"shaders/spirv.h"}, .vulkan = true},
        {.folder = "renderer/scene",
         .mayInclude = scene + Folders{"model/trimming", "renderer/vulkan", "shaders/culling"},
         .vulkan = true},
        {.folder = "renderer/culling", .mayInclude = drawing, .vulkan = true},
        {.folder = "renderer/sampling", .mayInclude = drawing, .vulkan = true},
        {.folder = "renderer/paths", .mayInclude = drawing, .vulkan = true},
        {.folder = "renderer/overlays", .mayInclude = drawing, .vulkan = true},
        {.folder = "renderer/stats", .mayInclude = drawing, .vulkan = true},
        {.folder = "renderer", .mayInclude = scene + Folders{"renderer"}, .vulkan = true},
        // Above the renderer: it draws as any program would.
        {.folder = "renderer/measurement", .mayInclude = scene + front},
        {.folder = "ui/plots", .mayInclude = window, .disk = Disk::names, .qt = true},
        {.folder = "ui/tools", .mayInclude = window, .disk = Disk::names, .qt = true},
        // It makes the window's surface.
        {.folder = "ui/viewport", .mayInclude = viewing, .disk = Disk::names, .qt = true, .vulkan = true},
        {.folder = "ui/panels", .mayInclude = panels, .disk = Disk::names, .qt = true},
        {.folder = "ui", .mayInclude = panels + Folders{"ui"}, .disk = Disk::names, .qt = true},
        {.folder = "app",
         .mayInclude = {"app", "ui", "renderer", "model", "shaders/shared"},
         .disk = Disk::yes,
         .qt = true},
        {.folder = "benchmarks/deforming", .mayInclude = scene + Folders{"model/samples", "renderer/scene"}},
        {.folder = "benchmarks/friends", .mayInclude = scene + Folders{"model/samples"}},
        // The peers that it measures beside ours.
        {.folder = "benchmarks/evaluation",
         .mayInclude = values + Folders{"benchmarks/evaluation"},
         .openCascade = true},
        {.folder = "benchmarks/meshing",
         .mayInclude = scene + Folders{"model/mesh", "model/samples", "benchmarks/evaluation"},
         .openCascade = true},
        // Above the renderer, by its front; a program of its own.
        {.folder = "benchmarks/frames",
         .mayInclude = scene + front + Folders{"benchmarks/frames", "model/samples"}},
        {.folder = "benchmarks/dragging",
         .mayInclude = scene + front + Folders{"benchmarks/dragging", "model/samples", "model/sculpting"}},
        {.folder = "benchmarks/trimming", .mayInclude = scene + front + Folders{"model/formats"}},
        // The window itself.
        {.folder = "benchmarks/starting", .mayInclude = {"model", "ui"}, .disk = Disk::yes, .qt = true},
        {.folder = "shaders", .mayInclude = {}},
        {.folder = "shaders/shared", .mayInclude = {}},
        {.folder = "shaders/surface", .mayInclude = {"shaders/shared", "shaders/culling"}},
        {.folder = "shaders/culling", .mayInclude = {"shaders/shared"}},
        {.folder = "shaders/sampling", .mayInclude = {"shaders/shared"}},
        {.folder = "shaders/deformation", .mayInclude = {"shaders/shared"}},
        {.folder = "shaders/overlay", .mayInclude = {"shaders/shared"}},
    };
}

}  // namespace

const std::vector<FolderRule>& folderRules()
{
    static const std::vector<FolderRule> kRules = makeRules();
    return kRules;
}

const FolderRule* ruleFor(const std::string& file)
{
    const auto& rules = folderRules();
    const auto found = std::find_if(rules.begin(), rules.end(),
                                    [&](const FolderRule& rule) { return rule.folder == folderOf(file); });
    return found == rules.end() ? nullptr : &*found;
}

std::vector<Include> includesOf(const std::string& content)
{
    std::vector<Include> found;
    std::istringstream lines(content);
    for (std::string line; std::getline(lines, line);) {
        std::string_view rest = line;
        const auto skip = [&rest] {
            rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
        };
        skip();
        if (!startsWith(rest, "#")) {
            continue;
        }
        rest.remove_prefix(1);
        skip();
        if (!startsWith(rest, "include")) {
            continue;
        }
        rest.remove_prefix(std::string_view("include").size());
        skip();
        const auto end = rest.empty() ? std::string_view::npos : rest.find(rest[0] == '<' ? '>' : '"', 1);
        if (end != std::string_view::npos) {
            found.push_back({std::string(rest.substr(1, end - 1)), rest[0] == '"'});
        }
    }
    return found;
}

std::vector<std::string> forbiddenIncludes(const std::string& file, const std::string& content)
{
    const FolderRule* rule = ruleFor(file);
    if (rule == nullptr) {
        return {file + ": its folder has no line in the table (tests/architecture/include_rules.cpp)"};
    }
    std::vector<std::string> sentences;
    for (const Include& include : includesOf(content)) {
        const std::string why = refusal(*rule, file, include);
        if (!why.empty()) {
            sentences.push_back(file + " includes " + include.name + ", but " + rule->folder + " " + why);
        }
    }
    return sentences;
}

}  // namespace knotspan::architecture
