#include "model/formats/verified_writing.h"

#include <algorithm>
#include <cstdio>

#include "model/core/check.h"
#include "model/files/file_replacement.h"
#include "model/formats/written_loops.h"

namespace knotspan::formats {

namespace {

Result<SceneDifference> differenceFrom(const Scene& scene, const Scene& back)
{
    auto difference = differenceBetween(scene, back);
    if (!difference)
        return difference;
    char largest[32];
    std::snprintf(largest, sizeof largest, "%.3g", difference->largest());
    if (!(difference->largest() <= kLostNothing))
        return failure(std::string("What was written is read back with numbers that differ by ") + largest +
                           " of the model",
                       "Choose another format");
    return difference;
}

bool haveSameMeshes(const Scene& scene, const Scene& back)
{
    return std::equal(scene.meshes().begin(), scene.meshes().end(), back.meshes().begin(),
                      back.meshes().end(),
                      [](const auto& a, const auto& b) { return *a.second == *b.second; });
}

}  // namespace

Result<SceneDifference> writeVerified(const Scene& wanted, const std::filesystem::path& path)
{
    const Format* format = find(path);
    check(format != nullptr && format->write != nullptr && format->read != nullptr,
          "verified files are of a format that is written and read");
    const Scene scene = format->isOwn ? wanted : withLoopsAsShown(wanted);
    SceneDifference difference;
    const auto write = [&](const std::filesystem::path& temporary) -> Result<void> {
        if (auto written = format->write(scene, temporary); !written)
            return written;
        auto back = format->read(temporary);
        if (!back)
            return failure("What was written cannot be read back (" + back.error().what + ")",
                           "Choose another format");
        if (!format->namesUnits)
            back->scene.setUnits(scene.units());
        if (format->holdsMeshes && !haveSameMeshes(scene, back->scene))
            return failure("What was written is read back with other meshes", "Choose another format");
        return differenceFrom(scene, back->scene).map([&](const SceneDifference& found) {
            difference = found;
        });
    };
    if (const auto written = replaceFile(path, write); !written)
        return tl::unexpected(written.error().at(path.string()));
    return difference;
}

}  // namespace knotspan::formats
