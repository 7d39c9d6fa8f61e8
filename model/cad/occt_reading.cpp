#include "model/cad/occt_reading.h"

#include <mutex>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>

#include "model/cad/occt_faces.h"
#include "model/files/length_units.h"

namespace knotspan::formats {

namespace {

// `done` is "read" or "written", for the sentences.
template <class T>
Result<T> guarded(const std::function<Result<T>()>& work, const std::string& done, const std::string& remedy)
{
    static std::mutex oneAtATime;
    const std::scoped_lock lock(oneAtATime);
    // Its messages would go to standard output, which belongs to data.
    Message::DefaultMessenger()->ChangePrinters().Clear();
    const std::string what = "The file could not be " + done + ": ";
    try {
        return work();
    } catch (const Standard_Failure& e) {
        return failure(what + "OpenCASCADE says: " + e.GetMessageString(), remedy);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        return failure(what + e.what(), remedy);
    }
}

}  // namespace

Result<Import> withOpenCascade(const std::function<Result<Import>()>& read)
{
    return guarded(read, "read", "Export it again");
}

Result<void> withOpenCascadeWriting(const std::function<Result<void>()>& write)
{
    return guarded(write, "written", "Save the model as .knotspan instead");
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
    FaceCollector collector(read.isOurs ? occt::Extent::whole : occt::Extent::face);
    std::vector<NamedFace> faces;
    if (!read.shape.IsNull())
        faces = namedFaces(
            read.shape, read.nameOf ? read.nameOf : [](const TopoDS_Shape&) { return ShapeName{}; });
    for (size_t k = 0; k < faces.size(); ++k) {
        if (progress)
            progress("Converting face " + std::to_string(k + 1) + " of " + std::to_string(faces.size()),
                     0.5 + 0.5 * static_cast<double>(k) / static_cast<double>(faces.size()));
        collector.add(faces[k].face,
                      {faces[k].name, read.colourOf ? read.colourOf(faces[k].face) : std::nullopt});
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
