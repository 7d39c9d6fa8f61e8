#include "model/analysis/curvature_comb.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "model/geometry/grid_evaluation.h"
#include "model/trimming/trim_region.h"

namespace knotspan {

namespace {

std::vector<double> spreadOver(const KnotVector& knots, int count)
{
    std::vector<double> places;
    for (int k = 0; k < count; ++k) {
        const double part = count == 1 ? 0.5 : double(k) / (count - 1);
        places.push_back(knots.domainStart() + (knots.domainEnd() - knots.domainStart()) * part);
    }
    return places;
}

// Of a curve with these first and second derivatives.
Vec3 curvatureVector(const Vec3& first, const Vec3& second)
{
    const double speed = std::hypot(first.x, first.y, first.z);
    if (!(speed > 0))
        return Vec3(0);
    const Vec3 tangent = first / speed;
    const Vec3 bend = second / speed / speed;
    const Vec3 across = bend - glm::dot(bend, tangent) * tangent;
    return std::isfinite(glm::dot(across, across)) ? across : Vec3(0);
}

// The curves where `across` stands still at each of the places.
void addCombs(const GridEvaluator<double>& evaluator, const NurbsSurface& surface, const Mat4& transform,
              Direction across, const std::vector<double>& places, int cells, std::vector<IsoComb>& to)
{
    const bool isU = across == Direction::U;
    const std::vector<SpanParameter> still =
        spanParameters(isU ? surface.knotsU() : surface.knotsV(), places);
    const std::vector<SpanParameter> along =
        parametersPerSpan(isU ? surface.knotsV() : surface.knotsU(), cells);
    GridSamples<double> samples;
    evaluator.evaluate(isU ? still : along, isU ? along : still, samples);
    const glm::dmat3 linear(transform);
    for (size_t k = 0; k < places.size(); ++k) {
        IsoComb comb{across, places[k], {}};
        comb.teeth.reserve(along.size());
        for (size_t t = 0; t < along.size(); ++t) {
            const int row = static_cast<int>(isU ? k : t);
            const int column = static_cast<int>(isU ? t : k);
            const Vec3 first = linear * (isU ? samples.dv(row, column) : samples.du(row, column));
            const Vec3 second = linear * (isU ? samples.dvv(row, column) : samples.duu(row, column));
            comb.teeth.push_back({transformed(samples.origin() + samples.position(row, column), transform),
                                  curvatureVector(first, second)});
        }
        to.push_back(std::move(comb));
    }
}

double parameterOf(const KnotVector& knots, const SpanParameter& at)
{
    return std::lerp(knots[at.span], knots[at.span + 1], at.t);
}

// The parts of a comb whose teeth stand in the region.
void addParts(IsoComb&& comb, const NurbsSurface& surface, const TrimRegion& region, int cells,
              std::vector<IsoComb>& to)
{
    const bool isU = comb.across == Direction::U;
    const KnotVector& along = isU ? surface.knotsV() : surface.knotsU();
    const std::vector<SpanParameter> places = parametersPerSpan(along, cells);
    IsoComb part{comb.across, comb.parameter, {}};
    const auto end = [&] {
        if (part.teeth.size() > 1)
            to.push_back(part);
        part.teeth.clear();
    };
    for (size_t k = 0; k < places.size(); ++k) {
        const double at = parameterOf(along, places[k]);
        if (isU ? region.contains(comb.parameter, at) : region.contains(at, comb.parameter))
            part.teeth.push_back(comb.teeth[k]);
        else
            end();
    }
    end();
}

}  // namespace

std::vector<IsoComb> isoCombs(const NurbsSurface& surface, const Mat4& transform, int count, int cells,
                              const std::vector<TrimLoop>& loops)
{
    std::vector<IsoComb> combs;
    if (count < 1 || cells < 1)
        return combs;
    const GridEvaluator<double> evaluator(surface, {.derivatives = 2});
    addCombs(evaluator, surface, transform, Direction::U, spreadOver(surface.knotsU(), count), cells, combs);
    addCombs(evaluator, surface, transform, Direction::V, spreadOver(surface.knotsV(), count), cells, combs);
    const TrimRegion region(loops, surface);
    if (loops.empty() || !region.isTrimmed())
        return combs;
    std::vector<IsoComb> parts;
    for (IsoComb& comb : combs)
        addParts(std::move(comb), surface, region, cells, parts);
    return parts;
}

double curvatureOfMost(const std::vector<IsoComb>& combs, double part)
{
    std::vector<double> squares;
    for (const IsoComb& comb : combs)
        for (const CombTooth& tooth : comb.teeth)
            if (tooth.curvature != Vec3(0))
                squares.push_back(glm::dot(tooth.curvature, tooth.curvature));
    if (squares.empty())
        return 0;
    const auto at = squares.begin() + static_cast<std::ptrdiff_t>(part * double(squares.size() - 1));
    std::nth_element(squares.begin(), at, squares.end());
    return std::sqrt(*at);
}

}  // namespace knotspan
