#include "model/cad/step_format.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>

#include "model/cad/occt_healing.h"
#include "model/cad/occt_reading.h"
#include "model/cad/step_checks.h"
#include "model/cad/step_labels.h"
#include "model/cad/step_writing.h"

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

bool isOurs(const STEPControl_Reader& reader)
{
    const APIHeaderSection_MakeHeader header(reader.StepModel());
    const Handle(TCollection_HAsciiString) system = header.HasFn() ? header.OriginatingSystem() : nullptr;
    return !system.IsNull() && system->String() == kOurStepSystem;
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
    const SwiftHealing healing;
    reader.TransferRoots(making->Start());
    const StepLabels labels(reader);
    return importOf({"STEP", reader.OneShape(), [&](const TopoDS_Shape& shape) { return labels.name(shape); },
                     [&](const TopoDS_Face& face) { return labels.colour(face); }, unit, isOurs(reader)},
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
    return {"STEP", {"step", "stp", "p21"}, readStep, writeStep, readWatched};
}

}  // namespace knotspan::formats
