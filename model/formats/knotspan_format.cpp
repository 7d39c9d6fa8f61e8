#include "model/formats/knotspan_format.h"

#include <fstream>

#include "model/files/json_parsing.h"
#include "model/files/text_file.h"
#include "model/formats/knotspan_json.h"

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

template <class Objects>
void writeLines(std::ofstream& file, const Objects& objects)
{
    const char* separator = "\n";
    for (const auto& [id, object] : objects) {
        file << separator << textOf(*object);
        separator = ",\n";
    }
    file << "\n]";
}

// One object a line: a change to one object is a change to one line.
Result<void> writeKnotspan(const Scene& scene, const std::filesystem::path& path)
{
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << "{\"format\": \"knotspan\", \"version\": 1, \"units\": " << textOf(scene.units())
         << ",\n\"objects\": [";
    writeLines(file, scene.objects());
    if (!scene.meshes().empty()) {
        file << ",\n\"meshes\": [";
        writeLines(file, scene.meshes());
    }
    file << "}\n";
    const bool isTooLarge = file.tellp() > std::streamoff{kMostMebibytes} << 20U;
    file.close();
    if (isTooLarge)
        return failure("The model would be a file of over " + std::to_string(kMostMebibytes) +
                           " MiB, more than Knotspan reads",
                       "Split it, or remove meshes from it");
    if (!file)
        return failure("The file cannot be written", "Check that the disk has room and try again");
    return {};
}

}  // namespace

Format knotspanFormat()
{
    Format format{"Knotspan", {"knotspan"}, readKnotspan, writeKnotspan};
    format.holdsMeshes = true;
    format.isOwn = true;
    return format;
}

}  // namespace knotspan::formats
