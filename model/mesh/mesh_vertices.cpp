#include "model/mesh/mesh_vertices.h"

#include <cmath>
#include <unordered_set>

namespace knotspan {

// Two edges between the same vertices would become one, and a mesh folded onto itself.
class MeshVertices::Folds {
public:
    // Cells of an edge between two vertices that is no point.
    [[nodiscard]] int unfolded(int cells, size_t start, size_t end)
    {
        if (start == end)
            return std::max(cells, 3);
        return cells == 1 && !isFirst(start, end) ? 2 : cells;
    }
    [[nodiscard]] bool isFirst(size_t start, size_t end)
    {
        return taken_.insert(std::uint64_t{std::min(start, end)} << 32U | std::max(start, end)).second;
    }

private:
    std::unordered_set<std::uint64_t> taken_;
};

MeshVertices::MeshVertices(const std::vector<PlacedSurface>& surfaces, const CoincidentEdges& edges,
                           std::vector<Grid> grids)
    : surfaces_(surfaces),
      edges_(edges),
      grids_(std::move(grids)),
      sides_(edges.sideCount()),
      pieces_(edges.sideCount()),
      lines_(surfaces.size()),
      insides_(grids_.size()),
      points_(surfaces.size()),
      others_(surfaces.size())
{
    for (std::uint32_t s = 0; s < surfaces.size(); ++s)
        surfaceOfSide_.insert(surfaceOfSide_.end(), edges.numbers()[s].borderCount(), s);
    Folds folds;
    placeCorners();
    placeBorders(folds);
    placeInsides(folds);
    placeQuads(folds);
}

SpanParameter MeshVertices::along(const KnotVector& knots, std::uint32_t lattice) const
{
    const std::vector<int>& spans = knots.spans();
    return lattice < spans.size() ? SpanParameter{spans[lattice], 0} : SpanParameter{spans.back(), 1};
}

void MeshVertices::placeCorners()
{
    corners_.resize(edges_.corners().count());
    const auto forBorder = [&](const auto& visit) {
        for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
            const BorderNumbers& numbers = edges_.numbers()[s];
            for (std::uint32_t i = 0; i <= numbers.spansU; ++i)
                for (std::uint32_t j = 0; j <= numbers.spansV;
                     j += i % numbers.spansU == 0 ? 1 : numbers.spansV)
                    visit(s, i, j, numbers.corner(i, j));
        }
    };
    const auto add = [&](Scattered& to, std::uint32_t s, std::uint32_t i, std::uint32_t j, size_t vertex) {
        to.u.push_back(along(surfaces_[s].surface->knotsU(), i));
        to.v.push_back(along(surfaces_[s].surface->knotsV(), j));
        to.vertices.push_back(vertex);
    };
    forBorder([&](std::uint32_t s, std::uint32_t i, std::uint32_t j, std::uint32_t corner) {
        if (edges_.corners().ownerOf(corner) != corner)
            return;
        corners_[corner] = count_++;
        add(points_[s], s, i, j, corners_[corner]);
    });
    forBorder([&](std::uint32_t s, std::uint32_t i, std::uint32_t j, std::uint32_t corner) {
        const std::uint32_t owner = edges_.corners().ownerOf(corner);
        if (owner == corner)
            return;
        corners_[corner] = corners_[owner];
        add(others_[s], s, i, j, corners_[corner]);
    });
}

int MeshVertices::askedBySide(std::uint32_t side) const
{
    const std::uint32_t surface = surfaceOfSide_[side];
    const BorderNumbers& numbers = edges_.numbers()[surface];
    const std::uint32_t name = numbers.sideName(side - numbers.firstBorder);
    const Grid& grid = grids_[name / 4];
    return name % 4 < 2 ? grid.v : grid.u;
}

void MeshVertices::addOnSide(std::uint32_t side, double t, size_t vertex, std::vector<Scattered>& to)
{
    const std::uint32_t surface = surfaceOfSide_[side];
    const BorderNumbers& numbers = edges_.numbers()[surface];
    const std::uint32_t name = numbers.sideName(side - numbers.firstBorder);
    const std::uint32_t quad = name / 4 - numbers.firstKsquad;
    const double across = name % 2;
    const bool alongV = name % 4 < 2;
    const NurbsSurface& of = *surfaces_[surface].surface;
    to[surface].u.push_back({of.knotsU().spans()[quad / numbers.spansV], alongV ? across : t});
    to[surface].v.push_back({of.knotsV().spans()[quad % numbers.spansV], alongV ? t : across});
    to[surface].vertices.push_back(vertex);
}

