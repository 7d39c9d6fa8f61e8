#include "model/formats/knotspan_format.h"

#include <fstream>

#include "model/formats/knotspan_json.h"

namespace knotspan::formats {

namespace {

constexpr std::uintmax_t kLargestFile = 512u << 20;

Result<Import> readKnotspan(const std::filesystem::path& path)
{
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error)
        return failure("The file's size cannot be told: " + error.message());
    if (size > kLargestFile)
        return failure("The file is larger than the 512 MiB that a .knotspan file may have",
                       "Split the model into several files");
    std::string text(static_cast<size_t>(size), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(text.data(), static_cast<std::streamsize>(size));
    if (!file)
        return failure("The file cannot be read to its end");
    auto json = parsedJson(text);
    if (!json)
        return tl::unexpected(json.error());
    text = {};
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
