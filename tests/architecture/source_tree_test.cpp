#include "source_tree.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace knotspan::architecture {

TEST(NamingRule, RefusesCapitalsAndWordsThatSayNothing)
{
    EXPECT_EQ(namingFault("model/scene/control_point_editing.h"), "");
    EXPECT_EQ(namingFault("renderer/paths/mesh_9x9_path.cpp"), "");
    EXPECT_NE(namingFault("model/scene/SceneObject.h"), "");
    EXPECT_NE(namingFault("model/common/strings.h"), "");
    EXPECT_NE(namingFault("ui/window_manager.cpp"), "");
    EXPECT_NE(namingFault("tests/test_utils.h"), "");
}

TEST(DepthRule, RefusesAThirdFolder)
{
    EXPECT_EQ(depthFault("model/scene/scene.h"), "");
    EXPECT_EQ(depthFault("tests/model/scene/scene_test.cpp"), "");
    EXPECT_NE(depthFault("model/formats/step/reader.h"), "");
}

TEST(SourceTree, IsNamedInPlainWordsThatSaySomething)
{
    for (const std::string& file : sourceFiles()) {
        EXPECT_EQ(namingFault(file), "");
    }
}

TEST(SourceTree, HasFoldersTwoDeep)
{
    for (const std::string& file : sourceFiles()) {
        EXPECT_EQ(depthFault(file), "");
    }
}

TEST(SourceTree, HasNoFileAbove600Lines)
{
    for (const std::string& file : sourceFiles()) {
        const std::string content = contentOf(file);
        EXPECT_LE(std::count(content.begin(), content.end(), '\n'), 600)
            << file << ": is there a second idea in it?";
    }
}

TEST(SourceTree, HasHeadersThatSayFirstWhatTheyAreFor)
{
    for (const std::string& file : sourceFiles()) {
        if (file.size() > 2 && file.substr(file.size() - 2) == ".h") {
            EXPECT_EQ(contentOf(file).rfind("// ", 0), 0U)
                << file << ": begin with a sentence that says what it is for";
        }
    }
}

// Shaders are compiled by shaders/, and a test program's sources may lie one folder below it.
TEST(SourceTree, BuildsEveryFolderByItsOwnCMakeFile)
{
    const auto files = sourceFiles();
    const auto hasCMakeFile = [&files](const std::string& folder) {
        return std::binary_search(files.begin(), files.end(), folder + "/CMakeLists.txt");
    };
    for (const std::string& file : files) {
        const std::string folder = file.substr(0, file.rfind('/'));
        const bool mayLieBelow = file.rfind("shaders/", 0) == 0 || file.rfind("tests/", 0) == 0;
        if (isCpp(file)) {
            EXPECT_TRUE(hasCMakeFile(folder) ||
                        (mayLieBelow && hasCMakeFile(folder.substr(0, folder.rfind('/')))))
                << file << ": its folder has no CMakeLists.txt";
        }
    }
}

}  // namespace knotspan::architecture
