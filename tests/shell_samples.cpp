#include "tests/shell_samples.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/geometry/evaluation.h"
#include "model/samples/net.h"
#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"

namespace knotspan::testing {

namespace {

double torusDistance(const Vec3& point)
{
    return std::hypot(std::hypot(point.x, point.y) - 2.0, point.z) - 0.75;
}

// Two cells a KSQuad each way.
struct FineMesh {
    FineMesh()
    {
        constexpr int kCells = 2;
        const Scene knot = findSample("knot")->make();
        for (const auto& [id, object] : knot.objects()) {
            const NurbsSurface& surface = object->surface;
            const int m = kCells * static_cast<int>(surface.knotsU().spans().size());
            const int n = kCells * static_cast<int>(surface.knotsV().spans().size());
            const auto first = points.size();
            for (int i = 0; i <= m; ++i)
                for (int j = 0; j <= n; ++j)
                    points.push_back(evaluate(surface, surface.knotsU().domainEnd() * i / m,
                                              surface.knotsV().domainEnd() * j / n)
                                         .position);
            for (int i = 0; i < m; ++i)
                for (int j = 0; j < n; ++j) {
                    const size_t a = first + static_cast<size_t>(i * (n + 1) + j);
                    const size_t b = a + static_cast<size_t>(n + 1);
                    triangles.push_back({a, b, b + 1});
                    triangles.push_back({a, b + 1, a + 1});
                }
        }
    }

    // A ray upwards from the point, by the signs of the triangles that it crosses.
    [[nodiscard]] bool isInside(const Vec3& point) const
    {
        int crossings = 0;
        const auto edge = [&](const Vec3& a, const Vec3& b) {
            return (a.x - point.x) * (b.y - point.y) - (a.y - point.y) * (b.x - point.x);
        };
        for (const auto& triangle : triangles) {
            const Vec3& a = points[triangle[0]];
            const Vec3& b = points[triangle[1]];
            const Vec3& c = points[triangle[2]];
            const double ab = edge(a, b);
            const double bc = edge(b, c);
            const double ca = edge(c, a);
            if ((ab > 0) != (bc > 0) || (ab > 0) != (ca > 0))
                continue;
            const double height = (bc * a.z + ca * b.z + ab * c.z) / (ab + bc + ca);
            if (height > point.z)
                crossings += ab > 0 ? 1 : -1;
        }
        return crossings != 0;
    }

    std::vector<Vec3> points;
    std::vector<std::array<size_t, 3>> triangles;
};

const FineMesh& knotMesh()
{
    static const FineMesh mesh;
    return mesh;
}

}  // namespace

Inside insideOf(const std::string& sample)
{
    if (sample == "sphere")
        return [](const Vec3& point) { return glm::length(point) < 1; };
    if (sample == "torus")
        return [](const Vec3& point) { return torusDistance(point) < 0; };
    check(sample == "knot", "of this sample the inside is known");
    return [](const Vec3& point) { return knotMesh().isInside(point); };
}

double distanceTo(const std::string& sample, const Vec3& point)
{
    if (sample == "sphere")
        return std::abs(glm::length(point) - 1);
    if (sample == "torus")
        return std::abs(torusDistance(point));
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& other : knotMesh().points)
        least = std::min(least, glm::dot(point - other, point - other));
    return std::sqrt(least);
}

std::vector<NurbsSurface> boxFaces(const Vec3& low, const Vec3& high)
{
    const auto corner = [&](int x, int y, int z) {
        return Vec3(x == 0 ? low.x : high.x, y == 0 ? low.y : high.y, z == 0 ? low.z : high.z);
    };
    std::vector<NurbsSurface> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (const int end : {0, 1}) {
            const KnotVector straight = KnotVector::clampedUniform(1, 1);
            const NurbsSurface face = surfaceOf(straight, straight, [&](int i, int j) -> ControlPoint {
                std::array<int, 3> at{};
                at[static_cast<size_t>(axis)] = end;
                at[static_cast<size_t>((axis + 1) % 3)] = i;
                at[static_cast<size_t>((axis + 2) % 3)] = j;
                return {corner(at[0], at[1], at[2]), 1};
            });
            faces.push_back(axis == 1 ? reversedU(face) : face);
        }
    return faces;
}

// The immersion whose cross section is an eight that turns by half a turn.
NurbsSurface kleinBottle()
{
    constexpr int kCells = 16;
    const KnotVector knots = KnotVector::clampedUniform(1, kCells);
    return surfaceOf(knots, knots, [](int i, int j) -> ControlPoint {
        const double u = 2 * std::numbers::pi * i / kCells;
        const double v = 2 * std::numbers::pi * j / kCells;
        const double across = std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
        const double up = std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v);
        return {{(2 + across) * std::cos(u), (2 + across) * std::sin(u), up}, 1};
    });
}

}  // namespace knotspan::testing
