// Trim loops that only we can hold, in files of formats whose faces end at their loops.
#include <gtest/gtest.h>

#include "model/analysis/trimmed_area.h"
#include "model/formats/format_list.h"
#include "model/formats/mesh_export.h"
#include "model/formats/verified_writing.h"
#include "model/formats/written_loops.h"
#include "model/geometry/primitives.h"
#include "tests/model/trimming/loop_samples.h"
#include "tests/support.h"

namespace knotspan {
namespace {

TrimLoop rectangle(const Vec2& low, const Vec2& high, bool outer)
{
    std::vector<Vec2> corners{low, {high.x, low.y}, high, {low.x, high.y}, low};
    if (!outer)
        std::reverse(corners.begin(), corners.end());
    return {outer, {testing::polyline(corners)}};
}

// Of 2 x 3.
Scene plateWith(const std::vector<TrimLoop>& loops)
{
    Scene scene;
    scene.add({.name = "plate", .surface = plane({0, 0, 0}, {2, 0, 0}, {0, 3, 0}), .trimLoops = loops});
    return scene;
}

double areaOf(const Scene& scene)
{
    double sum = 0;
    for (const auto& [id, object] : scene.objects())
        sum += trimmedArea(object->surface, object->trimLoops, object->transform).value;
    return sum;
}

class WrittenLoops : public ::testing::TestWithParam<std::string> {};

void expectArea(const Scene& scene, double area, const std::string& extension)
{
    EXPECT_NEAR(areaOf(scene), area, 1e-9) << "here";
    const testing::TemporaryFolder folder;
    const auto path = folder / ("a" + extension);
    const auto written = formats::writeVerified(scene, path);
    ASSERT_TRUE(written) << written.error().sentence();
    const auto back = formats::read(path);
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(back->objects().size(), 1U);
    EXPECT_NEAR(areaOf(*back), area, 1e-9) << "there";
}

TEST_P(WrittenLoops, EndAtTheBorderThatTheyReachBeyond)
{
    const TrimLoop border = rectangle({0, 0}, {1, 1}, true);
    expectArea(plateWith({border, rectangle({-0.2, 0.3}, {0.4, 0.6}, false)}), 6 * (1 - 0.4 * 0.3),
               GetParam());
    expectArea(plateWith({rectangle({-0.2, 0.3}, {0.4, 0.6}, false)}), 6 * (1 - 0.4 * 0.3), GetParam());
    expectArea(plateWith({rectangle({0.25, 0.25}, {1.5, 1.25}, true)}), 6 * 0.75 * 0.75, GetParam());
}

TEST_P(WrittenLoops, ThatCannotBeFollowedAreLeftOutAsTheyAreShown)
{
    const TrimLoop open{true, {testing::polyline({{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}})}};
    expectArea(plateWith({open}), 6, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Every, WrittenLoops, ::testing::Values(".step", ".igs", ".brep"),
                         [](const auto& format) { return format.param.substr(1); });

TEST(LoopsAsShown, StayToTheBitWhereNothingIsWrong)
{
    const Scene scene =
        plateWith({rectangle({0, 0}, {1, 1}, true), rectangle({0.2, 0.3}, {0.4, 0.6}, false)});
    const Scene shown = formats::withLoopsAsShown(scene);
    for (const auto& [id, object] : scene.objects())
        EXPECT_EQ(object, shown.find(id));
}

// Which STL has at one place once: each body has vertices of its own.
TEST(MeshesOfTouchingBodies, ArePassedWhenReadBack)
{
    Scene scene;
    for (const double z : {0.0, 1.0})
        for (const NurbsSurface& face :
             {plane({0, 0, z}, {0, 1, 0}, {1, 0, 0}), plane({0, 0, z}, {1, 0, 0}, {0, 0, 1}),
              plane({0, 0, z}, {0, 0, 1}, {0, 1, 0}), plane({0, 0, z + 1}, {1, 0, 0}, {0, 1, 0}),
              plane({0, 1, z}, {0, 0, 1}, {1, 0, 0}), plane({1, 0, z}, {0, 1, 0}, {0, 0, 1})})
            scene.add({.name = "face", .surface = face, .trimLoops = {rectangle({0, 0}, {1, 1}, true)}});
    const testing::TemporaryFolder folder;
    for (const auto kind : {formats::MeshKind::stl, formats::MeshKind::ply}) {
        formats::MeshExportOptions options;
        options.kind = kind;
        options.deviation = 0.01;
        options.verify = true;
        const auto report = formats::exportMesh(scene, folder / "a", options);
        ASSERT_TRUE(report) << report.error().sentence();
        EXPECT_EQ(report->boundaryEdges, 0U);
        EXPECT_EQ(report->nonManifoldEdges, 0U);
    }
}

}  // namespace
}  // namespace knotspan
