#include "model/cad/occt_faces.h"

#include <algorithm>
#include <cstdio>

#include <Standard_Failure.hxx>

#include "model/cad/occt_trim_loops.h"
#include "model/files/text_file.h"

namespace knotspan::formats {
namespace {

constexpr size_t kMostRefusals = 100;

std::string complaintOf(const Standard_Failure& e)
{
    return std::string("OpenCASCADE says: ") + e.GetMessageString();
}

std::string shortly(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", number);
    return text;
}

}  // namespace

void FaceCollector::add(const TopoDS_Face& face, const FaceLabel& label)
{
    ++import_.report.faces;
    std::string name = nameIn(label.name);
    if (name.empty())
        name = "Face " + std::to_string(import_.report.faces);
    try {
        addConverted(face, name, label);
    } catch (const Standard_Failure& e) {
        refuse(name, complaintOf(e));
    }
}

void FaceCollector::addConverted(const TopoDS_Face& face, const std::string& name, const FaceLabel& label)
{
    auto converted = occt::toNurbs(face, extent_);
    if (!converted)
        return refuse(name, converted.error().what);
    std::vector<TrimLoop> loops = loopsOf(face, *converted);
    ImportReport& report = import_.report;
    ++(converted->approximated ? report.approximated : report.exact);
    if (converted->approximated)
        report.approximationError = std::max(report.approximationError, converted->difference);
    import_.scene.add({name, label.colour.value_or(Colour{}), Mat4(1.0), true, std::move(converted->surface),
                       std::move(loops)});
}

std::vector<TrimLoop> FaceCollector::loopsOf(const TopoDS_Face& face, const occt::ConvertedSurface& converted)
{
    std::string reason;
    try {
        auto loops = occt::trimLoops(face, converted);
        if (loops)
            return std::move(*loops);
        reason = loops.error().what;
    } catch (const Standard_Failure& e) {
        reason = complaintOf(e);
    }
    if (import_.report.untrimmed++ == 0)
        firstTrimReason_ = reason;
    return {};
}

void FaceCollector::refuse(const std::string& name, const std::string& reason)
{
    ++import_.report.refused;
    if (import_.report.refusals.size() < kMostRefusals)
        import_.report.refusals.push_back({name, reason});
}

void FaceCollector::note(int count, const std::string& what)
{
    if (count > 0)
        import_.notes.push_back(std::to_string(count) + " of " + std::to_string(import_.report.faces) +
                                (count == 1 ? " faces was " : " faces were ") + what + '.');
}

Result<Import> FaceCollector::finish(const std::string& format) &&
{
    const ImportReport& report = import_.report;
    if (report.faces == 0)
        return failure("The " + format + " file holds no surfaces",
                       "Choose a file with solids, shells or faces");
    if (import_.scene.objects().empty())
        return failure("None of the file's " + std::to_string(report.faces) +
                           " faces can be shown; the first reason is: " + report.refusals.front().reason,
                       "Repair the model in the program that made it");
    if (report.refused > 0)
        note(report.refused, "left out; the first reason is: " + report.refusals.front().reason);
    note(report.untrimmed, "drawn without trim curves; the first reason is: " + firstTrimReason_);
    note(report.approximated, "approximated, because no NURBS surface equals it; the largest distance is " +
                                  shortly(report.approximationError) + " mm");
    return std::move(import_);
}

}  // namespace knotspan::formats
