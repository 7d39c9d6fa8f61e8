#include "model/mesh/deviation_map.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "model/geometry/evaluation.h"
#include "model/geometry/ksquad.h"
#include "model/mesh/compared_models.h"
#include "model/mesh/nearest_triangle.h"

namespace knotspan {

namespace {

constexpr double kColours = 500;  // a colour from nothing to the largest distance differs by less than a step

// The largest power of two not above `number`, within limits.
std::uint32_t powerOfTwo(double number, std::uint32_t least, std::uint32_t most)
{
    std::uint32_t power = least;
    while (power < most && 2.0 * power <= number)
        power *= 2;
    return power;
}

// How finely grids begin and how fine they may get, so that the picture is not waited for.
struct GridLimits {
    explicit GridLimits(size_t ksquads)
        : first(powerOfTwo(std::sqrt(40'000.0 / static_cast<double>(ksquads)), 4, 32)),
          most(powerOfTwo(std::sqrt(500'000.0 / static_cast<double>(ksquads)), first, 128))
    {
    }
    std::uint32_t first;
    std::uint32_t most;
};

// One KSQuad's distances.
struct Grid {
    std::uint32_t cells = 1;
    std::vector<float> values;
    double error = 0;  // of a grid half as fine, at this one's other points
};

class GridMaker {
public:
    GridMaker(const NearestTriangle& nearest, GridLimits limits, double tolerance)
        : nearest_(nearest),
          limits_(limits),
          tolerance_(tolerance)
    {
    }

    [[nodiscard]] Grid make(const SceneObject& object, const KsQuad& quad) const
    {
        Grid grid;
        grid.cells = limits_.first / 2;
        grid.values = valuesOf(object, quad, grid);
        do {
            Grid finer{.cells = 2 * grid.cells, .values = {}, .error = 0};
            finer.values = valuesOf(object, quad, finer, &grid);
            finer.error = largestError(grid, finer);
            grid = std::move(finer);
        } while (grid.error > tolerance_ && grid.cells < limits_.most);
        return grid;
    }

private:
    // Those of a grid half as fine are taken over.
    [[nodiscard]] std::vector<float> valuesOf(const SceneObject& object, const KsQuad& quad, const Grid& grid,
                                              const Grid* half = nullptr) const
    {
        const std::uint32_t side = grid.cells + 1;
        const KnotVector& u = object.surface.knotsU();
        const KnotVector& v = object.surface.knotsV();
        const auto at = [&](const KnotVector& knots, int span, std::uint32_t k) {
            const double share = static_cast<double>(k) / grid.cells;
            return k == grid.cells ? knots[span + 1] : knots[span] + share * (knots[span + 1] - knots[span]);
        };
        std::vector<float> values;
        values.reserve(size_t{side} * side);
        size_t guess = 0;
        for (std::uint32_t i = 0; i < side; ++i)
            for (std::uint32_t j = 0; j < side; ++j) {
                if (half != nullptr && i % 2 == 0 && j % 2 == 0) {
                    values.push_back(half->values[size_t{i / 2} * (half->cells + 1) + j / 2]);
                    continue;
                }
                const Vec3 own =
                    evaluate(object.surface, at(u, quad.spanU, i), at(v, quad.spanV, j)).position;
                const auto found = nearest_.to(transformed(own, object.transform), guess);
                guess = found.triangle;
                values.push_back(static_cast<float>(found.distance));
            }
        return values;
    }

    [[nodiscard]] static double largestError(const Grid& half, const Grid& grid)
    {
        const GridNumbers coarse{{half.cells}, {0}, half.values};
        double error = 0;
        const std::uint32_t side = grid.cells + 1;
        for (std::uint32_t i = 0; i < side; ++i)
            for (std::uint32_t j = 0; j < side; ++j) {
                const Vec2 t(static_cast<double>(i) / grid.cells, static_cast<double>(j) / grid.cells);
                error = std::max(error, std::abs(coarse.at(0, t) - grid.values[size_t{i} * side + j]));
            }
        return error;
    }

    const NearestTriangle& nearest_;
    GridLimits limits_;
    double tolerance_;
};

struct Piece {
    ObjectId id{};
    const SceneObject* object = nullptr;
    KsQuad quad;
    Grid grid;
};

std::vector<Piece> piecesOf(const Scene& scene)
{
    std::vector<Piece> pieces;
    for (const auto& [id, object] : scene.objects())
        if (object->visible)
            for (const KsQuad& quad : ksQuads(object->surface))
                pieces.push_back({id, object.get(), quad, {}});
    return pieces;
}

void makeGrids(std::vector<Piece>& pieces, const GridMaker& maker, const std::function<bool()>& isOff)
{
    std::atomic<size_t> next = 0;
    std::vector<std::thread> threads(std::clamp(std::thread::hardware_concurrency(), 1U, 64U));
    for (std::thread& thread : threads)
        thread = std::thread([&] {
            for (size_t k = next++; k < pieces.size() && !isOff(); k = next++)
                pieces[k].grid = maker.make(*pieces[k].object, pieces[k].quad);
        });
    for (std::thread& thread : threads)
        thread.join();
}

SharedSurfaceNumbers numbersOf(const std::vector<Piece>& pieces)
{
    auto numbers = std::make_shared<SurfaceNumbers>();
    for (const Piece& piece : pieces) {
        GridNumbers& of = (*numbers)[piece.id];
        of.cells.push_back(piece.grid.cells);
        of.first.push_back(static_cast<std::uint32_t>(of.values.size()));
        of.values.insert(of.values.end(), piece.grid.values.begin(), piece.grid.values.end());
    }
    return numbers;
}

Scene withoutMeshes(Scene scene)
{
    while (!scene.meshes().empty())
        scene.exchangeMesh(scene.meshes().begin()->first, nullptr);
    return scene;
}

}  // namespace

Result<DeviationMap> deviationMap(const Scene& measured, const Scene& reference, double scale,
                                  const std::function<bool()>& asked)
{
    const auto isOff = asked ? asked : [] { return false; };
    const auto off = [] { return failure("The comparison was stopped"); };
    const auto models = comparedModels(withoutMeshes(measured), reference, scale, ComparedWays::fromA);
    if (!models)
        return tl::unexpected(models.error());
    if (isOff())
        return off();
    DeviationMap map;
    map.bound = models->bound();
    map.notes = models->notes();
    map.figures = distanceFrom(models->a.mesh, models->b.mesh, models->tolerance());
    std::vector<Piece> pieces = piecesOf(measured);
    const NearestTriangle nearest(models->b.mesh);
    const double tolerance =
        std::max({map.figures.largest / kColours, models->b.bound, 1e-9 * measured.bounds().diagonal()});
    makeGrids(pieces, GridMaker(nearest, GridLimits(pieces.size()), tolerance), isOff);
    if (isOff())
        return off();
    for (const Piece& piece : pieces)
        map.accuracy = std::max(map.accuracy, piece.grid.error);
    map.accuracy += models->b.bound;  // their points are the surfaces' own
    map.distances = numbersOf(pieces);
    return map;
}

}  // namespace knotspan
