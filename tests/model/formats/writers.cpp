#include "tests/model/formats/writers.h"

#include <memory>

#include "model/formats/format_list.h"
#include "model/mesh/tessellation.h"
#include "model/mesh_files/mesh_files.h"
#include "model/samples/sample_list.h"
#include "tests/support.h"

namespace knotspan::testing {
namespace fs = std::filesystem;

namespace {

const Scene& sceneOf(Model model)
{
    static const Scene kOne = findSample("nine-16")->make();
    static const Scene kOther = findSample("torus")->make();
    return model == Model::one ? kOne : kOther;
}

const TriangleMesh& meshOf(Model model)
{
    const auto made = [](Model which) {
        const Scene& scene = sceneOf(which);
        return tessellate(scene, {.deviation = scene.bounds().diagonal() / 1000})->mesh;
    };
    static const TriangleMesh kOne = made(Model::one);
    static const TriangleMesh kOther = made(Model::other);
    return model == Model::one ? kOne : kOther;
}

}  // namespace

std::vector<Writer> writers()
{
    std::vector<Writer> list;
    for (const formats::Format& format : formats::all())
        if (format.write != nullptr)
            list.push_back({format.name, format.extensions.front(), [](Model model, const fs::path& path) {
                                return formats::write(sceneOf(model), path);
                            }});
    for (const formats::MeshFormat& format : formats::meshFormats())
        list.push_back(
            {format.name, format.extension, [kind = format.kind](Model model, const fs::path& path) {
                 return formats::writeMesh(path, meshOf(model), kind);
             }});
    return list;
}

bool isWhole(const fs::path& path, const fs::path& reference)
{
    if (readFile(path) == readFile(reference))
        return true;
    // Some formats say when they were written.
    const auto read = formats::read(path);
    const auto expected = formats::read(reference);
    return read && expected && *read == *expected;
}

size_t filesIn(const fs::path& folder)
{
    return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace knotspan::testing
