#include "model/cad/iges_format.h"

#include <algorithm>
#include <array>
#include <fstream>

#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESGraph_Color.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>

#include "model/cad/iges_writing.h"
#include "model/cad/occt_entities.h"
#include "model/cad/occt_healing.h"
#include "model/cad/occt_reading.h"

namespace knotspan::formats {
namespace {

// Lines of 80 characters; the 73rd tells the section.
constexpr size_t kSectionColumn = 72;

bool isOfSection(const std::string& line, char section)
{
    return line.size() > kSectionColumn && line[kSectionColumn] == section;
}

Result<void> checkFrame(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return failure("The file cannot be opened", "Check that you may read it");
    std::string first(kSectionColumn + 1, '\0');
    file.read(first.data(), static_cast<std::streamsize>(first.size()));
    if (isOfSection(first, 'B') || isOfSection(first, 'C'))
        return failure("This is a binary or compressed IGES file", "Export it as ASCII");
    if (!file || !isOfSection(first, 'S'))
        return failure("This is not an IGES file", "Check that the file holds what its name says");
    // What ends too early is taken for a smaller model.
    constexpr std::streamoff kTail = 4096;
    file.seekg(0, std::ios::end);
    file.seekg(std::max<std::streamoff>(0, file.tellg() - kTail));
    bool ends = false;
    for (std::string line; std::getline(file, line);)
        ends = ends || isOfSection(line, 'T');
    if (!ends)
        return failure("The IGES file ends too early", "Export or copy it again");
    return {};
}

// The numbers of the standard, in order from 1; black is what writers without colours put.
std::optional<Colour> numbered(int number)
{
    static const std::array<Colour, 7> kColours{
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
    if (number < 2 || number > 8)
        return std::nullopt;
    return kColours[static_cast<size_t>(number - 2)];
}

std::optional<Colour> colourOf(const Handle(IGESData_IGESEntity) & entity)
{
    const auto own = Handle(IGESGraph_Color)::DownCast(entity->Color());
    if (own.IsNull())
        return numbered(entity->RankColor());
    double red = 0;
    double green = 0;
    double blue = 0;
    own->RGBIntensity(red, green, blue);  // percent
    for (const double part : {red, green, blue})
        if (!(part >= 0 && part <= 100))
            return std::nullopt;
    return Colour{red / 100, green / 100, blue / 100};
}

std::string nameOf(const Handle(IGESData_IGESEntity) & entity)
{
    if (entity.IsNull() || !entity->HasName() || entity->NameValue().IsNull())
        return {};
    const std::string name = entity->NameValue()->ToCString();
    const size_t start = name.find_first_not_of(' ');
    return start == std::string::npos ? std::string() : name.substr(start);
}

// Of a trimmed surface and the surface it trims, the outer one has the last word.
class Labels {
public:
    explicit Labels(const IGESControl_Reader& reader) : entities_(reader.WS()) {}

    [[nodiscard]] ShapeName name(const TopoDS_Shape& shape) const
    {
        ShapeName result;
        for (const auto& entity : entities_.of(shape))
            if (std::string own = nameOf(Handle(IGESData_IGESEntity)::DownCast(entity)); !own.empty())
                result.item = std::move(own);
        return result;
    }

    [[nodiscard]] std::optional<Colour> colour(const TopoDS_Face& face) const
    {
        std::optional<Colour> result;
        for (const auto& transient : entities_.of(face))
            if (const auto entity = Handle(IGESData_IGESEntity)::DownCast(transient); !entity.IsNull())
                if (const auto own = colourOf(entity))
                    result = own;
        return result;
    }

private:
    ShapeEntities entities_;
};

std::string unitOf(const IGESControl_Reader& reader)
{
    const Handle(IGESData_IGESModel) model = reader.IGESModel();
    if (model.IsNull() || model->GlobalSection().UnitName().IsNull())
        return {};
    return model->GlobalSection().UnitName()->ToCString();
}

bool isOurs(const IGESControl_Reader& reader)
{
    const Handle(TCollection_HAsciiString) system = reader.IGESModel()->GlobalSection().SystemId();
    return !system.IsNull() && system->String() == kOurIgesSystem;
}

Result<Import> readAll(const std::filesystem::path& path, const ImportProgress& progress)
{
    if (progress)
        progress("Reading", -1);
    IGESControl_Reader reader;
    // Surfaces are taken as they are, not broken where they are less than smooth.
    Interface_Static::SetIVal("read.iges.bspline.continuity", 0);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.IGESModel().IsNull())
        return failure("The IGES file is damaged", "Export or copy it again");
    const Handle(StageProgress) making = new StageProgress(progress, "Making shapes", 0, 0.5);
    const SwiftHealing healing;
    reader.TransferRoots(making->Start());
    const Labels labels(reader);
    return importOf({"IGES", reader.OneShape(), [&](const TopoDS_Shape& shape) { return labels.name(shape); },
                     [&](const TopoDS_Face& face) { return labels.colour(face); }, unitOf(reader),
                     isOurs(reader)},
                    progress);
}

Result<Import> readWatched(const std::filesystem::path& path, const ImportProgress& progress)
{
    if (const auto frame = checkFrame(path); !frame)
        return tl::unexpected(frame.error());
    return withOpenCascade([&] { return readAll(path, progress); });
}

}  // namespace

Result<Import> readIges(const std::filesystem::path& path)
{
    return readWatched(path, {});
}

Format igesFormat()
{
    return {"IGES", {"igs", "iges"}, readIges, writeIges, readWatched};
}

}  // namespace knotspan::formats
