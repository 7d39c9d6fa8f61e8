// The program as users have it: installed, and out of its package.
#include <sstream>

#include <gtest/gtest.h>

#include "renderer/renderer.h"
#include "tests/resources/shell.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;
namespace fs = std::filesystem;

const char* const kInstall = "cmake --install " KNOTSPAN_BINARY_DIR " --prefix ";

// Works in a folder of its own, by the program in `bin`.
void expectItWorks(const fs::path& bin)
{
    const TemporaryFolder folder;
    const std::string go = "cd " + folder.path().string() + " && PATH=" + bin.string() + ":$PATH && ";
    for (const char* const command :
         {"knotspan --version", "knotspan sample torus -o torus.knotspan",
          "knotspan convert torus.knotspan torus.step", "knotspan info torus.step --json",
          "knotspan convert torus.knotspan torus.stl --deviation 0.05"}) {
        const ShellRun run = shell(go + command);
        EXPECT_EQ(run.exitCode, 0) << command << '\n' << run.output;
    }
    EXPECT_GT(fs::file_size(folder / "torus.stl"), 1000U);
}

class Installed : public ::testing::Test {
protected:
    Installed() : run_(shell(kInstall + prefix_.path().string())) {}

    [[nodiscard]] fs::path place(const std::string& path) const { return prefix_ / path; }

    TemporaryFolder prefix_;
    ShellRun run_;
};

TEST_F(Installed, HasEveryFileInItsPlace)
{
    ASSERT_EQ(run_.exitCode, 0) << run_.output;
    for (const char* const path :
         {"bin/knotspan", "share/applications/knotspan.desktop", "share/mime/packages/knotspan.xml",
          "share/icons/hicolor/48x48/apps/knotspan.png", "share/icons/hicolor/scalable/apps/knotspan.svg",
          "share/metainfo/org.knotspan.Knotspan.metainfo.xml", "share/thumbnailers/knotspan.thumbnailer",
          "share/man/man1/knotspan.1.gz", "share/doc/knotspan/copyright", "share/doc/knotspan/README.md"})
        EXPECT_TRUE(fs::is_regular_file(place(path))) << path;
}

TEST_F(Installed, WorksByItself)
{
    ASSERT_EQ(run_.exitCode, 0) << run_.output;
    expectItWorks(place("bin"));
    // Nor does it know where it was built.
    EXPECT_EQ(readFile(place("bin/knotspan")).find(KNOTSPAN_SOURCE_DIR), std::string::npos);
}

TEST_F(Installed, ItsManualNamesEveryCommand)
{
    KNOTSPAN_NEED_TOOL("gzip", "gzip");
    const std::string manual = shell("gzip -dc " + place("share/man/man1/knotspan.1.gz").string()).output;
    std::istringstream help(shell(place("bin/knotspan").string() + " --help").output);
    int commands = 0;
    bool listing = false;
    for (std::string line; std::getline(help, line);) {
        if (listing && line.rfind("  ", 0) == 0) {
            const std::string command = line.substr(2, line.find(' ', 2) - 2);
            ++commands;
            EXPECT_NE(manual.find("\n.B " + command + "\n"), std::string::npos) << command;
        }
        listing = listing || line.rfind("Subcommands:", 0) == 0;
    }
    EXPECT_GT(commands, 7);
}

// As a file manager does, with the line of the entry.
TEST_F(Installed, DrawsAThumbnail)
{
    if (!Renderer::create({}))
        GTEST_SKIP() << "no Vulkan device here: install mesa-vulkan-drivers to run this test";
    const TemporaryFolder folder;
    const std::string bin = place("bin").string();
    ASSERT_EQ(shell(bin + "/knotspan sample single-100 -o " + (folder / "it.knotspan").string()).exitCode, 0);
    std::istringstream lines(readFile(place("share/thumbnailers/knotspan.thumbnailer")));
    std::string command;
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("Exec=", 0) == 0)
            command = line.substr(5);
    for (const auto& [code, value] : {std::pair<std::string, std::string>{"%i", folder / "it.knotspan"},
                                      {"%o", folder / "it.png"},
                                      {"%s", "96"},
                                      {"%s", "96"}}) {
        const size_t at = command.find(code);
        ASSERT_NE(at, std::string::npos) << command;
        command.replace(at, code.size(), value);
    }
    const ShellRun run = shell("PATH=" + bin + ":$PATH; " + command);
    EXPECT_EQ(run.exitCode, 0) << run.output;
    const std::string png = readFile(folder / "it.png");
    ASSERT_GT(png.size(), 200U);
    EXPECT_EQ(png.substr(16, 8), std::string("\0\0\0\x60\0\0\0\x60", 8));  // its width and height
}

TEST(Package, InstallsAndWorks)
{
    KNOTSPAN_NEED_TOOL("dpkg-shlibdeps", "dpkg-dev");
    KNOTSPAN_NEED_TOOL("file", "file");
    const TemporaryFolder folder;
    const ShellRun packed = shell("cd " KNOTSPAN_BINARY_DIR " && cpack -G DEB -B " + folder.path().string() +
                                  " -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip");
    ASSERT_EQ(packed.exitCode, 0) << packed.output;
    fs::path package;
    for (const auto& file : fs::directory_iterator(folder.path()))
        if (file.path().extension() == ".deb")
            package = file.path();
    const std::string depends = shell("dpkg-deb -f " + package.string() + " Depends").output;
    for (const char* const library :
         {"libqt6widgets6", "libvulkan1", "libocct-data-exchange", "qt6-qpa-plugins"})
        EXPECT_NE(depends.find(library), std::string::npos) << depends;
    ASSERT_EQ(shell("dpkg-deb -x " + package.string() + " " + (folder / "root").string()).exitCode, 0);
    expectItWorks(folder / "root/usr/bin");
    if (hasTool("lintian")) {
        const ShellRun judged = shell("lintian --fail-on error " + package.string());
        EXPECT_EQ(judged.exitCode, 0) << judged.output;
    }
}

}  // namespace
}  // namespace knotspan
