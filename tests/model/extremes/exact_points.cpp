#include "tests/model/extremes/exact_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace knotspan::testing {

namespace {

// Borders, places close to them and inner ones; float has them all.
constexpr std::array<std::array<double, 2>, 9> kPlaces{{{0, 0},
                                                        {1, 0},
                                                        {0, 1},
                                                        {1, 1},
                                                        {0.3125, 0},
                                                        {0.6875, 0.375},
                                                        {0x1p-20, 0.75},
                                                        {0.40625, 1},
                                                        {0.90625, 0x1p-20}}};

double largest(const RealVec3& value)
{
    return static_cast<double>(std::max({Real(abs(value[0])), Real(abs(value[1])), Real(abs(value[2]))}));
}

int spanAt(const KnotVector& knots, const Real& u)
{
    int result = knots.spans().front();
    for (const int span : knots.spans())
        if (Real(knots[span]) <= u)
            result = span;
    return result;
}

std::optional<RealVec3> unitNormal(const PrecisePoint& at)
{
    RealVec3 normal = cross(at.du, at.dv);
    const Real size = length(normal);
    if (size <= Real(1e-38) * length(at.du) * length(at.dv))
        return std::nullopt;
    for (Real& part : normal)
        part /= size;
    return normal;
}

std::optional<RealVec3> limitOfNormals(const NurbsSurface& surface, const Real& u, const Real& v)
{
    const auto middle = [](const KnotVector& knots) {
        return (Real(knots.domainStart()) + Real(knots.domainEnd())) / 2;
    };
    const auto at = [&](double step) {
        const Real stepU = u + (middle(surface.knotsU()) - u) * step;
        const Real stepV = v + (middle(surface.knotsV()) - v) * step;
        return unitNormal(preciseEvaluation(surface, spanAt(surface.knotsU(), stepU), stepU,
                                            spanAt(surface.knotsV(), stepV), stepV));
    };
    const auto near = at(1e-13);
    const auto nearer = at(1e-14);
    if (!near || !nearer)
        return std::nullopt;
    RealVec3 change;
    for (size_t c = 0; c < 3; ++c)
        change[c] = (*near)[c] - (*nearer)[c];
    return length(change) < 1e-6 ? nearer : std::nullopt;
}

void addNormal(const NurbsSurface& surface, const Real& u, const Real& v, ExactPoint& point)
{
    point.normal = unitNormal(point.value);
    if (!point.normal) {
        point.isLimit = true;
        point.normal = limitOfNormals(surface, u, v);
    }
}

ExactKSQuad exactKSQuad(const NurbsSurface& surface, SpanPair ksquad, Exactly exactly)
{
    const KnotVector& knotsU = surface.knotsU();
    const KnotVector& knotsV = surface.knotsV();
    ExactKSQuad result;
    for (const auto& [tu, tv] : kPlaces) {
        const Real exactU = parameterOnSpan(knotsU, ksquad.u, tu);
        const Real exactV = parameterOnSpan(knotsV, ksquad.v, tv);
        ExactPoint point{ksquad, tu, tv, static_cast<double>(exactU), static_cast<double>(exactV), {}, {}};
        const Real u = exactly == Exactly::t ? exactU : Real(point.u);
        const Real v = exactly == Exactly::t ? exactV : Real(point.v);
        // Across a knot other polynomials hold.
        if (exactly == Exactly::u &&
            (knotsU.findSpan(point.u) != ksquad.u || knotsV.findSpan(point.v) != ksquad.v))
            continue;
        point.value = preciseEvaluation(surface, ksquad.u, u, ksquad.v, v);
        addNormal(surface, u, v, point);
        result.du = std::max(result.du, largest(point.value.du));
        result.dv = std::max(result.dv, largest(point.value.dv));
        result.duu = std::max(result.duu, largest(point.value.duu));
        result.duv = std::max(result.duv, largest(point.value.duv));
        result.dvv = std::max(result.dvv, largest(point.value.dvv));
        result.points.push_back(std::move(point));
    }
    for (ExactPoint& point : result.points) {
        const Real area = length(cross(point.value.du, point.value.dv));
        if (!point.isLimit)
            point.normalSensitivity = static_cast<double>(
                (result.du * length(point.value.dv) + result.dv * length(point.value.du)) / area);
    }
    const double perU = 1 / (knotsU[ksquad.u + 1] - knotsU[ksquad.u]);
    const double perV = 1 / (knotsV[ksquad.v + 1] - knotsV[ksquad.v]);
    result.duu = std::max(result.duu, result.du * perU);
    result.duv = std::max({result.duv, result.du * perV, result.dv * perU});
    result.dvv = std::max(result.dvv, result.dv * perV);
    result.size = localSize(surface, ksquad, surface.bounds().centre());
    return result;
}

}  // namespace

std::vector<SpanPair> tellingKSQuads(const NurbsSurface& surface)
{
    const auto telling = [](const KnotVector& knots) {
        const auto shorter = [&](int a, int b) { return knots[a + 1] - knots[a] < knots[b + 1] - knots[b]; };
        const auto& spans = knots.spans();
        return std::array{spans.front(), spans.back(), *std::min_element(spans.begin(), spans.end(), shorter),
                          *std::max_element(spans.begin(), spans.end(), shorter), spans[spans.size() / 2]};
    };
    const auto u = telling(surface.knotsU());
    const auto v = telling(surface.knotsV());
    std::vector<SpanPair> result;
    for (const auto& [i, j] : {std::pair(0, 0), {1, 1}, {2, 2}, {3, 2}, {2, 3}, {4, 4}}) {
        const SpanPair pair{u[static_cast<size_t>(i)], v[static_cast<size_t>(j)]};
        const auto same = [&](const SpanPair& other) { return other.u == pair.u && other.v == pair.v; };
        if (std::none_of(result.begin(), result.end(), same))
            result.push_back(pair);
    }
    return result;
}

double localSize(const NurbsSurface& surface, SpanPair ksquad, const Vec3& origin)
{
    double size = 0;
    for (int i = ksquad.u - surface.degreeU(); i <= ksquad.u; ++i)
        for (int j = ksquad.v - surface.degreeV(); j <= ksquad.v; ++j)
            for (int c = 0; c < 3; ++c)
                size = std::max(size, std::abs(surface.controlPoint(i, j).position[c] - origin[c]));
    return size;
}

const std::vector<ExactKSQuad>& exactKSQuads(const ExtremeSurface& row, Exactly exactly)
{
    static std::map<std::pair<std::string, Exactly>, std::vector<ExactKSQuad>> known;
    auto& result = known[{row.name, exactly}];
    if (result.empty())
        for (const SpanPair& ksquad : tellingKSQuads(row.surface))
            result.push_back(exactKSQuad(row.surface, ksquad, exactly));
    return result;
}

double relativeError(const Vec3& found, const RealVec3& exact, double scale)
{
    if (!std::isfinite(found.x) || !std::isfinite(found.y) || !std::isfinite(found.z))
        return std::numeric_limits<double>::infinity();
    const double error =
        largest({Real(found.x) - exact[0], Real(found.y) - exact[1], Real(found.z) - exact[2]});
    // Figures of denormal size have fewer digits.
    return !(scale < 1e300) || error <= 2e-322 ? 0 : error / scale;
}

double angleBetween(const Vec3& found, const RealVec3& exact)
{
    const RealVec3 direction{found.x, found.y, found.z};
    return static_cast<double>(length(cross(direction, exact))) + (dot(direction, exact) > 0 ? 0 : 2);
}

}  // namespace knotspan::testing