void MeshVertices::placeBorders(Folds& folds)
{
    for (std::uint32_t side = 0; side < edges_.sideCount(); ++side) {
        const CoincidentEdge* const edge = edges_.edgeAlong(side);
        if (edge != nullptr) {
            if (edge->members.front().side == side)
                placeEdge(*edge, folds);
            continue;
        }
        const BorderNumbers& numbers = edges_.numbers()[surfaceOfSide_[side]];
        const auto ends = numbers.cornersOf(side - numbers.firstBorder);
        Line& line = sides_[side];
        line.cells = askedBySide(side);
        if (edges_.isCollapsed(side)) {
            for (int k = 1; k < line.cells; ++k)
                addOnSide(side, double(k) / line.cells, corners_[ends[0]], others_);
            continue;
        }
        line.cells = folds.unfolded(line.cells, corners_[ends[0]], corners_[ends[1]]);
        line.first = count_;
        for (int k = 1; k < line.cells; ++k)
            addOnSide(side, double(k) / line.cells, count_++, points_);
    }
}

void MeshVertices::placeEdge(const CoincidentEdge& edge, Folds& folds)
{
    std::vector<Piece>& pieces = pieces_[edge.members.front().side];
    pieces.resize(edge.cuts.size() - 1);
    for (size_t k = 0; k < pieces.size(); ++k) {
        const double low = edge.cuts[k].at;
        const double high = edge.cuts[k + 1].at;
        Piece& piece = pieces[k];
        piece.start = corners_[edge.cuts[k].corner];
        piece.end = corners_[edge.cuts[k + 1].corner];
        piece.owner = static_cast<std::uint32_t>(edge.members.size());
        for (std::uint32_t m = 0; m < edge.members.size(); ++m) {
            const EdgeMember& member = edge.members[m];
            if (!member.covers(low, high))
                continue;
            piece.owner = std::min(piece.owner, m);
            const double share = (high - low) / std::abs(member.end - member.start);
            const double asked = std::ceil(share * askedBySide(member.side) * (1 - 1e-12));
            piece.line.cells = std::max(piece.line.cells, static_cast<int>(asked));
        }
        if (piece.owner == edge.members.size())
            continue;  // a gap between members
        piece.line.cells = folds.unfolded(piece.line.cells, piece.start, piece.end);
        piece.line.first = count_;
        for (int step = 1; step < piece.line.cells; ++step) {
            const double at = low + (high - low) * (double(step) / piece.line.cells);
            for (std::uint32_t m = 0; m < edge.members.size(); ++m) {
                const EdgeMember& member = edge.members[m];
                if (!member.covers(low, high))
                    continue;
                const double t = std::clamp((at - member.start) / (member.end - member.start), 0.0, 1.0);
                addOnSide(member.side, t, count_, m == piece.owner ? points_ : others_);
            }
            ++count_;
        }
    }
}

size_t MeshVertices::latticeVertex(std::uint32_t surface, std::uint32_t i, std::uint32_t j) const
{
    const BorderNumbers& numbers = edges_.numbers()[surface];
    if (i > 0 && i < numbers.spansU && j > 0 && j < numbers.spansV)
        return lines_[surface].corners + size_t{i - 1} * (numbers.spansV - 1) + j - 1;
    return corners_[numbers.corner(i, j)];
}

void MeshVertices::placeInsides(Folds& folds)
{
    for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
        const BorderNumbers& numbers = edges_.numbers()[s];
        const std::uint32_t m = numbers.spansU;
        const std::uint32_t n = numbers.spansV;
        const std::vector<int>& spansU = surfaces_[s].surface->knotsU().spans();
        const std::vector<int>& spansV = surfaces_[s].surface->knotsV().spans();
        Inside& inside = lines_[s];
        Scattered& points = points_[s];
        const auto add = [&](const SpanParameter& u, const SpanParameter& v) {
            points.u.push_back(u);
            points.v.push_back(v);
            points.vertices.push_back(count_++);
        };
        inside.corners = count_;
        for (std::uint32_t i = 1; i < m; ++i)
            for (std::uint32_t j = 1; j < n; ++j)
                add({spansU[i], 0}, {spansV[j], 0});
        const auto quad = [&](std::uint32_t a, std::uint32_t b) { return numbers.firstKsquad + a * n + b; };
        for (std::uint32_t a = 0; a + 1 < m; ++a)
            for (std::uint32_t b = 0; b < n; ++b) {
                const int cells = folds.unfolded(std::max(grids_[quad(a, b)].v, grids_[quad(a + 1, b)].v),
                                                 latticeVertex(s, a + 1, b), latticeVertex(s, a + 1, b + 1));
                inside.acrossU.push_back({count_, cells});
                for (int k = 1; k < cells; ++k)
                    add({spansU[a], 1}, {spansV[b], double(k) / cells});
            }
        for (std::uint32_t a = 0; a < m; ++a)
            for (std::uint32_t b = 0; b + 1 < n; ++b) {
                const int cells = folds.unfolded(std::max(grids_[quad(a, b)].u, grids_[quad(a, b + 1)].u),
                                                 latticeVertex(s, a, b + 1), latticeVertex(s, a + 1, b + 1));
                inside.acrossV.push_back({count_, cells});
                for (int k = 1; k < cells; ++k)
                    add({spansU[a], double(k) / cells}, {spansV[b], 1});
            }
    }
}

