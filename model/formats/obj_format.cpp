#include "model/formats/obj_format.h"

#include <fstream>

#include "model/formats/text_file.h"

namespace knotspan::formats {

namespace {

constexpr unsigned kMostMebibytes = 512;

Result<Import> readObjFile(const std::filesystem::path& path)
{
    return wholeText(path, kMostMebibytes, "obj").and_then([](const std::string& text) {
        return sceneFromObj(text);
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
    return {"OBJ", {"obj"}, readObjFile, writeObjFile};
}

}  // namespace knotspan::formats
