// Where borders run together: in the samples, in every way two surfaces can, and not where they do not.
#include "model/analysis/coincident_edges.h"

#include <chrono>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/analysis/bezier_curves.h"
#include "model/geometry/knot_insertion.h"
#include "model/geometry/primitives.h"
#include "model/samples/net.h"
#include "model/samples/samples.h"
#include "tests/joined_surfaces.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

// Border sides by what lies along them.
struct Census {
    int whole = 0;   // one other side, from end to end
    int shared = 0;  // others, elsewise
    int open = 0;    // nobody
    int collapsed = 0;

    [[nodiscard]] bool operator==(const Census&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Census& census)
{
    return out << census.whole << " whole, " << census.shared << " shared, " << census.open << " open, "
               << census.collapsed << " collapsed";
}

Census censusOf(const CoincidentEdges& edges)
{
    Census census;
    for (std::uint32_t side = 0; side < edges.sideCount(); ++side) {
        const CoincidentEdge* const edge = edges.edgeAlong(side);
        if (edges.isCollapsed(side))
            ++census.collapsed;
        else if (edge == nullptr)
            ++census.open;
        else if (edge->members.size() == 2 && edge->cuts.size() == 2)
            ++census.whole;
        else
            ++census.shared;
    }
    return census;
}

Census censusOf(const Scene& scene)
{
    return censusOf(CoincidentEdges(placed(scene)));
}

Census censusOf(const std::vector<NurbsSurface>& surfaces)
{
    return censusOf(CoincidentEdges(placed(surfaces)));
}

TEST(CoincidentEdges, EveryBorderOfAClosedSampleIsSharedAndPolesAreCollapsed)
{
    EXPECT_EQ(censusOf(makeKnot()), (Census{12000, 0, 0, 0}));
    EXPECT_EQ(censusOf(makeTorus()), (Census{32, 0, 0, 0}));
    EXPECT_EQ(censusOf(makeSphere()), (Census{8, 0, 0, 16}));
}

TEST(CoincidentEdges, OpenSamplesShareTheirCutsAndSeams)
{
    EXPECT_EQ(censusOf(makeNine16()), (Census{24, 0, 12, 0}));
    // Two cuts on each side of the ship, six spans high; the keel, fifteen long, and the stem.
    EXPECT_EQ(censusOf(makeHull()), (Census{2 * 2 * 2 * 6 + 2 * 15 + 2 * 6, 0, 42, 0}));
    EXPECT_EQ(censusOf(makeSingle100()), (Census{0, 0, 28, 0}));
}

TEST(CoincidentEdges, CornersThatAreOnePointHaveTheLowestOwner)
{
    const CoincidentEdges sphere(placed(makeSphere()));
    const BorderNumbers& numbers = sphere.numbers()[0];
    std::uint32_t first = numbers.corner(0, 0);
    int atPole = 0;
    sphere.corners().forGroup(first, [&](std::uint32_t) { ++atPole; });
    const auto isPoleAlongV = [&] { return sphere.isCollapsed(numbers.firstBorder); };
    EXPECT_EQ(atPole, 1 + static_cast<int>(isPoleAlongV() ? numbers.spansV : numbers.spansU));
    EXPECT_EQ(sphere.corners().ownerOf(first), first);
    EXPECT_EQ(sphere.corners().nameOf(first), 0U);

    const CoincidentEdges torus(placed(makeTorus()));
    const BorderNumbers& ring = torus.numbers()[0];
    for (const auto& [i, j] : {std::pair{0U, ring.spansV}, {ring.spansU, 0U}, {ring.spansU, ring.spansV}})
        EXPECT_EQ(torus.corners().ownerOf(ring.corner(i, j)), ring.corner(0, 0));
}

TEST(CoincidentEdges, FindsBordersOfOtherDirectionDegreeAndKnots)
{
    const NurbsSurface sheet = curvedSheet();
    const NurbsSurface beside = neighbourOf(sheet, 0, 3, {0, 1, 0.3});
    const Census joined{6, 0, 14, 0};
    EXPECT_EQ(censusOf({sheet, beside}), joined);
    EXPECT_EQ(censusOf({sheet, reversedU(beside)}), joined);
    EXPECT_EQ(censusOf({exchanged(sheet), beside}), joined);
    EXPECT_EQ(censusOf({exchanged(reversedU(sheet)), exchanged(elevatedU(beside))}), joined);
    EXPECT_EQ(censusOf({reversedU(elevatedU(elevatedU(sheet))), elevatedU(beside)}), joined);
    // One side of the sheet's three has two beside it.
    EXPECT_EQ(censusOf({sheet, withKnotInserted(beside, Direction::U, 1.4)}), (Census{4, 3, 15, 0}));
}

TEST(CoincidentEdges, CutsEdgesWhereOthersEnd)
{
    const NurbsSurface sheet = curvedSheet();
    const Vec3 up{0, 1, 0.3};
    const std::vector<NurbsSurface> surfaces = {sheet, neighbourOf(sheet, 0, 1.37, up),
                                                reversedU(neighbourOf(sheet, 1.37, 3, up))};
    const CoincidentEdges edges(placed(surfaces));
    // The middle side of the sheet's border v = end.
    const BorderNumbers& numbers = edges.numbers()[0];
    const CoincidentEdge* const edge =
        edges.edgeAlong(numbers.firstBorder + 2 * numbers.spansV + numbers.spansU + 1);
    ASSERT_NE(edge, nullptr);
    ASSERT_EQ(edge->members.size(), 3U);
    ASSERT_EQ(edge->cuts.size(), 3U);
    EXPECT_EQ(edge->members[0].start, 0.0);
    EXPECT_EQ(edge->members[0].end, 1.0);
    EXPECT_NEAR(edge->cuts[1].at, 0.37, 1e-12);
    EXPECT_EQ(edge->members[1].end, edge->cuts[1].at);
    EXPECT_EQ(edge->members[2].start, 1.0);
    EXPECT_EQ(edge->members[2].end, edge->cuts[1].at);
}

TEST(CoincidentEdges, FindsParts)
{
    const NurbsSurface sheet = curvedSheet();
    const Vec3 up{0, 1, 0.3};
    const Vec3 aside{0, 0.2, 1};
    // Sides [0, 1] and [1, 1.6] beside [0.7, 1], [1, 2] and [2, 3]: all but the last share something.
    EXPECT_EQ(censusOf({neighbourOf(sheet, 0, 1.6, up), reversedU(neighbourOf(sheet, 0.7, 3, aside))}),
              (Census{0, 4, 2 + 4 + 4 + 3 + 1, 0}));
    // A short one within a side of a long one.
    EXPECT_EQ(censusOf({sheet, exchanged(neighbourOf(sheet, 1.31, 1.83, up))}), (Census{0, 2, 9 + 5, 0}));
    // Three along one edge.
    EXPECT_EQ(censusOf({sheet, reversedU(neighbourOf(sheet, 0, 3, up)), neighbourOf(sheet, 0, 3, aside)}),
              (Census{0, 9, 21, 0}));
}

TEST(CoincidentEdges, LeavesOpenWhatIsApart)
{
    const NurbsSurface sheet = curvedSheet();
    const NurbsSurface beside = neighbourOf(sheet, 0, 3, {0, 1, 0.3});
    for (const double gap : {1e-3, 1e-5}) {
        std::vector<PlacedSurface> surfaces = {{&sheet, Mat4(1.0)},
                                               {&beside, glm::translate(Mat4(1.0), Vec3(0, gap, 0))}};
        EXPECT_EQ(censusOf(CoincidentEdges(surfaces)), (Census{0, 0, 20, 0})) << gap;
    }
    // The same place in space is what counts, not the same numbers.
    const Mat4 away = glm::rotate(glm::translate(Mat4(1.0), Vec3(100, -20, 3)), 1.0, Vec3(1, 2, 3));
    const NurbsSurface there = surfaceOf(beside.knotsU(), beside.knotsV(), [&](int i, int j) {
        return ControlPoint{transformed(beside.controlPoint(i, j).position, glm::inverse(away)),
                            beside.controlPoint(i, j).weight};
    });
    EXPECT_EQ(censusOf(CoincidentEdges({{&sheet, Mat4(1.0)}, {&there, away}})), (Census{6, 0, 14, 0}));
    EXPECT_EQ(censusOf(CoincidentEdges({{&sheet, Mat4(1.0)}, {&there, Mat4(1.0)}})), (Census{0, 0, 20, 0}));
    // One curve in space, another parameter.
    const NurbsSurface uneven = surfaceOf(sheet.knotsU(), beside.knotsV(), [&](int i, int j) {
        ControlPoint point = beside.controlPoint(i, j);
        point.weight *= 1 + 0.01 * i;
        return point;
    });
    EXPECT_EQ(censusOf({sheet, uneven}).whole, 0);
}

TEST(CoincidentEdges, TakesNoPartBelowATenTwentyFourthOfASide)
{
    const NurbsSurface flat = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const auto beside = [](double start, double end) {
        return plane({start, 1, 0}, {end - start, 0, 0}, {0, 1, 0});
    };
    EXPECT_EQ(censusOf({flat, beside(0, 1)}), (Census{2, 0, 6, 0}));
    EXPECT_EQ(censusOf({flat, beside(0, 0.998)}), (Census{0, 2, 6, 0}));
    EXPECT_EQ(censusOf({flat, beside(0, 0.9995)}), (Census{0, 0, 8, 0}));
    // So near that it is the end.
    EXPECT_EQ(censusOf({flat, beside(0, 1 - 1e-8)}), (Census{2, 0, 6, 0}));
    // Two joints nearer to each other than that: the later surface stays out.
    EXPECT_EQ(censusOf({flat, beside(0, 0.5), plane({0.5004, 1, 0}, {0.4996, 0, 0}, {0, 0, 1})}),
              (Census{0, 2, 10, 0}));
}

TEST(CoincidentEdges, ASurfaceMeetsItself)
{
    // A closed strip: two spans round a ring of straight sides.
    const KnotVector round = clampedIntegerKnots(1, 3);
    const NurbsSurface strip =
        surfaceOf(round, KnotVector::clampedUniform(1, 1), [](int i, int j) -> ControlPoint {
            const Vec3 ring[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
            return {ring[i] + Vec3(0, 0, j), 1};
        });
    EXPECT_EQ(censusOf({strip}), (Census{2, 0, 6, 0}));
}

TEST(CoincidentEdges, PartsOfRandomSurfacesMeetAlongTheirCut)
{
    std::mt19937 random(3);
    for (int trial = 0; trial < 60; ++trial) {
        RandomSurfaceShape shape;
        shape.degreeU = 1 + trial % 5;
        shape.degreeV = 1 + trial / 5 % 4;
        shape.rational = trial % 2 == 0;
        shape.clamped = trial % 3 != 0;
        const NurbsSurface whole = randomSurface(random, shape);
        const KnotVector& u = whole.knotsU();
        const double cut = randomBetween(random, u.domainStart() + 0.1 * (u.domainEnd() - u.domainStart()),
                                         u.domainEnd() - 0.1 * (u.domainEnd() - u.domainStart()));
        const NurbsSurface first = clampedPart(whole, Direction::U, u.domainStart(), cut);
        NurbsSurface second = clampedPart(whole, Direction::U, cut, u.domainEnd());
        if (trial % 4 == 1)
            second = reversedU(second);
        if (trial % 4 == 2)
            second = exchanged(second);
        if (trial % 4 == 3)
            second = exchanged(elevatedU(exchanged(second)));
        EXPECT_EQ(censusOf({first, second}).whole, 2 * static_cast<int>(whole.knotsV().spans().size()))
            << trial;
    }
}

bool isSame(const CoincidentEdges& a, const CoincidentEdges& b)
{
    for (std::uint32_t side = 0; side < a.sideCount(); ++side) {
        const CoincidentEdge* const edgeA = a.edgeAlong(side);
        const CoincidentEdge* const edgeB = b.edgeAlong(side);
        if (a.isCollapsed(side) != b.isCollapsed(side) || (edgeA == nullptr) != (edgeB == nullptr) ||
            (edgeA != nullptr && !(*edgeA == *edgeB)))
            return false;
    }
    for (std::uint32_t corner = 0; corner < a.corners().count(); ++corner)
        if (a.corners().ownerOf(corner) != b.corners().ownerOf(corner))
            return false;
    return true;
}

TEST(CoincidentEdges, AnUpdateEqualsMakingAllAnew)
{
    const Scene knot = makeKnot();
    std::vector<PlacedSurface> surfaces = placed(knot);
    CoincidentEdges edges(surfaces);
    std::vector<NurbsSurface> moved;
    moved.reserve(16);
    std::mt19937 random(4);
    for (int trial = 0; trial < 8; ++trial) {
        const std::uint32_t index = random() % 600;
        std::vector<ControlPoint> points = surfaces[index].surface->controlPoints();
        const bool inner = trial % 4 == 3;
        points[inner ? 27 : random() % 8].position += Vec3(0.01, 0, 0.02);
        moved.push_back(*NurbsSurface::create(surfaces[index].surface->knotsU(),
                                              surfaces[index].surface->knotsV(), points));
        surfaces[index].surface = &moved.back();
        EXPECT_NE(edges.update({{index, surfaces[index]}}), inner);
        ASSERT_TRUE(isSame(edges, CoincidentEdges(surfaces))) << trial;
    }
    const PlacedSurface original = placed(knot)[7];
    surfaces[7].transform = glm::translate(Mat4(1.0), Vec3(0.5, 0, 0));
    edges.update({{7, surfaces[7]}});
    EXPECT_EQ(edges.edgeAlong(edges.numbers()[7].firstBorder), nullptr);
    ASSERT_TRUE(isSame(edges, CoincidentEdges(surfaces)));
    surfaces[7] = original;
    edges.update({{7, original}});
    EXPECT_NE(edges.edgeAlong(edges.numbers()[7].firstBorder), nullptr);
    ASSERT_TRUE(isSame(edges, CoincidentEdges(surfaces)));
}

TEST(CoincidentEdges, ALargeModelTakesWellUnderASecond)
{
    const Scene knot = makeKnot();
    const auto surfaces = placed(knot);
    const auto start = std::chrono::steady_clock::now();
    const CoincidentEdges edges(surfaces);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    RecordProperty("milliseconds", static_cast<int>(taken.count() * 1e3));
    EXPECT_LT(taken.count(), 5.0);  // with room for sanitizers: 0.05 s in release
}

}  // namespace
}  // namespace knotspan::testing
