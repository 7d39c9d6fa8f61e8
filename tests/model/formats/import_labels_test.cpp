// What imports say beside the shapes: names, colours, units, placements, counts.
#include <sstream>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include "model/cad/brep_format.h"
#include "model/cad/iges_format.h"
#include "tests/model/formats/step_solids.h"
#include "tests/support.h"

namespace knotspan::testing {
namespace {

std::string stepOf(const TopoDS_Shape& shape)
{
    const TemporaryFolder folder;
    writeStep(shape, folder / "a.step");
    return readFile(folder / "a.step");
}

formats::Import importOf(const std::string& text)
{
    const TemporaryFolder folder;
    writeFile(folder / "a.step", text);
    auto import = formats::readStep(folder / "a.step");
    EXPECT_TRUE(import.has_value()) << (import ? "" : import.error().sentence());
    return import ? std::move(*import) : formats::Import{};
}

// "#12", the first record of that type.
std::string recordOf(const std::string& text, const std::string& type)
{
    const size_t at = text.find(std::string("= ").append(type));
    const size_t start = at == std::string::npos ? at : text.rfind('#', at);
    EXPECT_NE(start, std::string::npos) << type;
    return start == std::string::npos ? "" : text.substr(start, text.find(' ', start) - start);
}

// The file with that item (a record's number) coloured; `first` numbers the new records.
std::string coloured(const std::string& text, const std::string& item, const std::string& rgb, int first)
{
    const char* const kRecords[] = {
        "COLOUR_RGB('',@)",
        "FILL_AREA_STYLE_COLOUR('',#)",
        "FILL_AREA_STYLE('',(#))",
        "SURFACE_STYLE_FILL_AREA(#)",
        "SURFACE_SIDE_STYLE('',(#))",
        "SURFACE_STYLE_USAGE(.BOTH.,#)",
        "PRESENTATION_STYLE_ASSIGNMENT((#))",
        "STYLED_ITEM('color',(#),@)",
        "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#),@)",
    };
    // Each refers by # to the one before it, and by @ to what is given.
    std::vector<std::string> given{rgb, item, recordOf(text, "( GEOMETRIC_REPRESENTATION_CONTEXT")};
    std::ostringstream records;
    for (const char* const record : kRecords) {
        records << '#' << first << '=';
        for (const char c : std::string(record)) {
            if (c == '#')
                records << '#' << first - 1;
            else if (c == '@') {
                records << given.front();
                given.erase(given.begin());
            } else
                records << c;
        }
        records << ";\n";
        ++first;
    }
    std::string result = text;
    return result.insert(result.rfind("ENDSEC;"), records.str());
}

TEST(ImportLabels, TheColourOfASolidIsThatOfItsFacesAndAFacesOwnGoesFirst)
{
    const std::string plain = stepOf(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
    std::string text = coloured(plain, recordOf(plain, "MANIFOLD_SOLID_BREP"), "0.25,0.5,0.75", 9000);
    text = coloured(text, recordOf(plain, "ADVANCED_FACE"), "1.,0.125,0.", 9100);
    const formats::Import import = importOf(text);
    ASSERT_EQ(import.scene.objects().size(), 6U);
    int own = 0;
    for (const auto& [id, object] : import.scene.objects()) {
        const bool isOwn = object->colour == Colour{1, 0.125, 0};
        own += isOwn ? 1 : 0;
        EXPECT_TRUE(isOwn || (object->colour == Colour{0.25, 0.5, 0.75})) << object->colour.red;
    }
    EXPECT_EQ(own, 1);
}

TEST(ImportLabels, WithoutColoursFacesHaveOurs)
{
    const formats::Import import = throughStep(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
    for (const auto& [id, object] : import.scene.objects())
        EXPECT_EQ(object->colour, Colour{});
}

TEST(ImportLabels, NamesAreTheFilesOwn)
{
    std::string text = stepOf(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
    const size_t face = text.find("ADVANCED_FACE('");
    ASSERT_NE(face, std::string::npos);
    text.insert(face + std::string("ADVANCED_FACE('").size(), "Lid");
    const formats::Import import = importOf(text);
    ASSERT_EQ(import.scene.objects().size(), 6U);
    EXPECT_EQ(import.scene.objects().begin()->second->name, "Lid");
    EXPECT_EQ(std::next(import.scene.objects().begin())->second->name, "Face 2");
}

TEST(ImportLabels, LengthsBecomeMillimetresAndThatIsSaid)
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(25.4, 50.8, 76.2).Shape();
    const formats::Import plain = throughStep(box);
    EXPECT_EQ(plain.report.fileUnits, "mm");
    EXPECT_EQ(::testing::PrintToString(plain.notes), "{}");
    Interface_Static::SetCVal("write.step.unit", "INCH");
    Interface_Static::SetCVal("write.iges.unit", "INCH");
    const formats::Import inches = throughStep(box);
    const TemporaryFolder folder;
    IGESControl_Writer writer("INCH", 0);
    writer.AddShape(box);
    writer.Write((folder / "box.igs").c_str());
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetCVal("write.iges.unit", "MM");
    const auto iges = formats::readIges(folder / "box.igs");
    ASSERT_TRUE(iges) << iges.error().sentence();
    for (const formats::Import* import : {&inches, &*iges}) {
        EXPECT_EQ(import->report.fileUnits, "in");
        EXPECT_EQ(import->scene.units(), "mm");
        ASSERT_EQ(import->notes.size(), 1U);
        EXPECT_EQ(import->notes[0], "Lengths were converted from the file's unit (in) to mm.");
        EXPECT_NEAR(import->scene.bounds().diagonal(), plain.scene.bounds().diagonal(), 1e-6);
    }
    ASSERT_TRUE(BRepTools::Write(box, (folder / "box.brep").c_str()));
    const auto brep = formats::readBrep(folder / "box.brep");
    ASSERT_TRUE(brep) << brep.error().sentence();
    ASSERT_EQ(brep->notes.size(), 1U);
    EXPECT_EQ(brep->notes[0], "The file names no unit of length: its numbers are taken as millimetres.");
}

TEST(ImportLabels, PartsStandWhereTheirAssemblyPutsThem)
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
    gp_Trsf away;
    away.SetTranslation(gp_Vec(100, 0, 0));
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, box);
    builder.Add(both, box.Located(TopLoc_Location(away)));
    Interface_Static::SetIVal("write.step.assembly", 1);
    const formats::Import import = throughStep(both);
    Interface_Static::SetIVal("write.step.assembly", 0);
    EXPECT_EQ(import.scene.objects().size(), 12U);
    EXPECT_NEAR(import.scene.bounds().low.x, 0, 1e-9);
    EXPECT_NEAR(import.scene.bounds().high.x, 101, 1e-9);
}

TEST(ImportLabels, FacesAreCounted)
{
    const formats::Import import = throughStep(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
    EXPECT_EQ(import.report.faces, 6);
    EXPECT_EQ(import.report.exact, 6);
    EXPECT_EQ(import.report.approximated, 0);
    EXPECT_EQ(import.report.refused, 0);
    EXPECT_EQ(import.report.untrimmed, 0);
}

}  // namespace
}  // namespace knotspan::testing