void MeshVertices::placeQuads(Folds& folds)
{
    for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
        const BorderNumbers& numbers = edges_.numbers()[s];
        for (std::uint32_t a = 0; a < numbers.spansU; ++a)
            for (std::uint32_t b = 0; b < numbers.spansV; ++b) {
                const std::uint32_t ksquad = numbers.firstKsquad + a * numbers.spansV + b;
                Grid& grid = grids_[ksquad];
                // The diagonal of a single cell (quad_triangles.h).
                if (grid.cells() == 1 &&
                    !folds.isFirst(latticeVertex(s, a + 1, b), latticeVertex(s, a, b + 1)))
                    grid = {2, 2};
                insides_[ksquad] = count_;
                count_ += size_t(grid.u - 1) * size_t(grid.v - 1);
            }
    }
}

void MeshVertices::side(std::uint32_t surface, std::uint32_t a, std::uint32_t b, Side side,
                        std::vector<OnSide>& points) const
{
    const BorderNumbers& numbers = edges_.numbers()[surface];
    const std::uint32_t m = numbers.spansU;
    const std::uint32_t n = numbers.spansV;
    points.clear();
    const auto add = [&](size_t vertex, double t) {
        const auto number = static_cast<std::uint32_t>(vertex);
        points.push_back({mergedInto_.empty() ? number : mergedInto_[number], t});
    };
    const auto addLine = [&](const Line& line) {
        for (int k = 1; k < line.cells; ++k)
            add(line.first + static_cast<size_t>(k) - 1, double(k) / line.cells);
    };
    const bool alongV = side == Side::startU || side == Side::endU;
    const bool atEnd = side == Side::endU || side == Side::endV;
    const std::uint32_t i = a + (alongV && atEnd ? 1 : 0);
    const std::uint32_t j = b + (!alongV && atEnd ? 1 : 0);
    add(latticeVertex(surface, i, j), 0);
    if (alongV && i > 0 && i < m) {
        addLine(lines_[surface].acrossU[size_t{i - 1} * n + b]);
    } else if (!alongV && j > 0 && j < n) {
        addLine(lines_[surface].acrossV[size_t{a} * (n - 1) + j - 1]);
    } else {
        const std::uint32_t number =
            numbers.firstBorder + (alongV ? (atEnd ? n : 0) + b : 2 * n + (atEnd ? m : 0) + a);
        const CoincidentEdge* const edge = edges_.edgeAlong(number);
        if (edge == nullptr && edges_.isCollapsed(number)) {
            for (int k = 1; k < sides_[number].cells; ++k)
                add(latticeVertex(surface, i, j), double(k) / sides_[number].cells);
        } else if (edge == nullptr) {
            addLine(sides_[number]);
        } else {
            const auto member = std::find_if(edge->members.begin(), edge->members.end(),
                                             [&](const EdgeMember& one) { return one.side == number; });
            const std::vector<Piece>& pieces = pieces_[edge->members.front().side];
            const bool forwards = member->start < member->end;
            for (size_t step = 0; step < pieces.size(); ++step) {
                const size_t k = forwards ? step : pieces.size() - 1 - step;
                const double low = edge->cuts[k].at;
                const double high = edge->cuts[k + 1].at;
                if (!member->covers(low, high))
                    continue;
                const Piece& piece = pieces[k];
                const auto t = [&](double at) {
                    return (at - member->start) / (member->end - member->start);
                };
                for (int c = 1; c <= piece.line.cells; ++c) {
                    const int cell = forwards ? c : piece.line.cells - c;
                    const double at = low + (high - low) * (double(cell) / piece.line.cells);
                    if (c < piece.line.cells)
                        add(piece.line.first + static_cast<size_t>(cell) - 1, t(at));
                    else if (const double end = forwards ? high : low; end != member->end)
                        add(forwards ? piece.end : piece.start, t(end));
                }
            }
        }
    }
    add(latticeVertex(surface, alongV ? i : i + 1, alongV ? j + 1 : j), 1);
}

}  // namespace knotspan
