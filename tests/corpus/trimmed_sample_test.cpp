// Real trimmed models in the picture, beside OpenCASCADE's own mesh of the same file: a few small ones for
// every run of the tests; trimmed_corpora_test.cpp does it with hundreds.
#include <gtest/gtest.h>

#include "tests/corpus/compared_pictures.h"
#include "tests/corpus/picture_comparison.h"
#include "tests/renderer/render_support.h"
#include "tests/support.h"

namespace knotspan::corpus {
namespace {

TEST(TrimmedSample, LooksAsOpenCascadesOwnMeshOfItDoes)
{
    KNOTSPAN_NEED_MODELS(folder);
    KNOTSPAN_NEED_RENDERER(renderer);
    int trimmed = 0;
    for (const char* name : {"NIST_MBE_PMI_11.stp", "ap214_mapped_items.stp", "screw.step"}) {
        const ComparedFile compared =
            comparedPictures(*renderer, {"models", name, *folder / name}, std::nullopt);
        EXPECT_EQ(compared.unread, "");
        EXPECT_TRUE(compared.agrees()) << headerOfComparisons() << '\n' << lineOf(compared);
        EXPECT_GT(compared.shown, 100'000U);
        trimmed += compared.trimmed;
    }
    EXPECT_GT(trimmed, 15);
}

// A plate of two triangles, 100 pixels wide, with another one behind it.
class ComparedPlates : public ::testing::Test {
protected:
    void SetUp() override
    {
        camera.eye = {100, 75, 1000};
        camera.target = {100, 75, 0};
        camera.orthographic = true;
        camera.verticalFovDegrees = 2 * 180 / 3.14159265358979 * std::atan(75.0 / 1000);
        plate(50, 30, 0, 0);
        plate(80, 50, -40, 1);
    }

    void plate(double x, double y, double z, int face)
    {
        const Vec3 a(x, y, z), b(x + 100, y, z), c(x + 100, y + 60, z), d(x, y + 60, z);
        mesh.triangles.push_back({{a, b, c}, face});
        mesh.triangles.push_back({{a, c, d}, face});
    }

    [[nodiscard]] PictureDifference difference() const { return differenceOf(ours, theirs(), 1); }
    [[nodiscard]] LayeredPicture theirs() const { return {mesh, camera, kWidth, kHeight}; }

    // Ours as theirs is.
    void copy()
    {
        ours = {kWidth, kHeight, {}};
        const LayeredPicture picture = theirs();
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                ours.faces.push_back(picture.covered(x, y) ? picture.at(x, y).begin()->face : -1);
    }
    void show(int x, int y, int width, int height, int face)
    {
        for (int j = y; j < y + height; ++j)
            for (int i = x; i < x + width; ++i)
                ours.faces[static_cast<size_t>(j) * kWidth + static_cast<size_t>(i)] = face;
    }

    static constexpr int kWidth = 200;
    static constexpr int kHeight = 150;
    Camera camera;
    FineMesh mesh;
    ShownFaces ours;
};

TEST_F(ComparedPlates, CoverThePixelsWhoseCentresTheyMeet)
{
    const LayeredPicture picture = theirs();
    int covered = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            covered += picture.covered(x, y) ? 1 : 0;
    EXPECT_EQ(covered, 2 * 100 * 60 - 70 * 40);
    const auto both = picture.at(120, kHeight - 70);
    ASSERT_GE(both.end() - both.begin(), 2);
    EXPECT_EQ(both.begin()->face, 0);
    EXPECT_FLOAT_EQ(both.begin()->depth, 1000);
    EXPECT_FLOAT_EQ((both.end() - 1)->depth, 1040);
}

TEST_F(ComparedPlates, AgreeWithTheirOwnPictureAndWithOneAPixelAside)
{
    copy();
    EXPECT_EQ(difference().offSilhouette, 0U);
    EXPECT_EQ(difference().silhouette, 2U * (130 + 80) - 4);
    show(49, 60, 1, 60, 0);
    EXPECT_EQ(difference().offSilhouette, 0U);
    EXPECT_EQ(difference().otherFaces, 0U);
}

TEST_F(ComparedPlates, DifferWhereOneIsTwoPixelsAside)
{
    copy();
    show(48, 70, 2, 40, 0);
    EXPECT_EQ(difference().offSilhouette, 80U - 2U);  // at the far column's ends the outline is a pixel away
}

TEST_F(ComparedPlates, DifferWhereOneHasAGap)
{
    copy();
    show(60, 90, 20, 1, -1);
    EXPECT_EQ(difference().gaps, 20U);
    EXPECT_EQ(difference().wide, 0U);
    show(60, 91, 20, 1, -1);
    EXPECT_EQ(difference().gaps, 40U);
    EXPECT_EQ(difference().wide, 19U);
}

TEST_F(ComparedPlates, DifferWhereWhatIsBehindShowsBetweenFaces)
{
    plate(50, 90, 0, 2);
    copy();
    show(100, kHeight - 90, 5, 1, 1);  // the first row below where the plates meet; the one behind is there
    EXPECT_EQ(difference().leaks, 5U);
    EXPECT_EQ(difference().otherFaces, 0U);
}

// A wall that stands on the lower plate's outline, seen along itself.
TEST_F(ComparedPlates, AgreeWhereAFaceShowsThatIsSeenOnEdge)
{
    const Vec3 a(100, 60, 20), b(120, 60, 20), c(100, 60, 10);
    mesh.triangles.push_back({{a, b, c}, 2});
    copy();
    show(105, kHeight - 60, 5, 1, 2);
    EXPECT_EQ(difference().otherFaces + difference().leaks, 0U);
    show(105, kHeight - 70, 5, 1, 2);
    EXPECT_EQ(difference().otherFaces, 5U);
}

TEST_F(ComparedPlates, DifferWhereAHoleShowsWhatIsBehind)
{
    copy();
    show(100, 80, 10, 10, 1);
    EXPECT_EQ(difference().otherFaces, 100U);
    EXPECT_EQ(difference().leaks, 0U);
    EXPECT_EQ(difference().wide, 81U);
    EXPECT_EQ(difference().offSilhouette, 0U);
}

}  // namespace
}  // namespace knotspan::corpus
