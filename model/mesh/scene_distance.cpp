#include "model/mesh/scene_distance.h"

#include <algorithm>

#include <glm/common.hpp>

#include "model/mesh/nearest_triangle.h"
#include "model/mesh/placed_meshes.h"
#include "model/mesh/tessellation.h"

namespace knotspan {

namespace {

// Each model as triangles.
struct Compared {
    TriangleMesh mesh;
    double bound = 0;
    size_t trimmed = 0;
};

bool showsSurfaces(const Scene& scene)
{
    return std::any_of(scene.objects().begin(), scene.objects().end(),
                       [](const auto& entry) { return entry.second->visible; });
}

// Surfaces within `deviation`, or as near to it as so many triangles come.
Result<Compared> comparedOf(const Scene& scene, double deviation, size_t most)
{
    constexpr int kTries = 20;
    constexpr double kStep = 3;
    Compared result;
    if (showsSurfaces(scene)) {
        constexpr size_t kPerKnotSpan = 20;  // two at least
        most = std::max(most, kPerKnotSpan * scene.ksQuadCount());
        Result<Tessellation> made = failure("");
        for (int k = 0; k < kTries && !made; ++k, deviation *= kStep)
            made = tessellate(scene, {deviation, {}, false, most});
        if (!made)
            return tl::unexpected(made.error());
        result.mesh = std::move(made->mesh);
        result.bound = made->bound;
        for (const auto& [id, object] : scene.objects())
            result.trimmed += object->visible && !object->trimLoops.empty() ? 1 : 0;
    }
    addPlacedMeshes(scene, result.mesh);
    if (result.mesh.triangles.empty())
        return failure("There is nothing to compare with", "Show at least one object");
    return result;
}

Box boxOf(const TriangleMesh& mesh)
{
    Box box;
    for (const Vec3& vertex : mesh.vertices)
        box.add(vertex);
    return box;
}

}  // namespace

double SceneDistance::mean() const
{
    const double area = aToB.area + bToA.area;
    return area > 0 ? (aToB.mean * aToB.area + bToA.mean * bToA.area) / area : 0;
}

double SceneDistance::uncertainty() const
{
    const double found = larger().largest;
    const double possible =
        std::max(aToB.largest + aToB.uncertainty, bToA.largest + bToA.uncertainty) - found;
    return possible + surfaces;
}

namespace {

// About how far the models are apart, by some of their vertices.
double roughDistance(const TriangleMesh& from, const TriangleMesh& to)
{
    constexpr size_t kVertices = 2'000;
    const NearestTriangle nearest(to);
    const size_t step = from.vertices.size() / kVertices + 1;
    double largest = 0;
    for (size_t k = 0; k < from.vertices.size(); k += step)
        largest = std::max(largest, nearest.to(from.vertices[k]).distance);
    return largest;
}

// Both models as meshes in a's unit.
struct Pair {
    Compared a;
    Compared b;
};

Result<Pair> pairOf(const Scene& a, const Scene& b, double scale, double deviation, size_t most)
{
    auto first = comparedOf(a, deviation, most);
    if (!first)
        return tl::unexpected(first.error());
    auto second = comparedOf(b, deviation / scale, most);
    if (!second)
        return tl::unexpected(second.error());
    for (Vec3& vertex : second->mesh.vertices)
        vertex *= scale;
    second->bound *= scale;
    return Pair{*std::move(first), *std::move(second)};
}

SceneDistance distanceOf(const Pair& pair)
{
    SceneDistance result;
    Box both = boxOf(pair.a.mesh);
    both.add(boxOf(pair.b.mesh));
    constexpr double kRounding = 1e-15;
    const Vec3 furthest = glm::max(glm::abs(both.low), glm::abs(both.high));
    result.surfaces =
        pair.a.bound + pair.b.bound + kRounding * std::max({furthest.x, furthest.y, furthest.z});
    const double tolerance = std::max(result.surfaces / 2, 1e-9 * both.diagonal());
    result.aToB = distanceFrom(pair.a.mesh, pair.b.mesh, tolerance);
    result.bToA = distanceFrom(pair.b.mesh, pair.a.mesh, tolerance);
    if (const size_t trimmed = pair.a.trimmed + pair.b.trimmed; trimmed > 0)
        result.notes.push_back(std::to_string(trimmed) +
                               (trimmed == 1 ? " trimmed face was" : " trimmed faces were") +
                               " compared whole, with holes and outlines uncut.");
    return result;
}

}  // namespace

// A first look tells how finely the surfaces have to be taken: far apart, coarse ones will do.
Result<SceneDistance> distanceBetween(const Scene& a, const Scene& b, double scale)
{
    constexpr double kCoarse = 1e-2;  // of the model's size
    constexpr double kFinest = 1e-6;
    constexpr double kAccuracy = 1e-3;  // of the distance
    constexpr size_t kFew = 4'000;
    constexpr size_t kMany = 100'000;
    const double size = std::max({a.bounds().diagonal(), b.bounds().diagonal() * scale, 1e-300});
    auto pair = pairOf(a, b, scale, kCoarse * size, kFew);
    if (pair && (showsSurfaces(a) || showsSurfaces(b))) {
        const double rough =
            std::max(roughDistance(pair->a.mesh, pair->b.mesh), roughDistance(pair->b.mesh, pair->a.mesh));
        pair = pairOf(a, b, scale, std::max(kAccuracy * rough, kFinest * size), kMany);
    }
    if (!pair)
        return tl::unexpected(pair.error());
    return distanceOf(*pair);
}

}  // namespace knotspan
