#include "model/formats/brep_format.h"

#include <fstream>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>

#include "model/formats/occt_reading.h"

namespace knotspan::formats {
namespace {

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
    return importOf({"BREP", shape, [](const TopoDS_Face&) { return FaceLabel{}; }, {}}, progress);
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

Format brepFormat()
{
    return {"BREP", {"brep", "brp"}, readBrep, nullptr, readWatched};
}

}  // namespace knotspan::formats
