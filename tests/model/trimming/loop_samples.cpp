#include "tests/model/trimming/loop_samples.h"

#include <cmath>
#include <random>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace knotspan::testing {

namespace {

// All points of the loops, closely.
std::vector<std::vector<Vec2>> polygonsOf(const std::vector<TrimLoop>& loops, int samplesPerSpan)
{
    std::vector<std::vector<Vec2>> polygons;
    for (const TrimLoop& loop : loops) {
        std::vector<Vec2>& polygon = polygons.emplace_back();
        for (const TrimCurve& curve : loop.curves)
            for (const int span : curve.knots().spans())
                for (int k = 0; k < samplesPerSpan; ++k)
                    polygon.push_back(
                        curve.evaluate(curve.knots()[span] +
                                       (curve.knots()[span + 1] - curve.knots()[span]) * k / samplesPerSpan));
        polygon.push_back(loop.curves.back().evaluate(loop.curves.back().knots().domainEnd()));
    }
    return polygons;
}

struct Verdict {
    bool inside;
    double distance;
};
Verdict verdictOf(const std::vector<std::vector<Vec2>>& polygons, const Vec2& at, bool inside)
{
    Verdict verdict{inside, 1e300};
    for (const auto& polygon : polygons)
        for (size_t k = 0; k < polygon.size(); ++k) {
            const Vec2 a = polygon[k];
            const Vec2 b = polygon[(k + 1) % polygon.size()];
            if ((a.y <= at.y) != (b.y <= at.y) && a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x) < at.x)
                verdict.inside = !verdict.inside;
            const Vec2 way = b - a;
            const double s =
                way == Vec2(0) ? 0 : std::clamp(glm::dot(at - a, way) / glm::dot(way, way), 0.0, 1.0);
            verdict.distance = std::min(verdict.distance, glm::length(at - a - s * way));
        }
    return verdict;
}

}  // namespace

NurbsSurface flatSurface(const std::vector<double>& placesU, const std::vector<double>& placesV)
{
    const auto knots = [](const std::vector<double>& places) {
        std::vector<double> values(2, places.front());
        values.insert(values.end(), places.begin() + 1, places.end() - 1);
        values.insert(values.end(), 2, places.back());
        return KnotVector::create(1, values).value();
    };
    std::vector<ControlPoint> points;
    for (const double u : placesU)
        for (const double v : placesV)
            points.push_back({{u, v, 0}, 1});
    return NurbsSurface::create(knots(placesU), knots(placesV), points).value();
}

NurbsSurface flatSurface()
{
    return flatSurface({-1, -0.25, 0.125, 1.5, 3}, {10, 11, 11.75, 12});
}

NurbsSurface roundSurface()
{
    std::vector<ControlPoint> points;
    for (const Vec2 at : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1), Vec2(1, 0)})
        for (const double z : {0.0, 1.0})
            points.push_back({{at.x, at.y, z}, 1});
    return NurbsSurface::create(KnotVector::clampedUniform(1, 4), KnotVector::clampedUniform(1, 1), points)
        .value();
}

TrimCurve polyline(const std::vector<Vec2>& places)
{
    std::vector<TrimPoint> points;
    for (const Vec2& place : places)
        points.push_back({place, 1});
    return TrimCurve::create(KnotVector::clampedUniform(1, static_cast<int>(places.size()) - 1), points)
        .value();
}

TrimCurve circle(const Vec2& centre, double radius, bool anticlockwise)
{
    const double half = std::sqrt(0.5);
    std::vector<TrimPoint> points;
    const Vec2 corners[] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (int k = 0; k < 9; ++k)
        points.push_back({centre + radius * corners[anticlockwise ? k : 8 - k], k % 2 == 0 ? 1 : half});
    return TrimCurve::create(KnotVector::create(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}).value(), points)
        .value();
}

namespace {

// What the index says of boxes of all sizes, against single places in them.
void compareBoxes(const TrimIndex& index, std::uint32_t ksquad, const Vec2& place, std::mt19937& random,
                  Counts& counts)
{
    std::uniform_real_distribution<double> share(-1, 1);
    const Vec2 room = glm::min(place, 1.0 - place);
    const double size = std::pow(10, -1.5 + 1.5 * share(random));
    const Vec2 reach = glm::min(size * Vec2(1, std::pow(4, share(random))), room);
    const KsQuadTrim side = index.sideOf(ksquad, place, reach);
    bool seen[2] = {};
    for (int k = 0; k < 16; ++k) {
        const Vec2 at = place + 0.9999 * reach * (k == 0 ? Vec2(0) : Vec2(share(random), share(random)));
        const bool inside = index.contains(ksquad, static_cast<float>(at.x), static_cast<float>(at.y));
        seen[inside ? 1 : 0] = true;
        counts.wrongBox += side != KsQuadTrim::cut && (side == KsQuadTrim::inside) != inside ? 1 : 0;
    }
    counts.unsureBox += side == KsQuadTrim::cut ? 1 : 0;
    counts.cutBox += seen[0] && seen[1] ? 1 : 0;
}

}  // namespace

Counts compare(const std::vector<TrimLoop>& loops, const NurbsSurface& surface, double near, int points,
               int samplesPerSpan, bool startsInside)
{
    const TrimRegion region(loops, surface);
    const auto index = TrimIndex::create(region);
    EXPECT_TRUE(index.has_value());
    const auto polygons = polygonsOf(loops, samplesPerSpan);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    const Vec2 low(surface.knotsU().domainStart(), surface.knotsV().domainStart());
    const Vec2 size = Vec2(surface.knotsU().domainEnd(), surface.knotsV().domainEnd()) - low;
    Counts counts;
    for (int k = 0; k < points; ++k) {
        const Vec2 at = low + Vec2(share(random), share(random)) * size;
        const Verdict wanted = verdictOf(polygons, at, startsInside);
        const bool found = region.contains(at.x, at.y);
        const TrimRegion::Place place = region.placeOf(at.x, at.y);
        const auto ksquad = static_cast<std::uint32_t>(place.a * region.countV() + place.b);
        const bool indexed =
            index->contains(ksquad, static_cast<float>(place.t.x), static_cast<float>(place.t.y));
        ++counts.asked;
        counts.inside += wanted.inside;
        counts.wrongRegion += wanted.distance > near && found != wanted.inside;
        counts.wrongIndex += wanted.distance > 1e-5 + near && indexed != found;
        const KsQuadTrim kind = index->classOf(ksquad);
        counts.wrongClass +=
            kind != KsQuadTrim::cut && (kind == KsQuadTrim::inside) != found && wanted.distance > near;
        compareBoxes(*index, ksquad, place.t, random, counts);
    }
    return counts;
}

void expectRight(const Counts& counts, const std::string& what)
{
    EXPECT_EQ(counts.wrongRegion, 0) << what;
    EXPECT_EQ(counts.wrongIndex, 0) << what;
    EXPECT_EQ(counts.wrongClass, 0) << what;
    EXPECT_EQ(counts.wrongBox, 0) << what;
    // Points in the box miss some curves, and the index is careful.
    EXPECT_LE(counts.unsureBox, 3 * counts.cutBox + counts.asked / 5) << what;
}

}  // namespace knotspan::testing
