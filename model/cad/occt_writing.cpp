#include "model/cad/occt_writing.h"

#include <fstream>
#include <map>

#include "model/cad/occt_reading.h"

namespace knotspan::formats {

Result<void> writeFaces(const Scene& scene,
                        const std::function<Result<void>(const occt::ExportedScene&)>& write)
{
    return withOpenCascadeWriting([&]() -> Result<void> {
        const auto faces = occt::exported(scene);
        if (!faces)
            return tl::unexpected(faces.error());
        return write(*faces);
    });
}

Result<void> requireExtent(const occt::ExportedScene& scene, const std::string& format)
{
    constexpr double kSmallest = 1e-6;
    for (const occt::ExportedFace& face : scene.faces)
        if (face.size < kSmallest)
            return failure("\"" + face.name +
                               "\" is smaller than a millionth of a millimetre, too small for " + format,
                           "Scale it, or save the model as .knotspan");
    return {};
}

Result<void> printTo(const std::filesystem::path& path, const std::function<void(std::ostream&)>& print)
{
    std::ofstream file(path, std::ios::binary);
    if (file)
        print(file);
    file.close();
    if (!file)
        return failure("The file cannot be written", "Check that the disk has room and try again");
    return {};
}

std::string openCascadeUnit(const std::string& unit, const std::string& inch)
{
    static const std::map<std::string, std::string> kNames{{"um", "UM"}, {"mm", "MM"},   {"cm", "CM"},
                                                           {"m", "M"},   {"km", "KM"},   {"ft", "FT"},
                                                           {"mi", "MI"}, {"mil", "MIL"}, {"uin", "UIN"}};
    if (unit == "in")
        return inch;
    const auto known = kNames.find(unit);
    return known == kNames.end() ? "MM" : known->second;
}

}  // namespace knotspan::formats
