#include "model/cad/brep_format.h"

#include <fstream>
#include <sstream>
#include <string_view>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>

#include "model/cad/occt_reading.h"
#include "model/cad/occt_writing.h"

namespace knotspan::formats {
namespace {

// The first line of our files.
constexpr std::string_view kOurs = "Written by Knotspan";

Result<void> checkFrame(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return failure("The file cannot be opened", "Check that you may read it");
    std::string start(256, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start.find("CASCADE Topology V") == std::string::npos)
        return failure("This is not a BREP file", "Check that the file holds what its name says");
    return {};
}

Result<Import> readAll(const std::filesystem::path& path, const ImportProgress& progress)
{
    const Handle(StageProgress) reading = new StageProgress(progress, "Reading", 0, 0.5);
    const auto damaged = [] { return failure("The BREP file is damaged", "Export or copy it again"); };
    TopoDS_Shape shape;
    std::ifstream file(path, std::ios::binary);
    std::string first(kOurs.size(), '\0');
    file.read(first.data(), static_cast<std::streamsize>(first.size()));
    const bool isOurs = file && first == kOurs;
    file.clear();
    file.seekg(0);
    // OpenCASCADE does not look whether anything is left: it would go on for as many items as the file
    // claims.
    file.exceptions(std::ios::failbit | std::ios::badbit);
    try {
        BRepTools::Read(shape, file, BRep_Builder(), reading->Start());
    } catch (const std::ios_base::failure&) {
        return damaged();
    }
    if (shape.IsNull())
        return damaged();
    return importOf({"BREP", shape, nullptr, nullptr, {}, isOurs}, progress);
}

Result<Import> readWatched(const std::filesystem::path& path, const ImportProgress& progress)
{
    if (const auto frame = checkFrame(path); !frame)
        return tl::unexpected(frame.error());
    return withOpenCascade([&] { return readAll(path, progress); });
}

}  // namespace

Result<Import> readBrep(const std::filesystem::path& path)
{
    return readWatched(path, {});
}

Result<void> writeBrep(const Scene& scene, const std::filesystem::path& path)
{
    return writeFaces(scene, [&](const occt::ExportedScene& faces) {
        // Not into the file: OpenCASCADE changes the stream's language in between, which a full disk does not
        // survive. Version 3, which it would choose by itself, is one that older ones cannot read.
        std::ostringstream text;
        BRepTools::Write(faces.compound, text, Standard_False, Standard_False,
                         TopTools_FormatVersion_VERSION_2);
        return printTo(path, [&](std::ostream& out) {
            out << kOurs << '\n';  // readers skip what comes before the first line of the format
            out << text.str();
        });
    });
}

Format brepFormat()
{
    return {"BREP", {"brep", "brp"}, readBrep, writeBrep, readWatched};
}

}  // namespace knotspan::formats
