#include <gtest/gtest.h>

#include "include_rules.h"
#include "source_tree.h"

namespace knotspan::architecture {

namespace {

std::string joined(const std::vector<std::string>& sentences)
{
    std::string all;
    for (const std::string& sentence : sentences) {
        all += sentence + "\n";
    }
    return all;
}

bool allows(const std::string& file, const std::string& included)
{
    return forbiddenIncludes(file, "#include <" + included + ">\n").empty();
}

}  // namespace

TEST(Includes, AreReadWhateverTheirSpacingAndBrackets)
{
    const std::string content = "#include <vector>\n  #  include \"model/core/result.h\" // why\n"
                                "// #include <no.h>\n#define include 3\n#include MACRO\n#include <open\n";
    EXPECT_EQ(includesOf(content), (std::vector<Include>{{"vector", false}, {"model/core/result.h", true}}));
}

TEST(IncludeRules, GoDownTheLayersOnly)
{
    EXPECT_TRUE(allows("app/main.cpp", "ui/main_window.h"));
    EXPECT_TRUE(allows("ui/main_window.h", "renderer/renderer.h"));
    EXPECT_TRUE(allows("renderer/renderer.h", "model/scene/scene.h"));
    EXPECT_FALSE(allows("model/scene/scene.h", "renderer/frame.h"));
    EXPECT_FALSE(allows("renderer/renderer.cpp", "ui/main_window.h"));
    EXPECT_FALSE(allows("ui/main_window.cpp", "app/commands.h"));
    EXPECT_FALSE(allows("shaders/shared/layouts.h", "model/core/space.h"));
}

TEST(IncludeRules, HoldTheOrderInsideModel)
{
    EXPECT_TRUE(allows("model/scene/scene_object.h", "model/geometry/nurbs_surface.h"));
    EXPECT_TRUE(allows("model/document/document.cpp", "model/formats/format_list.h"));
    EXPECT_FALSE(allows("model/core/space.h", "model/geometry/basis.h"));
    EXPECT_FALSE(allows("model/geometry/basis.h", "model/scene/scene.h"));
    EXPECT_FALSE(allows("model/scene/scene.cpp", "model/files/format.h"));
    EXPECT_FALSE(allows("model/formats/step.cpp", "model/document/document.h"));
    EXPECT_FALSE(allows("model/formats/step.cpp", "model/samples/sample_list.h"));
}

TEST(IncludeRules, HoldTheOrderInsideTheRenderer)
{
    EXPECT_TRUE(allows("renderer/paths/mesh_9x9_path.cpp", "renderer/scene/patch_table.h"));
    EXPECT_TRUE(allows("renderer/stats/frame_stats.h", "renderer/culling/cull_modes.h"));
    EXPECT_FALSE(allows("renderer/vulkan/device.cpp", "renderer/scene/camera.h"));
    EXPECT_FALSE(allows("renderer/scene/camera.h", "renderer/paths/path_list.h"));
    EXPECT_FALSE(allows("renderer/paths/mesh_9x9_path.cpp", "renderer/culling/cull_pass.h"));
    EXPECT_FALSE(allows("renderer/overlays/control_net.cpp", "renderer/renderer.h"));
    EXPECT_FALSE(allows("renderer/scene/gpu_scene.cpp", "model/document/document.h"));
    EXPECT_FALSE(allows("renderer/renderer.cpp", "model/samples/sample_list.h"));
}

TEST(IncludeRules, KeepThePathsApart)
{
    EXPECT_TRUE(allows("renderer/paths/mesh_9x9_path.cpp", "renderer/paths/mesh_9x9_path.h"));
    EXPECT_TRUE(allows("renderer/paths/mesh_9x9_path.h", "renderer/paths/surface_path.h"));
    EXPECT_TRUE(allows("renderer/paths/path_list.cpp", "renderer/paths/mesh_9x9_path.h"));
    EXPECT_FALSE(allows("renderer/paths/mesh_9x9_path.cpp", "renderer/paths/tessellation_path.h"));
}

TEST(IncludeRules, KeepTheWindowAwayFromTheRenderersInside)
{
    EXPECT_TRUE(allows("ui/panels/stats_panel.cpp", "renderer/stats/frame_stats.h"));
    EXPECT_TRUE(allows("ui/viewport/swapchain_presenter.cpp", "vulkan/vulkan.h"));
    EXPECT_FALSE(allows("ui/viewport/swapchain_presenter.cpp", "renderer/vulkan/swapchain.h"));
    EXPECT_FALSE(allows("ui/panels/stats_panel.cpp", "vulkan/vulkan.h"));
}

TEST(IncludeRules, HoldTheOrderInsideTheWindow)
{
    EXPECT_TRUE(allows("ui/panels/objects_panel.cpp", "ui/viewport/viewport.h"));
    EXPECT_FALSE(allows("ui/viewport/viewport.cpp", "ui/panels/stats_panel.h"));
    EXPECT_FALSE(allows("ui/tools/tool.h", "ui/viewport/viewport.h"));
    EXPECT_FALSE(allows("ui/panels/stats_panel.cpp", "ui/main_window.h"));
}

TEST(IncludeRules, KeepEachLibraryInItsFolders)
{
    EXPECT_TRUE(allows("ui/actions.h", "QAction"));
    EXPECT_TRUE(allows("model/document/document.h", "QtCore/QObject"));
    EXPECT_TRUE(allows("model/cad/step.cpp", "STEPControl_Reader.hxx"));
    EXPECT_TRUE(allows("app/main.cpp", "CLI/CLI.hpp"));
    EXPECT_FALSE(allows("model/scene/scene.h", "QString"));
    EXPECT_FALSE(allows("renderer/renderer.h", "QImage"));
    EXPECT_FALSE(allows("model/geometry/basis.h", "vulkan/vulkan.h"));
    EXPECT_FALSE(allows("model/document/document.cpp", "Geom_BSplineSurface.hxx"));
    EXPECT_FALSE(allows("ui/main_window.cpp", "vtkPolyData.h"));
    EXPECT_FALSE(allows("ui/main_window.cpp", "CLI/CLI.hpp"));
    EXPECT_FALSE(allows("model/core/check.cpp", "gtest/gtest.h"));
}

TEST(IncludeRules, KeepTheDiskInTheFormatsAndTheCommands)
{
    EXPECT_TRUE(allows("model/formats/step.cpp", "fstream"));
    EXPECT_TRUE(allows("model/document/document.h", "filesystem"));
    EXPECT_FALSE(allows("model/document/document.cpp", "fstream"));
    EXPECT_FALSE(allows("model/geometry/basis.h", "filesystem"));
    EXPECT_FALSE(allows("renderer/vulkan/pipeline.cpp", "fstream"));
    EXPECT_FALSE(allows("ui/main_window.cpp", "QFile"));
}

TEST(IncludeRules, WantQuotedPathsFromTheRootButInShaders)
{
    EXPECT_FALSE(forbiddenIncludes("model/scene/scene.cpp", "#include \"scene.h\"\n").empty());
    EXPECT_TRUE(forbiddenIncludes("model/scene/scene.cpp", "#include \"model/scene/scene.h\"\n").empty());
    EXPECT_TRUE(forbiddenIncludes("shaders/surface/a.mesh", "#include \"../culling/lqc.glsl\"\n").empty());
    EXPECT_FALSE(forbiddenIncludes("shaders/shared/a.glsl", "#include \"../culling/lqc.glsl\"\n").empty());
}

TEST(IncludeRules, RefuseAFolderThatTheTableDoesNotKnow)
{
    EXPECT_FALSE(forbiddenIncludes("model/extras/thing.h", "").empty());
}

TEST(SourceTree, HoldsToTheIncludeRules)
{
    int checked = 0;
    std::vector<std::string> broken;
    for (const std::string& file : sourceFiles()) {
        if ((isCpp(file) || isShader(file)) && file.rfind("tests/", 0) != 0) {
            const auto sentences = forbiddenIncludes(file, contentOf(file));
            broken.insert(broken.end(), sentences.begin(), sentences.end());
            ++checked;
        }
    }
    EXPECT_GT(checked, 20) << "the tree was not found";
    EXPECT_TRUE(broken.empty()) << joined(broken);
}

}  // namespace knotspan::architecture
