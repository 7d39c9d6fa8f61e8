#include "tests/joined_surfaces.h"

#include <algorithm>
#include <cmath>

#include "model/core/check.h"
#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "model/samples/sample_list.h"

namespace knotspan::testing {

namespace {

KnotVector knotVector(int degree, std::vector<double> knots)
{
    auto result = KnotVector::create(degree, std::move(knots));
    check(result.has_value(), "the knots of a test surface are valid");
    return *std::move(result);
}

ControlPoint unweighted(const Vec4& point)
{
    return {Vec3(point) / point.w, point.w};
}

// With every knot inside the domain as often as the degree.
NurbsSurface inBezierParts(NurbsSurface surface)
{
    const std::vector<double> knots = surface.knotsU().values();
    for (const int span : std::vector<int>(surface.knotsU().spans())) {
        const double knot = knots[static_cast<size_t>(span)];
        const auto times = static_cast<int>(std::count(knots.begin(), knots.end(), knot));
        if (knot > surface.knotsU().domainStart() && times < surface.degreeU())
            surface = withKnotInserted(surface, Direction::U, knot, surface.degreeU() - times);
    }
    return surface;
}

}  // namespace

NurbsSurface reversedU(const NurbsSurface& surface)
{
    std::vector<double> knots = surface.knotsU().values();
    std::reverse(knots.begin(), knots.end());
    for (double& knot : knots)
        knot = -knot;
    return surfaceOf(knotVector(surface.degreeU(), std::move(knots)), surface.knotsV(),
                     [&](int i, int j) { return surface.controlPoint(surface.countU() - 1 - i, j); });
}

NurbsSurface exchanged(const NurbsSurface& surface)
{
    return surfaceOf(surface.knotsV(), surface.knotsU(),
                     [&](int i, int j) { return surface.controlPoint(j, i); });
}

NurbsSurface elevatedU(const NurbsSurface& surface)
{
    const KnotVector& along = surface.knotsU();
    const NurbsSurface parts =
        inBezierParts(clampedPart(surface, Direction::U, along.domainStart(), along.domainEnd()));
    const int p = parts.degreeU();
    std::vector<double> knots;
    for (size_t k = 0; k < parts.knotsU().values().size(); ++k) {
        const double knot = parts.knotsU().values()[k];
        knots.push_back(knot);
        if (k == 0 || knot != parts.knotsU().values()[k - 1])
            knots.push_back(knot);
    }
    // Point i belongs to part i / (p + 1), where it is number i % (p + 1).
    return surfaceOf(knotVector(p + 1, std::move(knots)), parts.knotsV(), [&](int i, int j) {
        const int first = i / (p + 1) * p;
        const int k = i % (p + 1);
        if (k == 0)
            return parts.controlPoint(first, j);
        const double share = static_cast<double>(k) / (p + 1);
        return unweighted(share * parts.controlPoint(first + k - 1, j).homogeneous() +
                          (1 - share) * parts.controlPoint(first + k, j).homogeneous());
    });
}

NurbsSurface curvedSheet()
{
    return surfaceOf(clampedIntegerKnots(3, 3), clampedIntegerKnots(2, 2), [](int i, int j) -> ControlPoint {
        return {{0.6 * i, 0.7 * j, 0.5 * std::sin(1.3 * i + 0.4 * j)}, 1 + 0.3 * ((i + j) % 3)};
    });
}

NurbsSurface neighbourOf(const NurbsSurface& sheet, double start, double end, const Vec3& away)
{
    const NurbsSurface along = clampedPart(sheet, Direction::U, start, end);
    return surfaceOf(along.knotsU(), KnotVector::clampedUniform(1, 2), [&](int i, int j) {
        ControlPoint point = along.controlPoint(i, along.countV() - 1);
        point.position += static_cast<double>(j) * away;
        return point;
    });
}

std::vector<Joined> joinedSurfaces()
{
    const NurbsSurface sheet = curvedSheet();
    const Vec3 up{0, 1, 0.3};
    const Vec3 aside{0, 0.2, 1};
    const auto beside = [&](double start, double end) { return neighbourOf(sheet, start, end, up); };
    const auto above = [&](double start, double end) { return neighbourOf(sheet, start, end, aside); };
    return {
        {"whole", {sheet, beside(0, 3)}},
        {"reversed", {sheet, reversedU(beside(0, 3))}},
        {"exchanged", {exchanged(sheet), reversedU(beside(0, 3))}},
        {"one degree more", {sheet, elevatedU(beside(0, 3))}},
        {"a knot more", {sheet, withKnotInserted(beside(0, 3), Direction::U, 1.4)}},
        {"three along an edge", {sheet, reversedU(beside(0, 3)), exchanged(elevatedU(above(0, 3)))}},
        {"a joint within a side", {sheet, beside(0, 1.37), exchanged(beside(1.37, 3))}},
        {"joints on both sides of an edge",
         {beside(0, 0.45), elevatedU(reversedU(beside(0.45, 2.2))), beside(2.2, 3), above(0, 1.4),
          reversedU(above(1.4, 3)), sheet}},
        {"overlapping in part", {beside(0, 1.6), reversedU(above(0.7, 3))}},
        {"one within another", {beside(0, 3), exchanged(above(0.31, 0.83))}},
    };
}

Joined randomRows(std::mt19937& random)
{
    const NurbsSurface sheet = curvedSheet();
    Joined joined{"random rows", {}};
    for (const Vec3 away : {Vec3(0, 1, 0.3), Vec3(0, 0.2, 1), Vec3(0, -1, 0.4)}) {
        std::uniform_real_distribution<double> length(0.05, 1.9);
        double end = 0;
        for (double start = 0; start < 2.9; start = end) {
            end = std::min(3.0, start + length(random));
            NurbsSurface surface = neighbourOf(sheet, start, end, away);
            if (random() % 2 == 0)
                surface = reversedU(surface);
            if (random() % 3 == 0)
                surface = elevatedU(surface);
            if (random() % 2 == 0)
                surface = exchanged(surface);
            joined.surfaces.push_back(surface);
        }
    }
    return joined;
}

Scene torusWithTJoints()
{
    const Scene torus = findSample("torus")->make();
    const NurbsSurface& whole = torus.objects().begin()->second->surface;
    const auto part = [&](double startU, double endU, double startV, double endV) {
        return clampedPart(clampedPart(whole, Direction::U, startU, endU), Direction::V, startV, endV);
    };
    const NurbsSurface parts[] = {part(0, 4.3, 0, 2.5),   elevatedU(part(0, 4.3, 2.5, 5.1)),
                                  part(0, 4.3, 5.1, 8),   reversedU(part(4.3, 8, 0, 3.3)),
                                  part(4.3, 8, 3.3, 6.7), exchanged(part(4.3, 8, 6.7, 8))};
    Scene scene;
    for (const NurbsSurface& surface : parts) {
        SceneObject object = *torus.objects().begin()->second;
        object.surface = surface;
        scene.add(std::move(object));
    }
    return scene;
}

std::vector<PlacedSurface> placed(const std::vector<NurbsSurface>& surfaces)
{
    std::vector<PlacedSurface> result;
    for (const NurbsSurface& surface : surfaces)
        result.push_back({&surface, Mat4(1.0)});
    return result;
}

std::vector<PlacedSurface> placed(const Scene& scene)
{
    std::vector<PlacedSurface> result;
    for (const auto& [id, object] : scene.objects())
        result.push_back({&object->surface, object->transform});
    return result;
}

}  // namespace knotspan::testing
