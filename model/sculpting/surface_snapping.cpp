#include "model/sculpting/surface_snapping.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/grid_evaluation.h"

namespace knotspan {

namespace {

constexpr int kCellsPerSpan = 4;
constexpr size_t kMostStarts = 12;

// Parameters along one direction: the ends of spans, and with `cells` above 1 places between them.
std::vector<double> parametersOf(const KnotVector& knots, int cells)
{
    std::vector<double> result;
    for (const int span : knots.spans())
        for (int k = 0; k < cells; ++k)
            result.push_back(knots[span] + (knots[span + 1] - knots[span]) * k / cells);
    result.push_back(knots.domainEnd());
    return result;
}

// Half the squared distance from the surface to a place, and how it changes with u and v.
struct Nearness {
    Vec3 position{0};
    double value = 0;
    double gu = 0;
    double gv = 0;
    double huu = 0;
    double huv = 0;
    double hvv = 0;
};

Nearness nearnessAt(const SceneObject& object, double u, double v, const Vec3& place)
{
    const SurfacePoint point = evaluate(object.surface, u, v);
    const glm::dmat3 linear(object.transform);
    const Vec3 position = transformed(point.position, object.transform);
    const Vec3 away = position - place;
    const Vec3 du = linear * point.du;
    const Vec3 dv = linear * point.dv;
    return {position,
            0.5 * glm::dot(away, away),
            glm::dot(away, du),
            glm::dot(away, dv),
            glm::dot(du, du) + glm::dot(away, linear * point.duu),
            glm::dot(du, dv) + glm::dot(away, linear * point.duv),
            glm::dot(dv, dv) + glm::dot(away, linear * point.dvv)};
}

// The step of Newton's method where it leads down, otherwise one straight down.
Vec2 stepDown(const Nearness& at, bool freeU, bool freeV)
{
    if (freeU && freeV) {
        const double determinant = at.huu * at.hvv - at.huv * at.huv;
        if (at.huu > 0 && determinant > 1e-14 * at.huu * std::abs(at.hvv))
            return Vec2(at.huv * at.gv - at.hvv * at.gu, at.huv * at.gu - at.huu * at.gv) / determinant;
    }
    const auto alone = [](double slope, double bend) { return bend != 0 ? -slope / std::abs(bend) : 0.0; };
    return {freeU ? alone(at.gu, at.huu) : 0, freeV ? alone(at.gv, at.hvv) : 0};
}

// Whether going down leads out of the domain.
bool isHeld(const KnotVector& knots, double at, double slope)
{
    return (at <= knots.domainStart() && slope > 0) || (at >= knots.domainEnd() && slope < 0);
}

struct Foot {
    double u = 0;
    double v = 0;
    Nearness at;
};

// One step, halved until it leads down; false where none does.
bool improve(const SceneObject& object, const Vec3& place, bool freeU, bool freeV, Foot& foot)
{
    const KnotVector& knotsU = object.surface.knotsU();
    const KnotVector& knotsV = object.surface.knotsV();
    Vec2 step = stepDown(foot.at, freeU && !isHeld(knotsU, foot.u, foot.at.gu),
                         freeV && !isHeld(knotsV, foot.v, foot.at.gv));
    for (int halving = 0; halving < 30; ++halving, step *= 0.5) {
        const double u = knotsU.inDomain(foot.u + step.x);
        const double v = knotsV.inDomain(foot.v + step.y);
        if (u == foot.u && v == foot.v)
            return false;
        const Nearness next = nearnessAt(object, u, v, place);
        if (next.value < foot.at.value) {
            foot = {u, v, next};
            return true;
        }
    }
    return false;
}

void goDown(const SceneObject& object, const Vec3& place, bool freeU, bool freeV, Foot& foot)
{
    for (int round = 0; round < 40 && improve(object, place, freeU, freeV, foot); ++round) {
    }
}

}  // namespace

SurfacePlace nearestFrom(ObjectId id, const SceneObject& object, const KsQuad& ksquad, const Vec3& position)
{
    const KnotVector& knotsU = object.surface.knotsU();
    const KnotVector& knotsV = object.surface.knotsV();
    const auto parameter = [](const KnotVector& knots, int span, int k) {
        return glm::mix(knots[span], knots[span + 1], double(k) / kCellsPerSpan);
    };
    std::optional<Foot> foot;
    for (int a = 0; a <= kCellsPerSpan; ++a)
        for (int b = 0; b <= kCellsPerSpan; ++b) {
            const double u = parameter(knotsU, ksquad.spanU, a);
            const double v = parameter(knotsV, ksquad.spanV, b);
            const Nearness at = nearnessAt(object, u, v, position);
            if (!foot || at.value < foot->at.value)
                foot = Foot{u, v, at};
        }
    goDown(object, position, true, true, *foot);
    return {id, foot->u, foot->v, foot->at.position, glm::distance(foot->at.position, position)};
}

// Every u with every v.
struct SurfaceSnap::Grid {
    std::vector<double> u;
    std::vector<double> v;
    bool freeU = true;
    bool freeV = true;
};

SurfaceSnap::SurfaceSnap(const Scene& scene, const std::set<ObjectId>& objects, SnapTarget target)
{
    for (const ObjectId id : objects) {
        const SharedObject object = scene.find(id);
        if (!object)
            continue;
        objects_.emplace(id, object);
        const KnotVector& u = object->surface.knotsU();
        const KnotVector& v = object->surface.knotsV();
        if (target == SnapTarget::surface) {
            addSamples(id, *object, {parametersOf(u, kCellsPerSpan), parametersOf(v, kCellsPerSpan)});
        } else {
            addSamples(id, *object, {parametersOf(u, 1), parametersOf(v, kCellsPerSpan), false, true});
            addSamples(id, *object, {parametersOf(u, kCellsPerSpan), parametersOf(v, 1), true, false});
        }
    }
    tree_.emplace(positionsOf(seeds_));
}

void SurfaceSnap::addSamples(ObjectId id, const SceneObject& object, const Grid& grid)
{
    const GridEvaluator<double> evaluator(object.surface, {});
    GridSamples<double> samples;
    evaluator.evaluate(spanParameters(object.surface.knotsU(), grid.u),
                       spanParameters(object.surface.knotsV(), grid.v), samples);
    const size_t columns = grid.v.size();
    for (size_t row = 0; row < grid.u.size(); ++row)
        for (size_t column = 0; column < columns; ++column) {
            const Vec3 position = transformed(
                samples.position(static_cast<int>(row), static_cast<int>(column)) + samples.origin(),
                object.transform);
            if (grid.freeU && row > 0)
                gap_ = std::max(gap_, glm::distance(position, seeds_[seeds_.size() - columns].position));
            if (grid.freeV && column > 0)
                gap_ = std::max(gap_, glm::distance(position, seeds_.back().position));
            seeds_.push_back({id, grid.u[row], grid.v[column], grid.freeU, grid.freeV, position});
        }
}

std::vector<Vec3> SurfaceSnap::positionsOf(const std::vector<Seed>& seeds)
{
    std::vector<Vec3> positions;
    positions.reserve(seeds.size());
    for (const Seed& seed : seeds)
        positions.push_back(seed.position);
    return positions;
}

std::optional<SurfaceSnap::Place> SurfaceSnap::nearest(const Vec3& position, double reach) const
{
    const auto first = tree_->nearest(position, reach + gap_);
    if (!first)
        return std::nullopt;
    std::vector<size_t> starts = tree_->within(position, first->distance + 0.5 * gap_);
    const auto distance = [&](size_t k) { return glm::distance(seeds_[k].position, position); };
    std::sort(starts.begin(), starts.end(), [&](size_t a, size_t b) {
        return distance(a) != distance(b) ? distance(a) < distance(b) : a < b;
    });
    starts.resize(std::min(starts.size(), kMostStarts));
    std::optional<Place> best;
    for (const size_t k : starts) {
        const Seed& seed = seeds_[k];
        const SceneObject& object = *objects_.at(seed.object);
        Foot foot{seed.u, seed.v, nearnessAt(object, seed.u, seed.v, position)};
        goDown(object, position, seed.freeU, seed.freeV, foot);
        const double away = glm::distance(foot.at.position, position);
        if (away <= reach && (!best || away < best->distance))
            best = Place{seed.object, foot.u, foot.v, foot.at.position, away};
    }
    return best;
}

}  // namespace knotspan
