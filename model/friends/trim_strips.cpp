#include "model/friends/trim_strips.h"

#include <cmath>
#include <map>
#include <optional>

#include <glm/geometric.hpp>

#include "model/analysis/bezier_curves.h"
#include "model/friends/trim_pieces.h"

namespace knotspan {

namespace {

using Homogeneous = Poly<Vec4>;

// Bernstein polynomials of degree n in x, themselves polynomials: C(n, i) x^i (1 - x)^(n - i).
std::vector<Scalars> bernsteinIn(const Scalars& x, int n)
{
    const Scalars rest = difference(Scalars{1.0}, x);
    std::vector<Scalars> rises{{1.0}};
    std::vector<Scalars> falls{{1.0}};
    for (int k = 0; k < n; ++k) {
        rises.push_back(rises.back() * x);
        falls.push_back(falls.back() * rest);
    }
    std::vector<Scalars> result;
    for (size_t i = 0; i <= static_cast<size_t>(n); ++i)
        result.push_back(Scalars{binomials(n)[i]} * (rises[i] * falls[static_cast<size_t>(n) - i]));
    return result;
}

BezierNet derived(const BezierNet& net, Direction by)
{
    const bool byU = by == Direction::U;
    const int degree = byU ? net.degreeU : net.degreeV;
    if (degree == 0)
        return {0, 0, {Vec4(0)}};
    BezierNet result{net.degreeU - (byU ? 1 : 0), net.degreeV - (byU ? 0 : 1), {}};
    for (int i = 0; i <= result.degreeU; ++i)
        for (int j = 0; j <= result.degreeV; ++j)
            result.points.push_back(static_cast<double>(degree) *
                                    (net.at(i + (byU ? 1 : 0), j + (byU ? 0 : 1)) - net.at(i, j)));
    return result;
}

// The net's polynomial where its parameters are themselves polynomials; scaled coefficients.
Homogeneous composed(const BezierNet& net, const Scalars& u, const Scalars& v)
{
    const std::vector<Scalars> alongU = bernsteinIn(u, net.degreeU);
    const std::vector<Scalars> alongV = bernsteinIn(v, net.degreeV);
    Homogeneous result;
    for (int i = 0; i <= net.degreeU; ++i) {
        Homogeneous row;
        for (int j = 0; j <= net.degreeV; ++j) {
            const Homogeneous term = alongV[static_cast<size_t>(j)] * Homogeneous{net.at(i, j)};
            row = j == 0 ? term : sum(row, term);
        }
        const Homogeneous term = alongU[static_cast<size_t>(i)] * row;
        result = i == 0 ? term : sum(result, term);
    }
    return result;
}

Scalars derivative(const Scalars& bernstein)
{
    if (bernstein.size() == 1)
        return {0.0};
    Scalars result;
    for (size_t k = 0; k + 1 < bernstein.size(); ++k)
        result.push_back(static_cast<double>(bernstein.size() - 1) * (bernstein[k + 1] - bernstein[k]));
    return scaledOf(std::move(result));
}

std::vector<Vec4> bernsteinRow(const Homogeneous& scaled, size_t degree)
{
    std::vector<Vec4> row = raised(scaled, degree);
    const auto& factors = binomials(static_cast<int>(degree));
    for (size_t k = 0; k < row.size(); ++k)
        row[k] /= factors[k];
    return row;
}

// A KSQuad's net and what is derived from it.
struct Nets {
    explicit Nets(const BezierNet& net)
        : at(net),
          u(derived(net, Direction::U)),
          v(derived(net, Direction::V)),
          uu(derived(u, Direction::U)),
          uv(derived(u, Direction::V)),
          vv(derived(v, Direction::V))
    {
    }

    // Along a piece; the way across it is (-v', u'), to its left.
    [[nodiscard]] EdgeRows rowsAlong(const TrimPiece& piece) const
    {
        const Scalars x = scaledOf(piece.u);
        const Scalars y = scaledOf(piece.v);
        const Scalars dx = derivative(piece.u);
        const Scalars dy = derivative(piece.v);
        const Homogeneous edge = composed(at, x, y);
        const Homogeneous into = difference(dx * composed(v, x, y), dy * composed(u, x, y));
        const Homogeneous bend = sum(sum((dy * dy) * composed(uu, x, y), (dx * dx) * composed(vv, x, y)),
                                     (dx * dy) * composed(uv, x, y), -2);
        const size_t degree = std::max({edge.size(), into.size(), bend.size(), size_t{2}}) - 1;
        return {bernsteinRow(edge, degree), bernsteinRow(into, degree), bernsteinRow(bend, degree), false};
    }

