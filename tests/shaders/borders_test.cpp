// The text by which the shaders choose vertices along edges, compiled as C++, over the tables of real
// surfaces and random demands.
#include <array>
#include <map>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/samples/samples.h"
#include "shaders/shared/ring.glsl"
#include "tests/joined_surfaces.h"
#include "tests/shaders/border_model.h"

namespace knotspan::testing {
namespace {

template <class Check>
void forAllModels(const Check& look)
{
    for (auto make : {makeSingle100, makeNine16, makeTorus, makeSphere, makeHull}) {
        const Scene scene = make();
        Model model(placed(scene));
        look(scene.objects().begin()->second->name, model);
    }
    for (const Joined& joined : joinedSurfaces()) {
        Model model(placed(joined.surfaces));
        look(joined.name, model);
    }
}

using Line = std::vector<gpu::GridVertex>;

bool isSamePoint(const gpu::GridVertex& a, const gpu::GridVertex& b)
{
    return a.source == b.source && a.sourceT == b.sourceT;
}

// The vertices of the ring's chains that lie along one side, each once.
Line ringAlong(const Model& model, std::uint32_t ksquad, const gpu::DrawnGrid& grid, std::uint32_t side)
{
    Line found;
    const bool alongV = side < SIDE_START_V;
    const float across = (side & 1U) == 0 ? 0 : 1;
    for (const bool outer : {true, false})
        for (std::uint32_t k = 0; k <= (outer ? gpu::outerSteps(grid) : gpu::innerSteps(grid)); ++k) {
            const auto vertex = gpu::chainVertex(model.source, ksquad, grid, outer, k);
            if ((alongV ? vertex.t.x : vertex.t.y) == across)
                found.push_back(vertex);
        }
    const auto along = [&](const gpu::GridVertex& vertex) { return alongV ? vertex.t.y : vertex.t.x; };
    std::stable_sort(found.begin(), found.end(),
                     [&](const auto& a, const auto& b) { return along(a) < along(b); });
    found.erase(std::unique(found.begin(), found.end(), isSamePoint), found.end());
    return found;
}

// The border vertices of a drawn grid along one side, each once.
Line drawnAlong(const Model& model, std::uint32_t ksquad, std::uint32_t side, std::uint32_t snap)
{
    const auto grid = gpu::drawnGrid(model.source, ksquad, snap);
    if (snap == SNAP_RING)
        return ringAlong(model, ksquad, grid, side);
    const bool alongV = side < SIDE_START_V;
    const std::uint32_t across = (side & 1U) == 0 ? 0 : (alongV ? grid.u : grid.v);
    Line line;
    for (std::uint32_t k = 0; k <= (alongV ? grid.v : grid.u); ++k) {
        const auto vertex = alongV ? gpu::gridVertex(model.source, ksquad, grid, across, k, snap)
                                   : gpu::gridVertex(model.source, ksquad, grid, k, across, snap);
        if (line.empty() || !isSamePoint(line.back(), vertex))
            line.push_back(vertex);
    }
    return line;
}

void expectSame(const Line& a, Line b, bool reversed)
{
    if (reversed)
        std::reverse(b.begin(), b.end());
    ASSERT_EQ(a.size(), b.size());
    for (size_t k = 0; k < a.size(); ++k)
        ASSERT_TRUE(isSamePoint(a[k], b[k])) << "vertex " << k << " of " << a.size();
}

// Pieces by whose points they are and where; each line from the owner's lower t on.
using Pieces = std::map<std::array<float, 3>, std::vector<Line>>;

void cutIntoPieces(const Model& model, const gpu::BorderSide& border, const Line& line, Pieces& pieces)
{
    size_t first = 0;
    const std::uint32_t count = border.flags >> BORDER_COUNT_SHIFT;
    for (std::uint32_t k = 0; k < count; ++k) {
        const gpu::BorderPiece piece = model.source.borderPiece(border.other + k);
        const bool isLast = k + 1 == count;
        size_t last = line.size() - 1;
        if (!isLast) {
            const std::uint32_t corner = model.source.borderPiece(border.other + k + 1).corner;
            for (last = first + 1; last < line.size(); ++last)
                if (line[last].source == corner / 4 &&
                    line[last].sourceT == gpu::cornerParameters(corner & 3U))
                    break;
            ASSERT_LT(last, line.size()) << "the line goes through the corner between its pieces";
        }
        Line part(line.begin() + static_cast<std::ptrdiff_t>(first),
                  line.begin() + static_cast<std::ptrdiff_t>(last) + 1);
        if (piece.ownerStart > piece.ownerEnd)
            std::reverse(part.begin(), part.end());
        pieces[{static_cast<float>(piece.owner), std::min(piece.ownerStart, piece.ownerEnd),
                std::max(piece.ownerStart, piece.ownerEnd)}]
            .push_back(std::move(part));
        first = last;
    }
}

void lookAtEdges(const Model& model, std::uint32_t snap)
{
    Pieces pieces;
    for (std::uint32_t ksquad = 0; ksquad < model.source.ksquads.size(); ++ksquad)
        for (std::uint32_t side = 0; side < 4; ++side) {
            SCOPED_TRACE("KSQuad " + std::to_string(ksquad) + " side " + std::to_string(side));
            const Line line = drawnAlong(model, ksquad, side, snap);
            for (const auto& vertex : line)
                ASSERT_LT(glm::distance(model.pointAt(ksquad, vertex.t),
                                        model.pointAt(vertex.source, vertex.sourceT)),
                          1e-5);
            const auto place = gpu::placeOf(model.source, ksquad);
            const std::uint32_t inner = gpu::innerNeighbour(place, ksquad, side);
            if (inner != NO_SIDE) {
                expectSame(line, drawnAlong(model, inner / 4, inner & 3U, snap), false);
                continue;
            }
            const auto border = model.source.borderSide(gpu::borderSideIndex(place, side));
            const std::uint32_t kind = border.flags & BORDER_KIND;
            if (kind == BORDER_WHOLE)
                expectSame(line, drawnAlong(model, border.other / 4, border.other & 3U, snap),
                           (border.flags & BORDER_REVERSED) != 0);
            if (kind == BORDER_COLLAPSED) {
                ASSERT_EQ(line.size(), 1U);
            }
            if (kind == BORDER_PIECES)
                cutIntoPieces(model, border, line, pieces);
        }
    for (const auto& [name, lines] : pieces)
        for (const Line& line : lines)
            expectSame(lines.front(), line, false);
}

TEST(Borders, EdgesHaveTheSameVerticesFromAllSides)
{
    std::mt19937 random(1);
    forAllModels([&](const std::string& name, Model& model) {
        for (int trial = 0; trial < 12; ++trial)
            for (const std::uint32_t snap : {SNAP_FALLING, SNAP_NEAREST, SNAP_RING}) {
                SCOPED_TRACE(name + ", trial " + std::to_string(trial) + ", snap " + std::to_string(snap));
                ask(model, random, trial % 2 == 0, trial < 6 ? 5 : 40);
                ASSERT_NO_FATAL_FAILURE(lookAtEdges(model, snap));
            }
    });
}

struct Triangles {
    size_t count = 0;
    double area = 0;
    double least = 1;     // signed area of one
    glm::dvec2 box{0.0};  // the widest and the tallest
};

void add(Triangles& triangles, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    const double area = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    triangles.area += area;
    triangles.least = std::min(triangles.least, area);
    if (std::abs(area) > 1e-12)
        triangles.box = glm::max(triangles.box, glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c)));
}

