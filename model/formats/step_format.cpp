#include "model/formats/step_format.h"

#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>

#include "model/formats/occt_reading.h"
#include "model/formats/step_checks.h"
#include "model/formats/step_labels.h"

namespace knotspan::formats {
namespace {

// The first unit of length that the file names.
std::string unitOf(STEPControl_Reader& reader)
{
    TColStd_SequenceOfAsciiString lengths;
    TColStd_SequenceOfAsciiString angles;
    TColStd_SequenceOfAsciiString solidAngles;
    reader.FileUnits(lengths, angles, solidAngles);
    return lengths.IsEmpty() ? std::string() : std::string(lengths.First().ToCString());
}

Result<Import> readAll(const std::filesystem::path& path, const ImportProgress& progress)
{
    if (progress)
        progress("Reading", -1);
    STEPControl_Reader reader;
    // Transferring what could not be read crashes.
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        return failure("The STEP file is damaged", "Export or copy it again");
    if (const auto records = checkStepRecords(reader); !records)
        return tl::unexpected(records.error());
    const std::string unit = unitOf(reader);
    const Handle(StageProgress) making = new StageProgress(progress, "Making shapes", 0, 0.5);
    reader.TransferRoots(making->Start());
    const StepLabels labels(reader);
    return importOf(
        {"STEP", reader.OneShape(), [&labels](const TopoDS_Face& face) { return labels.of(face); }, unit},
        progress);
}

Result<Import> readWatched(const std::filesystem::path& path, const ImportProgress& progress)
{
    if (const auto frame = checkStepFrame(path); !frame)
        return tl::unexpected(frame.error());
    return withOpenCascade([&] { return readAll(path, progress); });
}

}  // namespace

Result<Import> readStep(const std::filesystem::path& path)
{
    return readWatched(path, {});
}

Format stepFormat()
{
    return {"STEP", {"step", "stp", "p21"}, readStep, nullptr, readWatched};
}

}  // namespace knotspan::formats
