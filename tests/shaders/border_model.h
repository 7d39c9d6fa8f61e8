// Several surfaces as edges.glsl and borders.glsl read them, from memory, with what each KSQuad asks for.
#pragma once

#include <random>

#include "model/geometry/evaluation.h"
#include "renderer/scene/patch_table.h"
#include "renderer/scene/shared_edges.h"
#include "shaders/shared/borders.glsl"

namespace knotspan::testing {

struct BorderSource {
    const BorderTables* tables = nullptr;
    std::vector<gpu::SurfaceRecord> surfaces;
    std::vector<gpu::KsQuadRecord> ksquads;
    std::vector<gpu::GridRecord> grids;
    std::vector<double> spanTables;

    [[nodiscard]] const gpu::SurfaceRecord& surface(std::uint32_t k) const { return surfaces.at(k); }
    [[nodiscard]] const gpu::KsQuadRecord& ksquad(std::uint32_t k) const { return ksquads.at(k); }
    [[nodiscard]] double spanTable(std::uint32_t k) const { return spanTables.at(k); }
    [[nodiscard]] const gpu::GridRecord& grid(std::uint32_t k) const { return grids.at(k); }
    [[nodiscard]] const gpu::BorderSide& borderSide(std::uint32_t k) const { return tables->sides.at(k); }
    [[nodiscard]] std::uint32_t borderCorner(std::uint32_t k) const { return tables->corners.at(k); }
    [[nodiscard]] const gpu::BorderPiece& borderPiece(std::uint32_t k) const { return tables->pieces.at(k); }
    [[nodiscard]] const gpu::BorderUse& borderUse(std::uint32_t k) const { return tables->uses.at(k); }
};

struct Model {
    explicit Model(std::vector<PlacedSurface> placedSurfaces)
        : placed(std::move(placedSurfaces)),
          edges(placed)
    {
        source.tables = &edges.tables();
        SpanTablePool<double> pool;
        for (const BorderNumbers& numbers : borderNumbers(placed)) {
            gpu::SurfaceRecord record{};
            record.firstKsquad = numbers.firstKsquad;
            record.spansU = numbers.spansU;
            record.spansV = numbers.spansV;
            record.firstBorder = numbers.firstBorder;
            const NurbsSurface& surface = *placed[source.surfaces.size()].surface;
            record.degreeU = static_cast<std::uint32_t>(surface.degreeU());
            record.degreeV = static_cast<std::uint32_t>(surface.degreeV());
            for (gpu::KsQuadRecord ksquad : makeKsQuadRecords(surface, Evaluator::triangular, pool)) {
                ksquad.surface = static_cast<std::uint32_t>(source.surfaces.size());
                source.ksquads.push_back(ksquad);
            }
            source.surfaces.push_back(record);
        }
        source.spanTables = pool.takeNumbers();
    }
    Model(const Model&) = delete;
    Model& operator=(const Model&) = delete;

    [[nodiscard]] Vec3 pointAt(std::uint32_t ksquad, const gpu::vec2& t) const
    {
        const auto place = gpu::placeOf(source, ksquad);
        const NurbsSurface& surface = surfaceOf(ksquad);
        const auto at = [](const KnotVector& knots, std::uint32_t span, double x) {
            const int k = knots.spans()[span];
            return knots[k] + x * (knots[k + 1] - knots[k]);
        };
        return evaluate(surface, at(surface.knotsU(), place.a, t.x), at(surface.knotsV(), place.b, t.y))
            .position;
    }

    [[nodiscard]] const NurbsSurface& surfaceOf(std::uint32_t ksquad) const
    {
        return *placed[source.ksquads[ksquad].surface].surface;
    }

    std::vector<PlacedSurface> placed;
    SharedEdges edges;
    BorderSource source;
};

// Asked alike on opposite sides, as the bound does, or differently; some KSQuads are not drawn.
inline void ask(Model& model, std::mt19937& random, bool alike, std::uint32_t most)
{
    std::uniform_int_distribution<std::uint32_t> cells(1, most);
    model.source.grids.clear();
    for (size_t k = 0; k < model.source.ksquads.size(); ++k) {
        const std::uint32_t u = cells(random);
        const std::uint32_t v = cells(random);
        gpu::GridRecord grid =
            alike ? gpu::gridRecord(v, v, u, u) : gpu::gridRecord(v, cells(random), u, cells(random));
        if (random() % 8 == 0)
            grid = {};
        model.source.grids.push_back(grid);
    }
}

}  // namespace knotspan::testing
