// Real OBJ files; skipped where they are absent.
#include <fstream>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "model/formats/format_list.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using nlohmann::json;

TEST(ObjFiles, OfOtherProgramsAreReadWithAllTheirSurfaces)
{
    KNOTSPAN_NEED_MODELS(folder);
    struct Counts {
        size_t surfaces, ksQuads, controlPoints;
    };
    const std::map<std::string, Counts> files{
        {"newell_teapot", {28, 28, 448}},
        {"newell_teacup", {26, 26, 416}},
        {"newell_teaspoon", {16, 16, 256}},
        {"gismo_duck_brep", {6, 632, 912}},
        {"gismo_egg", {1, 68, 180}},
        {"gismo_cylinder", {1, 4, 18}},
        {"gismo_tudflame_flat", {5, 441, 649}},
        {"aorta", {18, 4320, 5508}},
    };
    int read = 0;
    for (const auto& [name, counts] : files) {
        const auto path = *folder / (name + ".obj");
        if (!std::filesystem::exists(path))
            continue;
        const auto import = formats::readWithNotes(path);
        ASSERT_TRUE(import) << import.error().sentence();
        EXPECT_EQ(import->notes.size(), 0u) << name;
        EXPECT_EQ(import->scene.objects().size(), counts.surfaces) << name;
        EXPECT_EQ(import->scene.ksQuadCount(), counts.ksQuads) << name;
        EXPECT_EQ(import->scene.controlPointCount(), counts.controlPoints) << name;
        ++read;
    }
    if (read == 0)
        GTEST_SKIP() << "none of the OBJ files is here";
}

// The same surfaces in two formats, by name.
TEST(ObjFiles, OfExtremeSurfacesHaveTheNumbersOfTheirOracles)
{
    KNOTSPAN_NEED_MODELS(folder);
    const auto oracles = testing::oraclesFolder();
    if (!oracles || !std::filesystem::exists(*folder / "extreme_zoo.obj"))
        GTEST_SKIP() << "no oracles here";
    const auto import = formats::readWithNotes(*folder / "extreme_zoo.obj");
    ASSERT_TRUE(import) << import.error().sentence();
    ASSERT_EQ(import->notes.size(), 1u);
    EXPECT_EQ(import->notes[0].rfind("1 of 36 surfaces was left out; the first reason is: line ", 0), 0u);
    std::map<std::string, SharedObject> found;
    for (const auto& [id, object] : import->scene.objects())
        found[object->name] = object;
    int compared = 0;
    const json file = json::parse(std::ifstream(*oracles / "extreme_oracles.json"));
    for (const json& value : file["cases"]) {
        const std::string name = value["name"];
        SCOPED_TRACE(name);
        if (name == "c-1_break")
            continue;
        ASSERT_EQ(found.count(name), 1u);
        const NurbsSurface& surface = found[name]->surface;
        EXPECT_EQ(surface.knotsU().values(), value["knots_u"].get<std::vector<double>>());
        EXPECT_EQ(surface.knotsV().values(), value["knots_v"].get<std::vector<double>>());
        ASSERT_EQ(surface.controlPoints().size(), value["cps"].size());
        for (size_t k = 0; k < value["cps"].size(); ++k) {
            const json& point = value["cps"][k];
            EXPECT_EQ(surface.controlPoints()[k],
                      (ControlPoint{Vec3(point[0], point[1], point[2]), point[3]}))
                << k;
        }
        ++compared;
    }
    EXPECT_EQ(compared, 35);
}

}  // namespace
}  // namespace knotspan
