#include "model/formats/knotspan_format.h"

#include <fstream>

#include "model/formats/knotspan_json.h"
#include "model/formats/text_file.h"

namespace knotspan::formats {

namespace {

constexpr unsigned kMostMebibytes = 512;

Result<Import> readKnotspan(const std::filesystem::path& path)
{
    auto text = wholeText(path, kMostMebibytes, "knotspan");
    if (!text)
        return tl::unexpected(text.error());
    auto json = parsedJson(*text);
    if (!json)
        return tl::unexpected(json.error());
    *text = {};
    return sceneFromJson(*json).map([](Scene&& scene) { return Import{std::move(scene), {}}; });
}

// One object a line: a change to one object is a change to one line.
Result<void> writeKnotspan(const Scene& scene, const std::filesystem::path& path)
{
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << "{\"format\": \"knotspan\", \"version\": 1, \"units\": " << textOf(scene.units())
         << ",\n\"objects\": [";
    const char* separator = "\n";
    for (const auto& [id, object] : scene.objects()) {
        file << separator << textOf(*object);
        separator = ",\n";
    }
    file << "\n]}\n";
    file.close();
    if (!file)
        return failure("The file cannot be written", "Check that the disk has room and try again");
    return {};
}

}  // namespace

Format knotspanFormat()
{
    return {"Knotspan", {"knotspan"}, readKnotspan, writeKnotspan};
}

}  // namespace knotspan::formats
