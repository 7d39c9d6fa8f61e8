#include "model/cad/step_checks.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string_view>

#include <Interface_Check.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepRepr_RepresentationItem.hxx>

namespace knotspan::formats {
namespace {

constexpr std::uintmax_t kLargestFile = 2'000'000'000;

// Up to `size` bytes from `offset` on, in upper case.
std::string part(std::ifstream& file, std::uintmax_t offset, size_t size)
{
    std::string text(size, '\0');
    file.clear();
    file.seekg(static_cast<std::streamoff>(offset));
    file.read(text.data(), static_cast<std::streamsize>(size));
    text.resize(static_cast<size_t>(file.gcount()));
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

// Why the record cannot be used; empty where it can.
std::string faultOf(const Handle(StepData_StepModel) & model, int number)
{
    const Handle(Standard_Transient) record = model->Value(number);
    const std::string_view type = record->DynamicType()->Name();
    if (!type.starts_with("StepGeom_") && !type.starts_with("StepShape_") && !type.starts_with("StepRepr_"))
        return {};
    const Handle(Interface_Check) check = model->Check(number, Standard_True);
    for (int k = 1; k <= check->NbFails(); ++k) {
        std::string fail = check->Fail(k)->ToCString();
        if (fail.find("not a quoted String") == std::string::npos)  // names may be missing
            return fail;
    }
    if (const auto pcurve = Handle(StepGeom_Pcurve)::DownCast(record); !pcurve.IsNull()) {
        const auto curve = pcurve->ReferenceToCurve();
        if (curve.IsNull() || curve->Items().IsNull() || curve->NbItems() < 1 ||
            curve->ItemsValue(1).IsNull() || !curve->ItemsValue(1)->IsKind(STANDARD_TYPE(StepGeom_Curve)))
            return "a curve on a surface is missing";
    }
    return {};
}

}  // namespace

Result<void> checkStepFrame(const std::filesystem::path& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return failure("This is no file", "Give the path of a STEP file");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    if (error || !file)
        return failure("The file cannot be opened", "Check that you may read it");
    if (size == 0)
        return failure("The file is empty", "Export the model again");
    if (size > kLargestFile)
        return failure("The file is larger than 2 GB", "Split the model into several files");
    if (part(file, 0, 4096).find("ISO-10303-21") == std::string::npos)
        return failure("This is not a STEP file", "Check that the file holds what its name says");
    constexpr size_t kTail = 65536;
    if (part(file, size > kTail ? size - kTail : 0, kTail).find("END-ISO-10303-21") == std::string::npos)
        return failure("The STEP file ends too early", "Export or copy it again");
    return {};
}

Result<void> checkStepRecords(const STEPControl_Reader& reader)
{
    const Handle(StepData_StepModel) model = reader.StepModel();
    for (int k = 1; k <= model->NbEntities(); ++k)
        if (const std::string fault = faultOf(model, k); !fault.empty())
            return failure("The STEP file is damaged at #" +
                               std::to_string(model->IdentLabel(model->Value(k))) + " (" + fault + ")",
                           "Export or copy it again");
    return {};
}

}  // namespace knotspan::formats
