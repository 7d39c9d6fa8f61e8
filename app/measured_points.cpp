#include "app/measured_points.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "model/geometry/evaluator_tables.h"
#include "model/geometry/ksquad.h"
#include "model/geometry/span_numbers.h"
#include "shaders/shared/nurbs_basis.glsl"

namespace knotspan::app {
namespace {

constexpr size_t kExactPoints = 20'000;       // more change no figure, and take long
constexpr size_t kLeastTimedPoints = 20'000;  // fewer are over before a clock can tell

// Its numbers are the same with every compiler; a float has the 24 bits of t.
class RandomParameter {
public:
    double operator()() { return static_cast<double>(random_() >> 8) * 0x1p-24; }

private:
    std::mt19937 random_{20'240'607};
};

// One direction of a surface: the span tables of the evaluator `triangular`.
class ExactBasis {
public:
    explicit ExactBasis(const KnotVector& knots)
        : degree_(knots.degree()),
          tables_(knots, [&knots](int span, std::vector<Exact>& numbers) {
              constexpr Exact kMostSpans = 1e300L;
              const auto table = evaluator_tables::differences<Exact>(knots, span, kMostSpans);
              numbers.insert(numbers.end(), table.begin(), table.end());
          })
    {
    }

    [[nodiscard]] gpu::BasisValues<Exact> at(const SpanParameter& place) const
    {
        return gpu::evaluateBasisValues<Evaluator::triangular, Exact>(
            TableSource<Exact>{tables_.data()}, static_cast<gpu::uint>(tables_.startOf(place.span)), degree_,
            static_cast<Exact>(place.t));
    }

private:
    int degree_;
    SpanNumbers<Exact> tables_;
};

class ExactSurface {
public:
    explicit ExactSurface(const NurbsSurface& surface)
        : surface_(surface),
          origin_(surface.bounds().centre()),
          basisU_(surface.knotsU()),
          basisV_(surface.knotsV())
    {
    }

    [[nodiscard]] ExactPoint at(size_t index, const SpanParameter& u, const SpanParameter& v) const
    {
        const auto basisU = basisU_.at(u);
        const auto basisV = basisV_.at(v);
        ExactVec3 sum(0);
        Exact weight = 0;
        double size = 0;
        for (int i = 0; i <= surface_.degreeU(); ++i)
            for (int j = 0; j <= surface_.degreeV(); ++j) {
                const ControlPoint& point =
                    surface_.controlPoint(u.span - surface_.degreeU() + i, v.span - surface_.degreeV() + j);
                const ExactVec3 offset = ExactVec3(point.position) - origin_;
                const Exact share = basisU.value[i] * basisV.value[j] * static_cast<Exact>(point.weight);
                sum += share * offset;
                weight += share;
                for (int c = 0; c < 3; ++c)
                    size = std::max(size, static_cast<double>(std::abs(offset[c])));
            }
        return {index, sum / weight, size};
    }

private:
    const NurbsSurface& surface_;
    ExactVec3 origin_;
    ExactBasis basisU_;
    ExactBasis basisV_;
};

// `each` parameters on every span, growing.
std::vector<SpanParameter> perSpan(const KnotVector& knots, size_t each, RandomParameter& random)
{
    std::vector<SpanParameter> result;
    std::vector<double> values(each);
    for (const int span : knots.spans()) {
        std::generate(values.begin(), values.end(), [&] { return random(); });
        std::sort(values.begin(), values.end());
        for (const double t : values)
            result.push_back({span, t});
    }
    return result;
}

void repeat(std::vector<SpanParameter>& places, size_t times)
{
    const size_t once = places.size();
    places.resize(once * times);
    for (size_t k = once; k < places.size(); ++k)
        places[k] = places[k - once];
}

// Where the KSQuads are the first, second, ... of `ksquads` in all, point k of `count` falls on the KSQuad
// k * ksquads / count.
struct Spread {
    size_t ksquads;
    size_t count;

    [[nodiscard]] size_t firstPoint(size_t ksquad) const { return (ksquad * count + ksquads - 1) / ksquads; }
};

class PointMaker {
public:
    PointMaker(size_t ksquads, size_t count)
        : spread_{ksquads, count},
          times_((kLeastTimedPoints + count - 1) / count),
          step_((count + kExactPoints - 1) / kExactPoints),
          perSide_(std::max<size_t>(1, static_cast<size_t>(std::lround(std::sqrt(
                                           static_cast<double>(count) / static_cast<double>(ksquads))))))
    {
    }

    [[nodiscard]] MeasuredSurface surface(ObjectId id, const SharedObject& object)
    {
        MeasuredSurface result{id, object, {}, {}};
        const ExactSurface exact(object->surface);
        scatter(result.scattered, object->surface, exact);
        if (!result.scattered.u.empty())
            layGrid(result.grid, object->surface, exact);
        return result;
    }

private:
    void scatter(Places& places, const NurbsSurface& surface, const ExactSurface& exact)
    {
        for (const KsQuad& ksquad : ksQuads(surface)) {
            const size_t end = spread_.firstPoint(ksquad_ + 1);
            for (size_t k = spread_.firstPoint(ksquad_); k < end; ++k) {
                places.u.push_back({ksquad.spanU, random_()});
                places.v.push_back({ksquad.spanV, random_()});
                if (k % step_ == 0)
                    places.exact.push_back(exact.at(places.u.size() - 1, places.u.back(), places.v.back()));
            }
            ++ksquad_;
        }
        repeat(places.u, times_);
        repeat(places.v, times_);
    }

    void layGrid(Places& places, const NurbsSurface& surface, const ExactSurface& exact)
    {
        places.u = perSpan(surface.knotsU(), perSide_, random_);
        places.v = perSpan(surface.knotsV(), perSide_, random_);
        const size_t columns = places.v.size();
        for (size_t k = 0; k < places.u.size() * columns; ++k)
            if (gridPoint_++ % step_ == 0)
                places.exact.push_back(exact.at(k, places.u[k / columns], places.v[k % columns]));
    }

    Spread spread_;
    size_t times_;
    size_t step_;     // from one exact point to the next
    size_t perSide_;  // of a grid on a KSQuad
    RandomParameter random_;
    size_t ksquad_ = 0;
    size_t gridPoint_ = 0;
};

}  // namespace

MeasuredPoints measuredPoints(const Scene& scene, size_t count)
{
    size_t ksquads = 0;
    for (const auto& [id, object] : scene.objects())
        ksquads += object->visible ? ksQuadCount(object->surface) : 0;
    MeasuredPoints result;
    if (ksquads == 0)
        return result;
    PointMaker maker(ksquads, count);
    for (const auto& [id, object] : scene.objects()) {
        if (!object->visible)
            continue;
        MeasuredSurface surface = maker.surface(id, object);
        if (surface.scattered.u.empty())
            continue;
        result.scattered += surface.scattered.u.size();
        result.grid += surface.grid.u.size() * surface.grid.v.size();
        result.exact += surface.scattered.exact.size();
        result.surfaces.push_back(std::move(surface));
    }
    return result;
}

}  // namespace knotspan::app
