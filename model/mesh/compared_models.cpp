#include "model/mesh/compared_models.h"

#include <algorithm>

#include <glm/common.hpp>

#include "model/mesh/nearest_triangle.h"
#include "model/mesh/placed_meshes.h"
#include "model/mesh/tessellation.h"

namespace knotspan {

namespace {

bool showsSurfaces(const Scene& scene)
{
    return std::any_of(scene.objects().begin(), scene.objects().end(),
                       [](const auto& entry) { return entry.second->visible; });
}

// Surfaces within `deviation`, or as near to it as so many triangles come. Of a face whose
// outline crosses itself by more than a fine deviation nobody knows how far it is off: then a coarser one is
// nearer.
Result<Tessellation> nearestTessellation(const Scene& scene, double deviation, size_t most)
{
    constexpr int kTries = 20;
    constexpr int kCoarser = 6;  // where it is not as near as asked
    constexpr double kStep = 3;
    Result<Tessellation> best = failure("");
    int coarser = 0;
    for (int k = 0; k < kTries && coarser <= kCoarser; ++k, deviation *= kStep) {
        auto made = tessellate(scene, {deviation, {}, false, most, false});
        if (!made) {
            if (!best)
                best = std::move(made);
            continue;
        }
        const bool isNear = made->bound <= deviation;
        if (!best || made->bound < best->bound)
            best = std::move(made);
        if (isNear)
            break;
        ++coarser;
    }
    return best;
}

Result<ComparedModel> comparedOf(const Scene& scene, double deviation, size_t most)
{
    ComparedModel result;
    if (showsSurfaces(scene)) {
        constexpr size_t kPerKnotSpan = 20;  // two at least
        most = std::max(most, kPerKnotSpan * scene.ksQuadCount());
        auto made = nearestTessellation(scene, deviation, most);
        if (!made)
            return tl::unexpected(made.error());
        result.mesh = std::move(made->mesh);
        result.bound = made->bound;
        result.uncut = made->uncut;
    }
    addPlacedMeshes(scene, result.mesh);
    if (result.mesh.triangles.empty())
        return failure("There is nothing to compare with", "Show at least one object");
    return result;
}

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

Result<ComparedModels> modelsWithin(const Scene& a, const Scene& b, double scale, double deviation,
                                    size_t most)
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
    return ComparedModels{*std::move(first), *std::move(second)};
}

}  // namespace

Box ComparedModels::box() const
{
    Box box;
    for (const TriangleMesh* mesh : {&a.mesh, &b.mesh})
        for (const Vec3& vertex : mesh->vertices)
            box.add(vertex);
    return box;
}

double ComparedModels::bound() const
{
    constexpr double kRounding = 1e-15;
    const Box both = box();
    const Vec3 furthest = glm::max(glm::abs(both.low), glm::abs(both.high));
    return a.bound + b.bound + kRounding * std::max({furthest.x, furthest.y, furthest.z});
}

double ComparedModels::tolerance() const
{
    return std::max(bound() / 2, 1e-9 * box().diagonal());
}

std::vector<std::string> ComparedModels::notes() const
{
    const size_t uncut = a.uncut + b.uncut;
    if (uncut == 0)
        return {};
    return {std::to_string(uncut) +
            (uncut == 1 ? " trimmed face was compared whole, because its loops cannot be followed."
                        : " trimmed faces were compared whole, because their loops cannot be followed.")};
}

// A first look tells how finely the surfaces have to be taken: far apart, coarse ones will do.
Result<ComparedModels> comparedModels(const Scene& a, const Scene& b, double scale, ComparedWays ways)
{
    constexpr double kCoarse = 1e-2;  // of the model's size
    constexpr double kFinest = 1e-6;
    constexpr double kAccuracy = 1e-3;  // of the distance
    constexpr size_t kFew = 4'000;
    constexpr size_t kMany = 100'000;
    const double size = std::max({a.bounds().diagonal(), b.bounds().diagonal() * scale, 1e-300});
    auto models = modelsWithin(a, b, scale, kCoarse * size, kFew);
    if (!models || (!showsSurfaces(a) && !showsSurfaces(b)))
        return models;
    double rough = roughDistance(models->a.mesh, models->b.mesh);
    if (ways == ComparedWays::both)
        rough = std::max(rough, roughDistance(models->b.mesh, models->a.mesh));
    return modelsWithin(a, b, scale, std::max(kAccuracy * rough, kFinest * size), kMany);
}

}  // namespace knotspan