    // How far a point moves at most by each parameter. Floater, Derivatives of rational Bézier curves, CAGD 9
    // (1992), where all weights are equal; else between any two points of the net.
    [[nodiscard]] Vec2 speeds() const
    {
        double heaviest = 0;
        double lightest = std::numeric_limits<double>::infinity();
        Box box;
        for (const Vec4& point : at.points) {
            heaviest = std::max(heaviest, point.w);
            lightest = std::min(lightest, point.w);
            box.add(pointOf(point));
        }
        const double ratio = heaviest / lightest;
        if (ratio > 1 + 1e-12)
            return Vec2(at.degreeU, at.degreeV) * (ratio * box.diagonal());
        const auto longest = [&](const BezierNet& net) {
            double length = 0;
            for (const Vec4& point : net.points)
                length = std::max(length, glm::length(Vec3(point)) / lightest);
            return length;
        };
        return {longest(u), longest(v)};
    }

    BezierNet at;
    BezierNet u;
    BezierNet v;
    BezierNet uu;
    BezierNet uv;
    BezierNet vv;
};

class TrimmedSurface {
public:
    explicit TrimmedSurface(const PlacedSurface& placed)
        : surface_(*placed.surface),
          centre_(surface_.bounds().centre()),
          conversion_(surface_, centre_),
          linear_(placed.transform),
          origin_(Vec3(placed.transform * Vec4(centre_, 1.0)))
    {
        linear_[3] = Vec4(0, 0, 0, 1);
    }

    [[nodiscard]] EdgeStrip stripOf(const TrimCurve& curve, double deviation)
    {
        // Higher ones are slower to judge than more pieces are.
        constexpr int kUsualDegree = 20;
        const int degree = surface_.knotsU().degree() + surface_.knotsV().degree();
        const TrimAccuracy accuracy{deviation, std::clamp(kUsualDegree / degree, 1, 3),
                                    [this](int u, int v) { return netsOf(u, v).speeds(); }};
        EdgeStrip strip;
        strip.origin = origin_;
        for (const TrimPiece& along : trimPieces(curve, surface_.knotsU(), surface_.knotsV(), accuracy)) {
            strip.deviation = std::max(strip.deviation, along.deviation);
            EdgePiece piece;
            piece.from = along.from;
            piece.to = along.to;
            piece.rows = netsOf(along.spanU, along.spanV).rowsAlong(along);
            add(std::move(piece), strip, 0);
        }
        return strip;
    }

private:
    const Nets& netsOf(int spanU, int spanV)
    {
        auto& held = nets_[{spanU, spanV}];
        if (!held)
            held.emplace(transformed(conversion_.net({spanU, spanV}), linear_));
        return *held;
    }

    // In halves where weights are above zero but some coefficient of theirs is not.
    void add(EdgePiece piece, EdgeStrip& strip, int depth) const
    {
        double heaviest = 0;
        double lightest = std::numeric_limits<double>::infinity();
        for (const Vec4& point : piece.rows.at) {
            heaviest = std::max(heaviest, point.w);
            lightest = std::min(lightest, point.w);
        }
        constexpr int kMostHalvings = 12;
        if (!(lightest > 1e-12 * heaviest) && depth < kMostHalvings) {
            EdgePiece first;
            first.from = piece.from;
            first.to = piece.from + (piece.to - piece.from) / 2;
            first.rows = part(piece.rows, 0, 0.5);
            piece.from = first.to;
            piece.rows = part(piece.rows, 0.5, 1);
            add(std::move(first), strip, depth + 1);
            add(std::move(piece), strip, depth + 1);
            return;
        }
        complete(piece, strip.origin);
        strip.pieces.push_back(std::move(piece));
    }

    const NurbsSurface& surface_;
    Vec3 centre_;
    BezierConversion conversion_;
    Mat4 linear_;
    Vec3 origin_;
    std::map<std::pair<int, int>, std::optional<Nets>> nets_;
};

}  // namespace

std::vector<EdgeStrip> trimStrips(const PlacedSurface& placed, double deviation)
{
    TrimmedSurface surface(placed);
    std::vector<EdgeStrip> strips;
    for (std::uint32_t loop = 0; loop < placed.trimLoops->size(); ++loop) {
        const std::vector<TrimCurve>& curves = (*placed.trimLoops)[loop].curves;
        for (std::uint32_t curve = 0; curve < curves.size(); ++curve) {
            strips.push_back(surface.stripOf(curves[curve], deviation));
            strips.back().edge.trim = TrimPlace{loop, curve};
        }
    }
    return strips;
}

}  // namespace knotspan
