// The vertices of a welded mesh: where KSQuads or surfaces meet, all of them use the same ones.
//
// An edge has as many cells as the most that anyone along it asks for; borders that coincide in parts are cut
// into pieces (CoincidentEdges), each with its own count. A vertex is a point of its owner alone; those on
// the border of others are up to gap() from those others' own points.
#pragma once

#include "model/analysis/coincident_edges.h"
#include "model/analysis/screen_error.h"
#include "model/geometry/span_parameter.h"

namespace knotspan {

class MeshVertices {
public:
    struct OnSide {
        std::uint32_t vertex = 0;
        double t = 0;  // along the KSQuad's side
    };

    // `grids`: what each KSQuad asks for; a few are made finer where the mesh would be folded onto itself.
    // Keeps references to surfaces and edges.
    MeshVertices(const std::vector<PlacedSurface>& surfaces, const CoincidentEdges& edges,
                 std::vector<Grid> grids);

    [[nodiscard]] size_t count() const { return count_; }
    // Computes where they are. May only be called where count() fits into 32 bits.
    void evaluate();
    [[nodiscard]] std::vector<Vec3> takePositions() { return std::move(positions_); }
    // How far a surface's own points may be from the vertices on its border that others own.
    [[nodiscard]] double gap(std::uint32_t surface) const { return gaps_[surface]; }

    [[nodiscard]] const Grid& grid(std::uint32_t ksquad) const { return grids_[ksquad]; }
    // Of a KSQuad (a, b): along the side, t increasing from 0 to 1. A side that is one point has that as
    // often as the grid's has vertices.
    void side(std::uint32_t surface, std::uint32_t a, std::uint32_t b, Side side,
              std::vector<OnSide>& points) const;
    // Vertex (i, j) inside the grid, 0 < i < grid.u, is number inside(ksquad) + (i - 1) (grid.v - 1) + j - 1.
    [[nodiscard]] std::uint32_t inside(std::uint32_t ksquad) const
    {
        return static_cast<std::uint32_t>(insides_[ksquad]);
    }

    // Two surfaces, or twice one, along a piece of an edge that has exactly two sides.
    struct Seam {
        std::uint32_t surface = 0;
        std::uint32_t other = 0;
        bool agree = false;  // what is counter-clockwise in both (u, v) is turned one way
    };
    [[nodiscard]] std::vector<Seam> seams() const;

private:
    struct Line {
        size_t first = 0;  // the vertices between its ends
        int cells = 1;
    };
    struct Piece {
        Line line;
        size_t start = 0;  // the vertices at its ends, by the edge's parameter
        size_t end = 0;
        std::uint32_t owner = 0;  // of the edge's members
    };
    // Points of one surface to be evaluated for vertices, or to be compared with them.
    struct Scattered {
        std::vector<SpanParameter> u;
        std::vector<SpanParameter> v;
        std::vector<size_t> vertices;
    };
    // Per surface: all lines inside it.
    struct Inside {
        std::vector<Line> acrossU;  // between KSQuads (a, b) and (a + 1, b): a spansV + b
        std::vector<Line> acrossV;  // between (a, b) and (a, b + 1): a (spansV - 1) + b
        size_t corners = 0;         // (i, j), 0 < i < spansU: (i - 1) (spansV - 1) + j - 1
    };
    class Folds;

    void placeCorners();
    void placeBorders(Folds& folds);
    void placeEdge(const CoincidentEdge& edge, Folds& folds);
    void placeInsides(Folds& folds);
    void placeQuads(Folds& folds);

    [[nodiscard]] SpanParameter along(const KnotVector& knots, std::uint32_t lattice) const;
    // The parameters at t along a border side.
    void addOnSide(std::uint32_t side, double t, size_t vertex, std::vector<Scattered>& to);
    [[nodiscard]] int askedBySide(std::uint32_t side) const;
    [[nodiscard]] size_t latticeVertex(std::uint32_t surface, std::uint32_t i, std::uint32_t j) const;
    void evaluateInsides(std::uint32_t surface);
    void mergePoints();

    const std::vector<PlacedSurface>& surfaces_;
    const CoincidentEdges& edges_;
    std::vector<Grid> grids_;
    std::vector<std::uint32_t> surfaceOfSide_;
    size_t count_ = 0;
    std::vector<size_t> corners_;             // by border corner
    std::vector<Line> sides_;                 // by border side, where nobody else is
    std::vector<std::vector<Piece>> pieces_;  // of an edge, by its first member's side
    std::vector<Inside> lines_;               // by surface
    std::vector<size_t> insides_;             // by KSQuad
    std::vector<Scattered> points_;           // by surface
    std::vector<Scattered> others_;           // vertices that are somebody else's points
    std::vector<Vec3> positions_;
    std::vector<double> gaps_;
    std::vector<std::uint32_t> mergedInto_;  // empty where no line inside is one point
};

}  // namespace knotspan
