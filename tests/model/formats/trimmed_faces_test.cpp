// What is inside the trim loops of faces, against OpenCASCADE's own classifier: of a solid made here, and of
// the models that lie beside the repository, where they do.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "model/analysis/trimmed_area.h"
#include "model/cad/occt_trim_loops.h"
#include "model/geometry/evaluation.h"
#include "model/trimming/trim_index.h"

namespace knotspan::testing {
namespace {

struct Counts {
    int faces = 0;
    int trimmed = 0;
    int points = 0;
    int outside = 0;
    int wrong = 0;       // the region and OpenCASCADE disagree
    int wrongIndex = 0;  // the index and the region do
    int refused = 0;

    void operator+=(const Counts& other)
    {
        faces += other.faces;
        trimmed += other.trimmed;
        points += other.points;
        outside += other.outside;
        wrong += other.wrong;
        wrongIndex += other.wrongIndex;
        refused += other.refused;
    }
};

// Whether a loop passes within a small part of the domain.
bool isNearALoop(const TrimRegion& region, const Vec2& at, const Vec2& size, bool inside)
{
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            if (region.contains(at.x + 5e-3 * i * size.x, at.y + 5e-3 * j * size.y) != inside)
                return true;
    return false;
}

Counts compareFace(const TopoDS_Face& face)
{
    Counts counts;
    counts.faces = 1;
    const auto converted = occt::toNurbs(face, occt::Extent::face);
    if (!converted)
        return counts;
    const auto loops = occt::trimLoops(face, *converted);
    if (!loops || loops->empty())
        return counts;
    counts.trimmed = 1;
    const NurbsSurface& surface = converted->surface;
    const TrimRegion region(*loops, surface);
    counts.refused = !region.isTrimmed();
    const TrimIndex index = TrimIndex::create(region).value();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.01, 0.99);
    const Vec2 low(surface.knotsU().domainStart(), surface.knotsV().domainStart());
    const Vec2 size = Vec2(surface.knotsU().domainEnd(), surface.knotsV().domainEnd()) - low;
    for (int k = 0; k < 40; ++k) {
        const Vec2 at = low + Vec2(share(random), share(random)) * size;
        const bool inside = region.contains(at.x, at.y);
        if (isNearALoop(region, at, size, inside))
            continue;
        const Vec3 place = evaluate(surface, at.x, at.y).position;
        BRepClass_FaceClassifier classifier(face, gp_Pnt(place.x, place.y, place.z), 1e-5);
        if (classifier.State() != TopAbs_IN && classifier.State() != TopAbs_OUT)
            continue;
        ++counts.points;
        counts.outside += !inside;
        counts.wrong += (classifier.State() == TopAbs_IN) != inside;
        const TrimRegion::Place local = region.placeOf(at.x, at.y);
        counts.wrongIndex +=
            index.contains(static_cast<std::uint32_t>(local.a * region.countV() + local.b),
                           static_cast<float>(local.t.x), static_cast<float>(local.t.y)) != inside;
    }
    return counts;
}

// The area of what the loops leave, and OpenCASCADE's own of the face.
void compareAreas(const TopoDS_Shape& shape, int most, int& compared)
{
    int number = 0;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More() && number < most; it.Next(), ++number) {
        const TopoDS_Face face = TopoDS::Face(it.Current());
        const auto converted = occt::toNurbs(face, occt::Extent::face);
        if (!converted || converted->approximated)
            continue;
        const auto loops = occt::trimLoops(face, *converted);
        if (!loops || loops->empty())
            continue;
        GProp_GProps wanted;
        const double theirs = BRepGProp::SurfaceProperties(face, wanted, 1e-7);
        const Area found = trimmedArea(converted->surface, *loops, Mat4(1));
        EXPECT_NEAR(found.value, wanted.Mass(), found.error + (std::abs(theirs) + 2e-5) * wanted.Mass())
            << "face " << number;
        EXPECT_LE(found.error, 1e-6 * wanted.Mass()) << "face " << number;
        ++compared;
    }
}

Counts compareFaces(const TopoDS_Shape& shape, int most)
{
    Counts counts;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More() && counts.faces < most; it.Next())
        try {
            const Counts ofFace = compareFace(TopoDS::Face(it.Current()));
            EXPECT_EQ(ofFace.wrong, 0) << "face " << counts.faces;
            EXPECT_EQ(ofFace.wrongIndex, 0) << "face " << counts.faces;
            counts += ofFace;
        } catch (const Standard_Failure&) {
            ++counts.faces;
        }
    return counts;
}

TEST(TrimmedFaces, OfSolidsWithHolesAreWhereOpenCascadeHasThem)
{
    TopoDS_Shape solid = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
    solid = BRepAlgoAPI_Cut(solid, BRepPrimAPI_MakeCylinder(gp_Ax2({12, 12, -1}, {0, 0.2, 1}), 6, 30).Shape())
                .Shape();
    solid = BRepAlgoAPI_Cut(solid, BRepPrimAPI_MakeSphere(gp_Pnt(40, 30, 20), 9).Shape()).Shape();
    solid = BRepAlgoAPI_Cut(solid, BRepPrimAPI_MakeCone(gp_Ax2({28, 12, -1}, {0, 0, 1}), 3, 8, 22).Shape())
                .Shape();
    solid =
        BRepAlgoAPI_Cut(solid, BRepPrimAPI_MakeTorus(gp_Ax2({20, 0, 10}, {0, 0, 1}), 12, 3).Shape()).Shape();
    const Counts counts = compareFaces(solid, 1000);
    int areas = 0;
    compareAreas(solid, 1000, areas);
    EXPECT_GT(areas, 8);
    EXPECT_GT(counts.trimmed, 8);
    EXPECT_GT(counts.points, 150);
    EXPECT_GT(counts.outside, 40);
    EXPECT_EQ(counts.refused, 0);
}

TEST(TrimmedFaces, OfModelsBesideTheRepositoryAreWhereOpenCascadeHasThem)
{
    const auto folder = std::filesystem::path(KNOTSPAN_SOURCE_DIR).parent_path() / "shared/models";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no models beside the repository";
    Message::DefaultMessenger()->ChangePrinters().Clear();
    Counts all;
    int areas = 0;
    for (const char* name : {"NIST_MBE_PMI_3.stp", "NIST_MBE_PMI_5.stp", "NIST_MBE_PMI_11.stp", "screw.step",
                             "simplewing.step", "AMSurface.step", "occt_shell1.step", "nacelle.stp"}) {
        if (!std::filesystem::exists(folder / name))
            continue;
        SCOPED_TRACE(name);
        STEPControl_Reader reader;
        if (reader.ReadFile((folder / name).c_str()) != IFSelect_RetDone)
            continue;
        reader.TransferRoots();
        const Counts counts = compareFaces(reader.OneShape(), 400);
        EXPECT_EQ(counts.refused, 0) << name;
        all += counts;
        compareAreas(reader.OneShape(), 60, areas);
    }
    EXPECT_GT(areas, 60);
    EXPECT_GT(all.points, 1000);
    EXPECT_GT(all.outside, 500);
}

}  // namespace
}  // namespace knotspan::testing
