#include "renderer/scene/bezier_nets.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include <tbb/parallel_for.h>

namespace knotspan {

namespace {

// Surfaces mostly share their knots.
class MatrixPool {
public:
    std::shared_ptr<const SpanMatrices> of(const KnotVector& knots)
    {
        auto& matrices = known_[{knots.degree(), knots.values()}];
        if (!matrices)
            matrices = std::make_shared<const SpanMatrices>(knots);
        return matrices;
    }

private:
    std::map<std::pair<int, std::vector<double>>, std::shared_ptr<const SpanMatrices>> known_;
};

// Of a thread; good until it asks for another surface's.
std::span<const Vec4> homogeneous(const Resident& resident)
{
    constexpr double kLargest = std::numeric_limits<float>::max() / 1e8;
    thread_local std::vector<Vec4> points;
    const auto& given = resident.object->surface.controlPoints();
    points.resize(given.size());
    std::transform(given.begin(), given.end(), points.begin(),
                   [&](const ControlPoint& point) { return resident.frame.pack(point, kLargest); });
    return points;
}

}  // namespace

BezierNets::BezierNets(const std::vector<Resident>& residents) : firsts_{0}
{
    MatrixPool pool;
    for (const Resident& resident : residents) {
        const NurbsSurface& surface = resident.object->surface;
        decompositions_.emplace_back(pool.of(surface.knotsU()), pool.of(surface.knotsV()));
        firsts_.push_back(firsts_.back() + decompositions_.back().pointCount());
    }
}

void BezierNets::make(const std::vector<Resident>& residents, size_t first, size_t end,
                      std::span<glm::vec4> to) const
{
    tbb::parallel_for(first, end, [&](size_t k) {
        decompositions_[k].decompose(homogeneous(residents[k]),
                                     to.subspan(firsts_[k] - firsts_[first], firsts_[k + 1] - firsts_[k]));
    });
}

PackedTables<float> BezierNets::tables(const std::vector<Resident>& residents, Evaluator evaluator) const
{
    PackedTables<float> packed;
    SpanTablePool<float> pool;
    const auto tablesOf = [&](const KnotVector& knots) {
        const auto bezier = KnotVector::clampedUniform(knots.degree(), 1);
        std::vector<std::uint32_t> starts;
        for (const int span : knots.spans())
            starts.push_back(pool.startOf(bezier, knots.degree(), evaluator, startsSmoothly(knots, span)));
        return starts;
    };
    for (size_t k = 0; k < residents.size(); ++k) {
        const NurbsSurface& surface = residents[k].object->surface;
        const auto startsV = tablesOf(surface.knotsV());
        const auto netSize = static_cast<std::uint32_t>((surface.degreeU() + 1) * (surface.degreeV() + 1));
        auto point = static_cast<std::uint32_t>(firsts_[k]);
        for (const std::uint32_t startU : tablesOf(surface.knotsU()))
            for (const std::uint32_t startV : startsV) {
                packed.ksquads.push_back({static_cast<std::uint32_t>(k), point, startU, startV});
                point += netSize;
            }
    }
    packed.spanTables = pool.takeNumbers();
    return packed;
}

}  // namespace knotspan
