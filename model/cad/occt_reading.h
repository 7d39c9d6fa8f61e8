// What the readers of STEP, IGES and BREP share: OpenCASCADE quiet and one at a time, and its shapes taken
// over face by face.
#pragma once

#include <functional>
#include <optional>

#include "model/cad/occt_names.h"
#include "model/files/format.h"
#include <Message_ProgressIndicator.hxx>

namespace knotspan::formats {

// Runs `read` with nothing on standard output, whichever thread asks one after the other, and with
// OpenCASCADE's exceptions turned into errors.
[[nodiscard]] Result<Import> withOpenCascade(const std::function<Result<Import>()>& read);
// The same for what is written.
[[nodiscard]] Result<void> withOpenCascadeWriting(const std::function<Result<void>()>& write);

// Tells OpenCASCADE's own progress as a stage that fills the part from `start` to `end` of the whole.
class StageProgress : public Message_ProgressIndicator {
public:
    StageProgress(const ImportProgress& progress, std::string stage, double start, double end);

protected:
    void Show(const Message_ProgressScope& scope, Standard_Boolean isForced) override;

private:
    const ImportProgress& progress_;
    std::string stage_;
    double start_;
    double length_;
};

struct ReadShape {
    std::string format;  // "STEP", for sentences
    TopoDS_Shape shape;  // in millimetres
    // What the file says of its shapes; null: nothing.
    std::function<ShapeName(const TopoDS_Shape&)> nameOf;
    std::function<std::optional<Colour>(const TopoDS_Face&)> colourOf;
    std::string fileUnits;  // as the file calls its unit; empty: it names none
    bool isOurs = false;    // written by Knotspan: surfaces come back as they were
};

// Every face as one object. Refuses a shape of which nothing can be shown; notes what could not be taken over
// as it was, and what unit the lengths were converted from.
[[nodiscard]] Result<Import> importOf(const ReadShape& read, const ImportProgress& progress);

}  // namespace knotspan::formats
