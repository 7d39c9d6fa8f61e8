// What desktops are told of the program: valid to their own tools, and true.
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "tests/resources/shell.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;
namespace fs = std::filesystem;

fs::path desktopFile(const std::string& name)
{
    return fs::path(KNOTSPAN_SOURCE_DIR) / "resources/desktop" / name;
}

// The value of "KEY=VALUE".
std::string valueIn(const std::string& file, const std::string& key)
{
    std::istringstream lines(readFile(desktopFile(file)));
    for (std::string line; std::getline(lines, line);)
        if (line.rfind(key + "=", 0) == 0)
            return line.substr(key.size() + 1);
    return {};
}

std::set<std::string> typesIn(const std::string& file)
{
    std::set<std::string> types;
    std::istringstream list(valueIn(file, "MimeType"));
    for (std::string type; std::getline(list, type, ';');)
        types.insert(type);
    return types;
}

// What is between `before` and the next quotation mark, each time.
std::vector<std::pair<size_t, std::string>> quotedAfter(const std::string& text, const std::string& before)
{
    std::vector<std::pair<size_t, std::string>> found;
    for (size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
        const size_t start = at + before.size();
        found.emplace_back(at, text.substr(start, text.find('"', start) - start));
    }
    return found;
}

// By extension: of our file, and those that every desktop knows.
std::map<std::string, std::string> typesByExtension()
{
    std::map<std::string, std::string> types = {{"igs", "model/iges"},        {"iges", "model/iges"},
                                                {"obj", "model/obj"},         {"stl", "model/stl"},
                                                {"glb", "model/gltf-binary"}, {"gltf", "model/gltf+json"}};
    const std::string text = readFile(desktopFile("knotspan.xml"));
    const auto declared = quotedAfter(text, "<mime-type type=\"");
    for (const auto& [at, pattern] : quotedAfter(text, "<glob pattern=\"*."))
        for (const auto& [start, type] : declared)
            if (start < at)
                types[pattern] = type;
    return types;
}

TEST(DesktopFiles, TheEntryIsValid)
{
    KNOTSPAN_NEED_TOOL("desktop-file-validate", "desktop-file-utils");
    const ShellRun run = shell("desktop-file-validate " + desktopFile("knotspan.desktop").string());
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_EQ(run.output, "");
}

TEST(DesktopFiles, AppStreamDataIsValid)
{
    KNOTSPAN_NEED_TOOL("appstreamcli", "appstream");
    const ShellRun run =
        shell("appstreamcli validate --no-net " + desktopFile("org.knotspan.Knotspan.metainfo.xml").string());
    EXPECT_EQ(run.exitCode, 0) << run.output;
}

TEST(DesktopFiles, MimeTypesAreTakenByTheDatabase)
{
    KNOTSPAN_NEED_TOOL("update-mime-database", "shared-mime-info");
    const TemporaryFolder folder;
    fs::create_directories(folder / "packages");
    fs::copy_file(desktopFile("knotspan.xml"), folder / "packages/knotspan.xml");
    const ShellRun run =
        shell("XDG_DATA_DIRS=" + folder.path().string() + " update-mime-database " + folder.path().string());
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_TRUE(fs::exists(folder / "application/x-knotspan.xml")) << run.output;
    const std::string globs = readFile(folder / "globs2");
    for (const char* const line : {"50:application/x-knotspan:*.knotspan\n", "50:model/step:*.stp\n"})
        EXPECT_NE(globs.find(line), std::string::npos) << globs;
}

TEST(DesktopFiles, EveryModelThatIsReadHasATypeThatTheProgramOpens)
{
    const auto types = typesByExtension();
    const auto opened = typesIn("knotspan.desktop");
    const auto drawn = typesIn("knotspan.thumbnailer");
    EXPECT_TRUE(opened.count("application/x-knotspan"));
    for (const formats::Format& format : formats::all())
        for (const std::string& extension : format.extensions) {
            if (format.read == nullptr)
                continue;
            ASSERT_TRUE(types.count(extension))
                << extension << " has no type in resources/desktop/knotspan.xml";
            EXPECT_TRUE(opened.count(types.at(extension)))
                << "knotspan.desktop lacks " << types.at(extension);
        }
    for (const std::string& type : drawn)
        EXPECT_TRUE(opened.count(type)) << type;
}

TEST(DesktopFiles, FilesOfOursAreToldByTheirBeginning)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(formats::write(Scene(), folder / "a.knotspan"));
    EXPECT_EQ(readFile(folder / "a.knotspan").rfind("{\"format\": \"knotspan\"", 0), 0U);
    EXPECT_NE(
        readFile(desktopFile("knotspan.xml")).find("value=\"{&quot;format&quot;: &quot;knotspan&quot;\""),
        std::string::npos);
}

}  // namespace
}  // namespace knotspan
