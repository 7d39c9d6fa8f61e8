// MeshVertices: where the vertices are, which of them are one point, and who meets along their lines.
#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/geometry/grid_evaluation.h"
#include "model/mesh/mesh_vertices.h"

namespace knotspan {

void MeshVertices::evaluate()
{
    check(count_ <= UINT32_MAX, "vertices are numbered in 32 bits");
    positions_.resize(count_);
    gaps_.assign(surfaces_.size(), 0.0);
    for (std::uint32_t s = 0; s < surfaces_.size(); ++s)
        evaluateInsides(s);
    for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
        const Scattered& others = others_[s];
        if (others.vertices.empty())
            continue;
        const GridEvaluator<double> evaluator(*surfaces_[s].surface, {});
        GridSamples<double> samples;
        evaluator.evaluateScattered(others.u, others.v, samples, Threads::one);
        for (size_t k = 0; k < others.vertices.size(); ++k) {
            const Vec3 own = transformed(samples.origin() + samples.position(0, static_cast<int>(k)),
                                         surfaces_[s].transform);
            gaps_[s] = std::max(gaps_[s], glm::distance(own, positions_[others.vertices[k]]));
        }
    }
    mergePoints();
}

void MeshVertices::evaluateInsides(std::uint32_t s)
{
    const NurbsSurface& surface = *surfaces_[s].surface;
    const Mat4& transform = surfaces_[s].transform;
    const bool stays = transform == Mat4(1.0);
    const GridEvaluator<double> evaluator(surface, {});
    GridSamples<double> samples;
    const auto place = [&](size_t vertex, int row, int column) {
        const Vec3 position = samples.origin() + samples.position(row, column);
        positions_[vertex] = stays ? position : transformed(position, transform);
    };
    Scattered& points = points_[s];
    evaluator.evaluateScattered(points.u, points.v, samples, Threads::one);
    for (size_t k = 0; k < points.vertices.size(); ++k)
        place(points.vertices[k], 0, static_cast<int>(k));
    points = {};
    std::uint32_t ksquad = edges_.numbers()[s].firstKsquad;
    std::vector<SpanParameter> u;
    std::vector<SpanParameter> v;
    for (const KsQuad& quad : ksQuads(surface)) {
        const Grid& grid = grids_[ksquad];
        size_t vertex = insides_[ksquad++];
        if (grid.u < 2 || grid.v < 2)
            continue;
        u.clear();
        v.clear();
        for (int i = 1; i < grid.u; ++i)
            u.push_back({quad.spanU, double(i) / grid.u});
        for (int j = 1; j < grid.v; ++j)
            v.push_back({quad.spanV, double(j) / grid.v});
        evaluator.evaluate(u, v, samples, Threads::one);
        for (int i = 0; i + 1 < grid.u; ++i)
            for (int j = 0; j + 1 < grid.v; ++j)
                place(vertex++, i, j);
    }
}

// Lines inside a surface that are one point: all their vertices become one.
void MeshVertices::mergePoints()
{
    const auto find = [&](std::uint32_t vertex) {
        while (mergedInto_[vertex] != vertex)
            vertex = mergedInto_[vertex] = mergedInto_[mergedInto_[vertex]];
        return vertex;
    };
    const auto look = [&](const Line& line, size_t start, size_t end, double size) {
        const Vec3 at = positions_[start];
        if (start == end || glm::distance(positions_[end], at) > 1e-12 * size)
            return;
        for (int k = 1; k < line.cells; ++k)
            if (glm::distance(positions_[line.first + static_cast<size_t>(k) - 1], at) > 1e-12 * size)
                return;
        if (mergedInto_.empty()) {
            mergedInto_.resize(count_);
            std::iota(mergedInto_.begin(), mergedInto_.end(), 0U);
        }
        const std::uint32_t into = find(static_cast<std::uint32_t>(start));
        mergedInto_[find(static_cast<std::uint32_t>(end))] = into;
        for (int k = 1; k < line.cells; ++k)
            mergedInto_[line.first + static_cast<size_t>(k) - 1] = into;
    };
    for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
        const BorderNumbers& numbers = edges_.numbers()[s];
        const double size = transformed(surfaces_[s].surface->bounds(), surfaces_[s].transform).diagonal();
        for (std::uint32_t a = 0; a < numbers.spansU; ++a)
            for (std::uint32_t b = 0; b < numbers.spansV; ++b) {
                if (a + 1 < numbers.spansU)
                    look(lines_[s].acrossU[size_t{a} * numbers.spansV + b], latticeVertex(s, a + 1, b),
                         latticeVertex(s, a + 1, b + 1), size);
                if (b + 1 < numbers.spansV)
                    look(lines_[s].acrossV[size_t{a} * (numbers.spansV - 1) + b], latticeVertex(s, a, b + 1),
                         latticeVertex(s, a + 1, b + 1), size);
            }
    }
    for (size_t k = 0; k < mergedInto_.size(); ++k)
        mergedInto_[k] = find(static_cast<std::uint32_t>(k));
}

std::vector<MeshVertices::Seam> MeshVertices::seams() const
{
    // Whether a side, along its parameter, runs counter-clockwise round its surface's (u, v).
    const auto runsRound = [&](std::uint32_t side) {
        const BorderNumbers& numbers = edges_.numbers()[surfaceOfSide_[side]];
        const std::uint32_t name = numbers.sideName(side - numbers.firstBorder) % 4;
        return name == 1 || name == 2;
    };
    std::vector<Seam> seams;
    for (std::uint32_t side = 0; side < edges_.sideCount(); ++side) {
        const CoincidentEdge* const edge = edges_.edgeAlong(side);
        if (edge == nullptr || edge->members.front().side != side)
            continue;
        for (size_t k = 0; k + 1 < edge->cuts.size(); ++k) {
            std::vector<const EdgeMember*> along;
            for (const EdgeMember& member : edge->members)
                if (member.covers(edge->cuts[k].at, edge->cuts[k + 1].at))
                    along.push_back(&member);
            if (along.size() != 2)
                continue;
            const auto forwards = [&](const EdgeMember& member) {
                return runsRound(member.side) == (member.start < member.end);
            };
            seams.push_back({surfaceOfSide_[along[0]->side], surfaceOfSide_[along[1]->side],
                             forwards(*along[0]) != forwards(*along[1])});
        }
    }
    return seams;
}

}  // namespace knotspan
