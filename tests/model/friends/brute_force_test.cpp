// Which edges run together, against a search that looks at every point of every edge.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "model/friends/friends.h"
#include "model/geometry/evaluation.h"
#include "tests/joined_surfaces.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

constexpr double kGap = 1e-3;
constexpr int kSteps = 3000;

struct SampledEdge {
    std::uint32_t surface = 0;
    Side side = Side::startU;
    double start = 0;
    double end = 0;
    std::vector<Vec3> points;  // kSteps + 1
    Box box;
};

std::vector<SampledEdge> sampled(const std::vector<NurbsSurface>& surfaces)
{
    std::vector<SampledEdge> edges;
    for (std::uint32_t index = 0; index < surfaces.size(); ++index)
        for (const Side side : {Side::startU, Side::endU, Side::startV, Side::endV}) {
            const KnotVector& u = surfaces[index].knotsU();
            const KnotVector& v = surfaces[index].knotsV();
            const bool alongV = side == Side::startU || side == Side::endU;
            const bool atEnd = side == Side::endU || side == Side::endV;
            const KnotVector& along = alongV ? v : u;
            const KnotVector& across = alongV ? u : v;
            SampledEdge edge{index, side, along.domainStart(), along.domainEnd(), {}, {}};
            const double fixed = atEnd ? across.domainEnd() : across.domainStart();
            for (int k = 0; k <= kSteps; ++k) {
                const double t = edge.start + (edge.end - edge.start) * k / kSteps;
                edge.points.push_back(alongV ? evaluate(surfaces[index], fixed, t).position
                                             : evaluate(surfaces[index], t, fixed).position);
            }
            for (const Vec3& point : edge.points)
                edge.box.add(point);
            edges.push_back(std::move(edge));
        }
    return edges;
}

double distanceTo(const SampledEdge& edge, const Vec3& point)
{
    double least = std::numeric_limits<double>::infinity();
    size_t nearest = 0;
    for (size_t k = 0; k < edge.points.size(); ++k) {
        const Vec3 way = edge.points[k] - point;
        if (glm::dot(way, way) < least) {
            least = glm::dot(way, way);
            nearest = k;
        }
    }
    double distance = std::sqrt(least);
    for (size_t k = nearest > 0 ? nearest - 1 : 0; k < std::min(nearest + 1, edge.points.size() - 1); ++k) {
        const Vec3 along = edge.points[k + 1] - edge.points[k];
        const double share = glm::dot(point - edge.points[k], along) / glm::dot(along, along);
        distance =
            std::min(distance, glm::distance(point, edge.points[k] + std::clamp(share, 0.0, 1.0) * along));
    }
    return distance;
}

struct Range {
    double from = 0;
    double to = 0;
    double length = 0;
};

// Of the first edge, as far as it runs along the second.
std::vector<Range> together(const SampledEdge& a, const SampledEdge& b)
{
    constexpr int kStride = 15;
    std::vector<Range> ranges;
    bool open = false;
    for (int k = 0; k <= kSteps; k += kStride) {
        const auto at = static_cast<size_t>(k);
        const double t = a.start + (a.end - a.start) * k / kSteps;
        const Vec3 outside = glm::max(b.box.low - a.points[at], a.points[at] - b.box.high);
        if (std::max({outside.x, outside.y, outside.z}) > kGap || distanceTo(b, a.points[at]) > kGap) {
            open = false;
            continue;
        }
        if (!open)
            ranges.push_back({t, t, 0});
        else {
            ranges.back().to = t;
            ranges.back().length += glm::distance(a.points[at], a.points[at - kStride]);
        }
        open = true;
    }
    return ranges;
}

const FriendEdge* meetingAround(const Friends& friends, const SampledEdge& a, const SampledEdge& b, double t)
{
    const auto isOn = [](const EdgePart& part, const SampledEdge& edge) {
        return part.surface == edge.surface && part.side == edge.side;
    };
    for (const FriendEdge& edge : friends.edges())
        if ((isOn(edge.a, a) && isOn(edge.b, b) && edge.a.from <= t && t <= edge.a.to) ||
            (isOn(edge.b, a) && isOn(edge.a, b) && edge.b.from <= t && t <= edge.b.to))
            return &edge;
    return nullptr;
}

void expectAgreement(const Joined& joined)
{
    const Friends friends(placed(joined.surfaces), {kGap, 0.1, 0.01});
    const std::vector<SampledEdge> edges = sampled(joined.surfaces);
    size_t found = 0;
    for (const SampledEdge& a : edges)
        for (const SampledEdge& b : edges) {
            if (&a == &b)
                continue;
            const std::vector<Range> ranges = together(a, b);
            const double step = (a.end - a.start) / kSteps * 15;
            for (const Range& range : ranges) {
                if (range.length < 20 * kGap)
                    continue;
                ++found;
                const double middle = (range.from + range.to) / 2;
                const FriendEdge* const edge = meetingAround(friends, a, b, middle);
                ASSERT_NE(edge, nullptr)
                    << joined.name << ": " << a.surface << " " << static_cast<int>(a.side) << ", "
                    << b.surface << " " << static_cast<int>(b.side) << " at " << middle;
                const bool first = edge->a.surface == a.surface && edge->a.side == a.side;
                const EdgePart& part = first ? edge->a : edge->b;
                EXPECT_NEAR(part.from, range.from, 1.5 * step) << joined.name;
                EXPECT_NEAR(part.to, range.to, 1.5 * step) << joined.name;
            }
        }
    // Every meeting was found from both of its edges.
    EXPECT_EQ(found, 2 * friends.edges().size()) << joined.name;
}

}  // namespace

TEST(BruteForce, FindsTheSameMeetings)
{
    for (const Joined& joined : joinedSurfaces())
        expectAgreement(joined);
}

TEST(BruteForce, FindsTheSameMeetingsOfRandomRows)
{
    std::mt19937 random(101);
    for (int scene = 0; scene < 3; ++scene)
        expectAgreement(randomRows(random));
}

// Surfaces that were moved a little, so that edges part, cross and run along each other for a while.
TEST(BruteForce, FindsTheSameMeetingsOfBentEdges)
{
    std::mt19937 random(102);
    for (int scene = 0; scene < 6; ++scene) {
        Joined joined = joinedSurfaces()[static_cast<size_t>(scene)];
        joined.name += ", bent";
        for (size_t k = 1; k < joined.surfaces.size(); ++k) {
            const NurbsSurface& surface = joined.surfaces[k];
            std::vector<ControlPoint> points = surface.controlPoints();
            points[random() % points.size()].position += Vec3(0.3, -0.2, 0.3);
            joined.surfaces[k] = NurbsSurface::create(surface.knotsU(), surface.knotsV(), points).value();
        }
        expectAgreement(joined);
    }
}

}  // namespace knotspan::testing
