// What the faces of assemblies are called, and where they stand.
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_AdvancedFace.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Compound.hxx>
#include <glm/geometric.hpp>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include "model/cad/step_format.h"
#include "tests/support.h"

namespace knotspan {
namespace {

Handle(TCollection_HAsciiString) text(const std::string& name)
{
    return new TCollection_HAsciiString(name.c_str());
}

gp_Trsf moved(double x, double y, double z)
{
    gp_Trsf transform;
    transform.SetTranslation({x, y, z});
    return transform;
}

// A quarter turn about z, then moved.
gp_Trsf turned(double x, double y, double z)
{
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1({0, 0, 0}, {0, 0, 1}), M_PI / 2);
    return moved(x, y, z) * turn;
}

TopoDS_Compound together(const std::vector<TopoDS_Shape>& shapes)
{
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes)
        builder.Add(compound, shape);
    return compound;
}

// What the records of a file are called, in order; nothing: they keep their names.
struct Names {
    std::vector<std::string> products;
    std::vector<std::string> solids;
    std::vector<std::string> faces;
};

template <class Record>
Handle(Record)
    next(const Handle(Standard_Transient) & record, const std::vector<std::string>& names, size_t used)
{
    return used < names.size() ? Handle(Record)::DownCast(record) : Handle(Record)();
}

Scene through(const TopoDS_Shape& shape, bool asAssembly, const Names& names)
{
    STEPControl_Controller::Init();
    Interface_Static::SetIVal("write.step.assembly", asAssembly ? 1 : 0);
    STEPControl_Writer writer;
    EXPECT_EQ(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
    const Handle(StepData_StepModel) model = writer.Model();
    size_t products = 0;
    size_t solids = 0;
    size_t faces = 0;
    for (int k = 1; k <= model->NbEntities(); ++k) {
        const Handle(Standard_Transient) record = model->Value(k);
        if (auto product = next<StepBasic_Product>(record, names.products, products); !product.IsNull())
            product->SetName(text(names.products[products++]));
        else if (auto solid = next<StepShape_ManifoldSolidBrep>(record, names.solids, solids);
                 !solid.IsNull())
            solid->SetName(text(names.solids[solids++]));
        else if (auto face = next<StepShape_AdvancedFace>(record, names.faces, faces); !face.IsNull())
            face->SetName(text(names.faces[faces++]));
    }
    const testing::TemporaryFolder folder;
    EXPECT_EQ(writer.Write((folder / "a.step").c_str()), IFSelect_RetDone);
    Interface_Static::SetIVal("write.step.assembly", 0);
    auto import = formats::readStep(folder / "a.step");
    EXPECT_TRUE(import) << (import ? "" : import.error().sentence());
    return import ? std::move(import->scene) : Scene();
}

std::vector<std::string> namesOf(const Scene& scene)
{
    std::vector<std::string> names;
    for (const auto& [unused, object] : scene.objects())
        names.push_back(object->name);
    return names;
}

Box boxOf(const Scene& scene, size_t first, size_t count)
{
    Box box;
    size_t k = 0;
    for (const auto& [unused, object] : scene.objects()) {
        if (k >= first && k < first + count)
            box.add(object->bounds());
        ++k;
    }
    return box;
}

void expectBox(const Box& box, const Vec3& low, const Vec3& high)
{
    EXPECT_LE(glm::length(box.low - low), 1e-9) << box.low.x << ' ' << box.low.y << ' ' << box.low.z;
    EXPECT_LE(glm::length(box.high - high), 1e-9) << box.high.x << ' ' << box.high.y << ' ' << box.high.z;
}

TEST(PartNames, InstancesOfAnAssemblysPartAreNumberedAndStandInTheirPlaces)
{
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
    const TopoDS_Shape assembly = together({plate.Moved(moved(0, 0, 0)), plate.Moved(turned(100, 0, 5))});
    const Scene scene = through(assembly, true, {{"Machine", "Bracket"}, {}, {}});
    const std::vector<std::string> names = namesOf(scene);
    ASSERT_EQ(names.size(), 12u);
    EXPECT_EQ(names[0], "Bracket 1: Face 1");
    EXPECT_EQ(names[5], "Bracket 1: Face 6");
    EXPECT_EQ(names[6], "Bracket 2: Face 1");
    EXPECT_EQ(names[11], "Bracket 2: Face 6");
    expectBox(boxOf(scene, 0, 6), {0, 0, 0}, {10, 20, 30});
    expectBox(boxOf(scene, 6, 6), {80, 0, 5}, {100, 10, 35});
}

TEST(PartNames, ANestedAssemblysPartsStandWhereBothPlacementsPutThem)
{
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
    const TopoDS_Shape pin = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    const TopoDS_Shape pair = together({plate, pin.Moved(moved(0, 0, 40))});
    const TopoDS_Shape assembly = together({pair.Moved(moved(0, 0, 0)), pair.Moved(turned(100, 0, 0))});
    const Scene scene = through(assembly, true, {{"Machine", "Pair", "Plate", "Pin"}, {}, {}});
    const std::vector<std::string> names = namesOf(scene);
    ASSERT_EQ(names.size(), 24u);
    EXPECT_EQ(names[0], "Plate 1: Face 1");
    EXPECT_EQ(names[6], "Pin 1: Face 1");
    EXPECT_EQ(names[12], "Plate 2: Face 1");
    EXPECT_EQ(names[18], "Pin 2: Face 1");
    expectBox(boxOf(scene, 6, 6), {0, 0, 40}, {1, 2, 43});
    expectBox(boxOf(scene, 18, 6), {98, 0, 40}, {100, 1, 43});
}

TEST(PartNames, FacesKeepTheirOwnNamesAndInAnAssemblyTheirPartsInFront)
{
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
    const Names own{{"Machine", "Bracket"}, {}, {"Back", "Front"}};
    const Scene one = through(plate, false, {{"Bracket"}, {}, {"Back", "Front"}});
    EXPECT_EQ(namesOf(one), (std::vector<std::string>{"Back", "Front", "Bracket: Face 3", "Bracket: Face 4",
                                                      "Bracket: Face 5", "Bracket: Face 6"}));
    const Scene two =
        through(together({plate.Moved(moved(0, 0, 0)), plate.Moved(moved(50, 0, 0))}), true, own);
    ASSERT_EQ(two.objects().size(), 12u);
    EXPECT_EQ(namesOf(two)[1], "Bracket 1: Front");
    EXPECT_EQ(namesOf(two)[2], "Bracket 1: Face 3");
    EXPECT_EQ(namesOf(two)[7], "Bracket 2: Front");
}

TEST(PartNames, WithinOneProductTheBodiesNamesAreUsed)
{
    const TopoDS_Shape both =
        together({BRepPrimAPI_MakeBox(1, 1, 1).Shape(), BRepPrimAPI_MakeCylinder(1, 9).Shape()});
    const std::vector<std::string> names =
        namesOf(through(both, false, {{"Document"}, {"Block", "Axle"}, {}}));
    ASSERT_EQ(names.size(), 9u);
    EXPECT_EQ(names[0], "Block: Face 1");
    EXPECT_EQ(names[8], "Axle: Face 3");
}

TEST(PartNames, WhatOpenCascadeCallsItsProductsIsNoName)
{
    const std::vector<std::string> names = namesOf(through(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), false, {}));
    ASSERT_EQ(names.size(), 6u);
    EXPECT_EQ(names[0], "Face 1");
    EXPECT_EQ(names[5], "Face 6");
}

}  // namespace
}  // namespace knotspan
