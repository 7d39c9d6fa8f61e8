#include "model/formats/obj_format.h"

#include <fstream>

#include "model/files/length_units.h"
#include "model/files/text_file.h"

namespace knotspan::formats {

namespace {

constexpr unsigned kMostMebibytes = 512;

std::string unitsSaidIn(std::string_view text)
{
    const std::string_view first = text.substr(0, text.find_first_of("\r\n"));
    const size_t said = first.rfind(kObjUnits);
    if (first.substr(0, 1) != "#" || said == std::string_view::npos)
        return "mm";
    const std::string_view rest = first.substr(said + kObjUnits.size());
    std::string name(rest.substr(0, rest.rfind('.')));
    return millimetresIn(name) > 0 ? name : "mm";
}

Result<Import> readObjFile(const std::filesystem::path& path)
{
    return wholeText(path, kMostMebibytes, "obj").and_then([](const std::string& text) {
        return sceneFromObj(text).map([&](Import&& import) {
            import.scene.setUnits(unitsSaidIn(text));
            return std::move(import);
        });
    });
}

Result<void> writeObjFile(const Scene& scene, const std::filesystem::path& path)
{
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (auto written = writeObj(scene, file); !written)
        return written;
    file.close();
    if (!file)
        return failure("The file cannot be written", "Check that the disk has room and try again");
    return {};
}

}  // namespace

Format objFormat()
{
    Format format{"OBJ", {"obj"}, readObjFile, writeObjFile};
    format.namesUnits = false;
    return format;
}

}  // namespace knotspan::formats
