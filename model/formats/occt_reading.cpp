#include "model/formats/occt_reading.h"

#include <mutex>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "model/formats/length_units.h"
#include "model/formats/occt_faces.h"

namespace knotspan::formats {

Result<Import> withOpenCascade(const std::function<Result<Import>()>& read)
{
    static std::mutex oneAtATime;
    const std::scoped_lock lock(oneAtATime);
    // Its messages would go to standard output, which belongs to data.
    Message::DefaultMessenger()->ChangePrinters().Clear();
    try {
        return read();
    } catch (const Standard_Failure& e) {
        return failure(std::string("OpenCASCADE could not read the file: ") + e.GetMessageString(),
                       "Export it again");
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        return failure(std::string("The file could not be read: ") + e.what(), "Export it again");
    }
}

StageProgress::StageProgress(const ImportProgress& progress, std::string stage, double start, double end)
    : progress_(progress),
      stage_(std::move(stage)),
      start_(start),
      length_(end - start)
{
}

void StageProgress::Show(const Message_ProgressScope&, Standard_Boolean)
{
    if (progress_)
        progress_(stage_, start_ + length_ * GetPosition());
}

Result<Import> importOf(const ReadShape& read, const ImportProgress& progress)
{
    FaceCollector collector;
    int count = 0;
    if (!read.shape.IsNull())
        for (TopExp_Explorer it(read.shape, TopAbs_FACE); it.More(); it.Next())
            ++count;
    if (count > 0) {
        int number = 0;
        for (TopExp_Explorer it(read.shape, TopAbs_FACE); it.More(); it.Next()) {
            ++number;
            if (progress)
                progress("Converting face " + std::to_string(number) + " of " + std::to_string(count),
                         0.5 + 0.5 * (number - 1) / count);
            const TopoDS_Face& face = TopoDS::Face(it.Current());
            collector.add(face, read.labelOf(face));
        }
    }
    auto import = std::move(collector).finish(read.format);
    if (!import)
        return import;
    import->scene.setUnits("mm");
    import->report.fileUnits = unitCalled(read.fileUnits);
    if (std::string said = conversionToMillimetres(import->report.fileUnits); !said.empty())
        import->notes.insert(import->notes.begin(), std::move(said));
    return import;
}

}  // namespace knotspan::formats