// The inside and the ring, whose triangles are told in parts.
Triangles ringed(const Model& model, std::uint32_t ksquad, std::uint32_t parts)
{
    const auto grid = gpu::drawnGrid(model.source, ksquad, SNAP_RING);
    Triangles triangles;
    for (std::uint32_t i = 1; i + 1 < grid.u; ++i)
        for (std::uint32_t j = 1; j + 1 < grid.v; ++j) {
            const auto at = [&](std::uint32_t a, std::uint32_t b) {
                return glm::dvec2(gpu::insideVertex(ksquad, grid, a, b).t);
            };
            add(triangles, at(i, j), at(i + 1, j), at(i, j + 1));
            add(triangles, at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
    const auto at = [&](bool outer, std::uint32_t k) {
        return glm::dvec2(gpu::chainVertex(model.source, ksquad, grid, outer, k).t);
    };
    for (std::uint32_t k = 0; k < parts; ++k) {
        const auto part = gpu::ringPart(model.source, ksquad, grid, parts, k);
        for (std::uint32_t number = 0; number < part.outerSteps + part.innerSteps; ++number) {
            const auto triangle = gpu::ringTriangle(model.source, ksquad, grid, part, number);
            glm::dvec2 b = at(true, triangle.outer + (triangle.stepsOuter ? 1 : 0));
            glm::dvec2 c = at(false, triangle.inner);
            if (!triangle.stepsOuter) {
                b = at(false, triangle.inner + 1);
            }
            if (gpu::runsClockwise(grid))
                std::swap(b, c);
            add(triangles, at(true, triangle.outer), b, c);
            ++triangles.count;
        }
    }
    return triangles;
}

// Of a KSQuad's drawn grid, its cells cut from (1, 0) to (0, 1) or from (0, 0) to (1, 1).
Triangles trianglesOf(const Model& model, std::uint32_t ksquad, std::uint32_t snap, bool falling)
{
    const auto grid = gpu::drawnGrid(model.source, ksquad, snap);
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return glm::dvec2(gpu::gridVertex(model.source, ksquad, grid, i, j, snap).t);
    };
    Triangles triangles;
    for (std::uint32_t i = 0; i < grid.u; ++i)
        for (std::uint32_t j = 0; j < grid.v; ++j)
            if (falling) {
                add(triangles, at(i, j), at(i + 1, j), at(i, j + 1));
                add(triangles, at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            } else {
                add(triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1));
                add(triangles, at(i, j), at(i + 1, j + 1), at(i, j + 1));
            }
    return triangles;
}

// For SNAP_RING `falling` cuts the ring into several parts.
void lookAtTriangles(const Model& model, std::uint32_t snap, bool falling)
{
    for (std::uint32_t ksquad = 0; ksquad < model.source.ksquads.size(); ++ksquad) {
        const gpu::GridRecord asked = model.source.grids[ksquad];
        if (asked.alongU == 0)
            continue;
        SCOPED_TRACE("KSQuad " + std::to_string(ksquad));
        const Triangles triangles = snap == SNAP_RING ? ringed(model, ksquad, falling ? 3 : 1)
                                                      : trianglesOf(model, ksquad, snap, falling);
        ASSERT_NEAR(triangles.area, 1, 1e-5);
        ASSERT_GE(triangles.least, -1e-7);
        // But for the rounding of parameters.
        const auto largest = [](std::uint32_t both) {
            return 1e-6 + 1.0 / std::min(both & 0xffffU, both >> 16U);
        };
        ASSERT_LE(triangles.box.x, largest(asked.alongU));
        ASSERT_LE(triangles.box.y, largest(asked.alongV));
    }
}

TEST(Borders, TrianglesCoverTheirKsQuadOnceAndAreNoLargerThanAsked)
{
    std::mt19937 random(2);
    forAllModels([&](const std::string& name, Model& model) {
        for (int trial = 0; trial < 12; ++trial)
            for (const bool falling : {true, false})
                for (const std::uint32_t snap : {SNAP_FALLING, SNAP_NEAREST, SNAP_RING}) {
                    if (snap == SNAP_FALLING && !falling)
                        continue;
                    SCOPED_TRACE(name + ", trial " + std::to_string(trial) + ", snap " +
                                 std::to_string(snap) + (falling ? ", falling" : ", rising"));
                    ask(model, random, trial % 2 == 0, trial < 6 ? 5 : 40);
                    ASSERT_NO_FATAL_FAILURE(lookAtTriangles(model, snap, falling));
                }
    });
}

// Where edges have as many vertices as the grid asks for, the ring takes no more triangles than cells would.
TEST(Borders, ARingHasATriangleForEachOfItsVerticesButNoMore)
{
    std::mt19937 random(4);
    forAllModels([&](const std::string& name, Model& model) {
        SCOPED_TRACE(name);
        ask(model, random, true, 9);
        for (std::uint32_t ksquad = 0; ksquad < model.source.ksquads.size(); ++ksquad) {
            const auto grid = gpu::drawnGrid(model.source, ksquad, SNAP_RING);
            size_t wanted = 0;
            for (std::uint32_t side = 0; side < 4; ++side)
                wanted += grid.edges[side];
            wanted += gpu::hasInside(grid) ? 2 * (grid.u + grid.v) - 8 : 0;
            wanted -= gpu::hasInside(grid) ? 0 : 2;
            ASSERT_EQ(ringed(model, ksquad, 1).count, wanted) << "KSQuad " << ksquad;
        }
    });
}

TEST(Borders, EdgesCutAtRandomHaveTheSameVerticesFromAllSides)
{
    std::mt19937 random(3);
    for (int trial = 0; trial < 40; ++trial) {
        const Joined joined = randomRows(random);
        Model model(placed(joined.surfaces));
        ASSERT_FALSE(model.edges.tables().pieces.empty());
        for (const std::uint32_t snap : {SNAP_FALLING, SNAP_NEAREST, SNAP_RING}) {
            SCOPED_TRACE("trial " + std::to_string(trial) + ", snap " + std::to_string(snap));
            ask(model, random, trial % 2 == 0, trial % 4 == 0 ? 30 : 4);
            ASSERT_NO_FATAL_FAILURE(lookAtEdges(model, snap));
            ASSERT_NO_FATAL_FAILURE(lookAtTriangles(model, snap, true));
            if (snap != SNAP_FALLING) {
                ASSERT_NO_FATAL_FAILURE(lookAtTriangles(model, snap, false));
            }
        }
    }
}

}  // namespace
}  // namespace knotspan::testing
