// From the faces of a file to the objects of a scene, with the count of what could not be taken over.
#pragma once

#include <optional>

#include "model/cad/occt_surface.h"
#include "model/files/format.h"

namespace knotspan::formats {

// What the file says of a face, beside its shape.
struct FaceLabel {
    std::string name;  // empty: none
    std::optional<Colour> colour;
};

class FaceCollector {
public:
    explicit FaceCollector(occt::Extent extent) : extent_(extent) {}

    void add(const TopoDS_Face& face, const FaceLabel& label);

    // Refuses a file without faces, or of which none can be shown; `format` is for the sentence.
    [[nodiscard]] Result<Import> finish(const std::string& format) &&;

private:
    void addConverted(const TopoDS_Face& face, const std::string& name, const FaceLabel& label);
    [[nodiscard]] std::vector<TrimLoop> loopsOf(const TopoDS_Face& face,
                                                const occt::ConvertedSurface& converted);
    void refuse(const std::string& name, const std::string& reason);
    void note(int count, const std::string& what);

    occt::Extent extent_;
    Import import_;
    std::string firstTrimReason_;
};

}  // namespace knotspan::formats
