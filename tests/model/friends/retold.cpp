#include "tests/model/friends/retold.h"

#include <array>

#include "model/geometry/degree_elevation.h"
#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "tests/joined_surfaces.h"

namespace knotspan::testing {

namespace {

KnotVector mapped(const KnotVector& knots, const std::function<double(double)>& map)
{
    std::vector<double> values;
    for (const double knot : knots.values())
        values.push_back(map(knot));
    return KnotVector::create(knots.degree(), std::move(values)).value();
}

NurbsSurface refined(NurbsSurface surface)
{
    for (const Direction direction : {Direction::U, Direction::V}) {
        const KnotVector& knots = direction == Direction::U ? surface.knotsU() : surface.knotsV();
        const double start = knots.domainStart();
        const double length = knots.domainEnd() - start;
        for (const double share : {0.137, 0.52, 0.911})
            surface = withKnotInserted(surface, direction, start + share * length);
    }
    return surface;
}

NurbsSurface elevated(const NurbsSurface& surface)
{
    return withDegree(withDegree(surface, Direction::U, surface.degreeU() + 1), Direction::V,
                      surface.degreeV() + 2);
}

}  // namespace

NurbsSurface rescaledU(const NurbsSurface& surface, double scale, double shift)
{
    return surfaceOf(mapped(surface.knotsU(), [&](double u) { return (u - shift) / scale; }),
                     surface.knotsV(), [&](int i, int j) { return surface.controlPoint(i, j); });
}

// The blossom of (weight(s)^p S(u(s))) is that of S at the mapped arguments, times their weights.
NurbsSurface projectedU(const NurbsSurface& surface, double factor)
{
    const double start = surface.knotsU().domainStart();
    const double length = surface.knotsU().domainEnd() - start;
    const auto toNew = [&](double u) {
        const double t = (u - start) / length;
        return t / (t + factor * (1 - t));
    };
    const KnotVector knots = mapped(surface.knotsU(), toNew);
    return surfaceOf(knots, surface.knotsV(), [&](int i, int j) {
        ControlPoint point = surface.controlPoint(i, j);
        for (int k = 1; k <= knots.degree(); ++k)
            point.weight *= 1 - knots[i + k] + factor * knots[i + k];
        return point;
    });
}

// B_k(v) for each k as a polynomial of degree 4 in v': products of v's and 1 - v's Bernstein coefficients
// (0, bend, 1) and (1, 1 - bend, 0).
NurbsSurface unevenV(const NurbsSurface& surface, double bend)
{
    using Factor = std::array<double, 3>;
    const Factor low = {1, 1 - bend, 0};
    const Factor high = {0, bend, 1};
    const auto times = [](const Factor& x, const Factor& y) {
        std::array<double, 5> product{};
        constexpr double kTwo[] = {1, 2, 1};
        constexpr double kFour[] = {1, 4, 6, 4, 1};
        for (size_t i = 0; i < 3; ++i)
            for (size_t k = 0; k < 3; ++k)
                product[i + k] += kTwo[i] * x[i] * kTwo[k] * y[k] / kFour[i + k];
        return product;
    };
    const std::array<double, 5> basis[] = {times(low, low), times(low, high), times(high, high)};
    return surfaceOf(surface.knotsU(), KnotVector::clampedUniform(4, 1), [&](int i, int j) -> ControlPoint {
        Vec4 point(0);
        for (int k = 0; k < 3; ++k)
            point += (k == 1 ? 2.0 : 1.0) * basis[k][static_cast<size_t>(j)] *
                     surface.controlPoint(i, k).homogeneous();
        return {Vec3(point) / point.w, point.w};
    });
}

const std::vector<Retelling>& retellings()
{
    static const std::vector<Retelling> kAll = {
        {"as it is", [](const NurbsSurface& s) { return s; }},
        {"u reversed", reversedU},
        {"v reversed", [](const NurbsSurface& s) { return exchanged(reversedU(exchanged(s))); }},
        {"u and v exchanged", exchanged},
        {"elevated", elevated},
        {"refined", refined},
        {"rescaled",
         [](const NurbsSurface& s) { return rescaledU(exchanged(rescaledU(s, 7, -3)), 0.01, 2); }},
        {"projected along u", [](const NurbsSurface& s) { return projectedU(s, 2.3); }},
        {"projected along v", [](const NurbsSurface& s) { return exchanged(projectedU(exchanged(s), 0.4)); }},
        {"all at once",
         [](const NurbsSurface& s) {
             return reversedU(rescaledU(exchanged(refined(elevated(projectedU(exchanged(s), 1.7)))), 3, 1));
         }},
    };
    return kAll;
}

}  // namespace knotspan::testing
