#include "model/formats/step_format.h"

#include <mutex>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "model/formats/occt_trim_loops.h"
#include "model/formats/step_checks.h"

namespace knotspan::formats {
namespace {

// The name that the file gives the face; empty where it gives none.
std::string nameOf(const STEPControl_Reader& reader, const TopoDS_Face& face)
{
    const Handle(Standard_Transient) entity =
        reader.WS()->TransferReader()->EntityFromShapeResult(face.Located(TopLoc_Location()), 1);
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
    if (item.IsNull() || item->Name().IsNull())
        return {};
    std::string name = item->Name()->ToCString();
    return name == "NONE" ? std::string() : name;
}

// Collects the faces of one file, and counts what could not be taken over.
class Collector {
public:
    void add(const STEPControl_Reader& reader, const TopoDS_Face& face)
    {
        ++faces_;
        try {
            addConverted(reader, face);
        } catch (const Standard_Failure& e) {
            leaveOut(std::string("OpenCASCADE says: ") + e.GetMessageString());
        }
    }

    [[nodiscard]] Result<Import> finish() &&
    {
        if (faces_ == 0)
            return failure("The STEP file holds no surfaces", "Choose a file with solids, shells or faces");
        if (import_.scene.objects().empty())
            return failure("None of the file's " + std::to_string(faces_) +
                               " faces can be shown; the first reason is: " + firstReason_,
                           "Repair the model in the program that made it");
        note(leftOut_, "left out; the first reason is: " + firstReason_);
        note(untrimmed_, "drawn without trim curves; the first reason is: " + firstTrimReason_);
        note(approximated_, "approximated to 1/10000 of the face's size, because no NURBS surface equals it");
        return std::move(import_);
    }

private:
    void addConverted(const STEPControl_Reader& reader, const TopoDS_Face& face)
    {
        auto converted = occt::toNurbs(face);
        if (!converted)
            return leaveOut(converted.error().what);
        approximated_ += converted->approximated ? 1 : 0;
        std::string name = nameOf(reader, face);
        if (name.empty())
            name = "Face " + std::to_string(faces_);
        std::vector<TrimLoop> loops = loopsOf(face, *converted);
        import_.scene.add(
            {std::move(name), Colour{}, Mat4(1.0), true, std::move(converted->surface), std::move(loops)});
    }

    std::vector<TrimLoop> loopsOf(const TopoDS_Face& face, const occt::ConvertedSurface& converted)
    {
        std::string reason;
        try {
            auto loops = occt::trimLoops(face, converted);
            if (loops)
                return std::move(*loops);
            reason = loops.error().what;
        } catch (const Standard_Failure& e) {
            reason = std::string("OpenCASCADE says: ") + e.GetMessageString();
        }
        if (untrimmed_++ == 0)
            firstTrimReason_ = reason;
        return {};
    }

    void leaveOut(const std::string& reason)
    {
        if (leftOut_++ == 0)
            firstReason_ = reason;
    }

    void note(int count, const std::string& what)
    {
        if (count > 0)
            import_.notes.push_back(std::to_string(count) + " of " + std::to_string(faces_) +
                                    (count == 1 ? " faces was " : " faces were ") + what + '.');
    }

    Import import_;
    int faces_ = 0;
    int leftOut_ = 0;
    int untrimmed_ = 0;
    int approximated_ = 0;
    std::string firstReason_;
    std::string firstTrimReason_;
};

Result<Import> readWithOpenCascade(const std::filesystem::path& path)
{
    // Its messages would go to standard output, which belongs to data.
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Reader reader;
    // Transferring what could not be read crashes.
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        return failure("The STEP file is damaged", "Export or copy it again");
    if (const auto records = checkStepRecords(reader); !records)
        return tl::unexpected(records.error());
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    Collector collector;
    if (!shape.IsNull())
        for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
            collector.add(reader, TopoDS::Face(it.Current()));
    auto import = std::move(collector).finish();
    if (import)
        import->scene.setUnits("mm");
    return import;
}

}  // namespace

Result<Import> readStep(const std::filesystem::path& path)
{
    if (const auto frame = checkStepFrame(path); !frame)
        return tl::unexpected(frame.error());
    static std::mutex oneAtATime;
    const std::scoped_lock lock(oneAtATime);
    try {
        return readWithOpenCascade(path);
    } catch (const Standard_Failure& e) {
        return failure(std::string("OpenCASCADE could not read the file: ") + e.GetMessageString(),
                       "Export it again");
    } catch (const std::exception& e) {
        return failure(std::string("The file could not be read: ") + e.what(), "Export it again");
    }
}

Format stepFormat()
{
    return {"STEP", {"step", "stp", "p21"}, readStep, nullptr};
}

}  // namespace knotspan::formats
