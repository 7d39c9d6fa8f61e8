#include "renderer/scene/uniform_grids.h"

#include <algorithm>

#include "model/geometry/grid_evaluation.h"

namespace knotspan {

namespace {

// A parameter, and where it lies among the surface's spans.
struct Places {
    std::vector<SpanParameter> parameters;
    std::vector<std::uint32_t> spans;  // counted from 0
};

Places evenPlaces(const KnotVector& knots, std::uint32_t cells)
{
    const double start = knots[knots.spans().front()];
    const double end = knots[knots.spans().back() + 1];
    std::vector<double> values;
    for (std::uint32_t k = 0; k < cells; ++k)
        values.push_back(start + (end - start) * k / cells);
    values.push_back(end);
    Places places{spanParameters(knots, values), {}};
    const auto& spans = knots.spans();
    for (const SpanParameter& parameter : places.parameters)
        places.spans.push_back(static_cast<std::uint32_t>(
            std::lower_bound(spans.begin(), spans.end(), parameter.span) - spans.begin()));
    return places;
}

// Of the surface where its control points are those that `resident` was packed with, and drawn from its
// origin.
void makeVertices(const Resident& resident, std::uint32_t number, std::uint32_t cells,
                  gpu::ObjectVertex* vertex)
{
    const NurbsSurface& surface = resident.object->surface;
    const Places u = evenPlaces(surface.knotsU(), cells);
    const Places v = evenPlaces(surface.knotsV(), cells);
    GridSamples<float> samples;
    GridEvaluator<float>(surface, {.normals = true}).evaluate(u.parameters, v.parameters, samples);
    const Vec3 offset = samples.origin() - resident.frame.origin;
    const auto spansV = static_cast<std::uint32_t>(surface.knotsV().spans().size());
    for (std::uint32_t i = 0; i <= cells; ++i)
        for (std::uint32_t j = 0; j <= cells; ++j, ++vertex) {
            const int row = static_cast<int>(i);
            const int column = static_cast<int>(j);
            vertex->position = gpu::vec3(Vec3(samples.position(row, column)) + offset);
            vertex->normal = samples.normal(row, column);
            vertex->t = {static_cast<float>(u.spans[i] + u.parameters[i].t),
                         static_cast<float>(v.spans[j] + v.parameters[j].t)};
            vertex->ksquad = number + u.spans[i] * spansV + v.spans[j];
            vertex->source = vertex->ksquad;
            vertex->weight = 1.0F;  // cells lie across KSQuads: no interpolation is the right one
        }
}

bool isAsMade(const Resident& made, const Resident& wanted)
{
    return made.object == wanted.object && made.firstKsquad == wanted.firstKsquad &&
           made.frame.origin == wanted.frame.origin;
}

}  // namespace

std::uint64_t UniformGrids::update(const std::vector<Resident>& residents, std::uint32_t cells)
{
    for (size_t k = residents.size(); k < grids_.size(); ++k)
        store_.place(grids_[k], 0, 0);
    grids_.resize(residents.size());
    made_.resize(residents.size());
    std::uint64_t evaluations = 0;
    for (size_t k = 0; k < residents.size(); ++k) {
        const bool fits = grids_[k].u == cells;
        if (fits && isAsMade(made_[k], residents[k]))
            continue;
        if (!fits)
            store_.place(grids_[k], cells, cells);
        made_[k] = residents[k];
        makeVertices(residents[k], residents[k].firstKsquad, cells, store_.at(grids_[k]));
        store_.changed(grids_[k]);
        evaluations += grids_[k].vertexCount();
    }
    store_.compact(grids_);
    return evaluations;
}

}  // namespace knotspan
