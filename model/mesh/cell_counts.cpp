#include "model/mesh/cell_counts.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "model/geometry/grid_evaluation.h"

namespace knotspan {

namespace {

// How far normals turn over KSQuads, from samples.
class Turning {
public:
    explicit Turning(const PlacedSurface& placed)
        : evaluator_(*placed.surface, {.derivatives = 1, .normals = true}),
          toNormals_(glm::transpose(glm::inverse(glm::dmat3(placed.transform))))
    {
        for (int k = 0; k <= kSteps; ++k) {
            u_.push_back({0, static_cast<double>(k) / kSteps});
            v_.push_back({0, static_cast<double>(k) / kSteps});
        }
    }

    // Cells each way, so that they turn no more than `angle` over one.
    [[nodiscard]] Grid cells(const KsQuad& quad, double angle)
    {
        for (size_t k = 0; k < u_.size(); ++k) {
            u_[k].span = quad.spanU;
            v_[k].span = quad.spanV;
        }
        evaluator_.evaluate(u_, v_, samples_, Threads::one);
        double alongU = 0;
        double alongV = 0;
        for (int i = 0; i <= kSteps; ++i)
            for (int j = 0; j <= kSteps; ++j) {
                if (i < kSteps)
                    alongU = std::max(alongU, between(i, j, i + 1, j));
                if (j < kSteps)
                    alongV = std::max(alongV, between(i, j, i, j + 1));
            }
        const auto count = [&](double turned) {
            return static_cast<int>(
                std::clamp(std::ceil(kSteps * turned / angle), 1.0, double(kLargestFactor)));
        };
        return {count(alongU), count(alongV)};
    }

private:
    static constexpr int kSteps = 6;

    [[nodiscard]] double between(int i, int j, int k, int l) const
    {
        const Vec3 a = toNormals_ * samples_.normal(i, j);
        const Vec3 b = toNormals_ * samples_.normal(k, l);
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    }

    GridEvaluator<double> evaluator_;
    glm::dmat3 toNormals_;
    std::vector<SpanParameter> u_;
    std::vector<SpanParameter> v_;
    GridSamples<double> samples_;
};

// A surface that closes with less than three cells round would be folded flat.
int leastRound(bool closed, size_t spans)
{
    return closed && spans < 3 ? static_cast<int>((3 + spans - 1) / spans) : 1;
}

// S = X / w: |S_u| = |X_u - S w_u| / w, with S no further than a radius from a middle.
Vec2 speedsOf(const BezierNet& net)
{
    Box box;
    double lightest = std::numeric_limits<double>::infinity();
    for (const Vec4& point : net.points) {
        box.add(Vec3(point) / point.w);
        lightest = std::min(lightest, point.w);
    }
    const Vec3 middle = box.centre();
    const double radius = box.diagonal() / 2;
    Vec2 speeds(0.0);
    const auto add = [&](double& speed, int degree, const Vec4& from, const Vec4& to) {
        const Vec4 way = to - from;
        speed =
            std::max(speed, degree * (glm::length(Vec3(way) - middle * way.w) + radius * std::abs(way.w)));
    };
    for (int i = 0; i <= net.degreeU; ++i)
        for (int j = 0; j <= net.degreeV; ++j) {
            if (i < net.degreeU)
                add(speeds.x, net.degreeU, net.at(i, j), net.at(i + 1, j));
            if (j < net.degreeV)
                add(speeds.y, net.degreeV, net.at(i, j), net.at(i, j + 1));
        }
    return speeds / lightest;
}

}  // namespace

CellCounts cellCounts(const std::vector<PlacedSurface>& surfaces, const std::vector<double>& deviations,
                      std::optional<double> angleDegrees, KsQuadShapes* shapes)
{
    CellCounts counts;
    for (size_t k = 0; k < surfaces.size(); ++k) {
        const PlacedSurface& placed = surfaces[k];
        const NurbsSurface& surface = *placed.surface;
        const BezierConversion conversion(surface, surface.bounds().centre());
        Mat4 linear = placed.transform;
        linear[3] = Vec4(0, 0, 0, 1);
        const bool moved = linear != Mat4(1.0);
        std::optional<Turning> turning;
        if (angleDegrees)
            turning.emplace(placed);
        const Grid least{leastRound(surface.isClosedU(), surface.knotsU().spans().size()),
                         leastRound(surface.isClosedV(), surface.knotsV().spans().size())};
        for (const KsQuad& quad : ksQuads(surface)) {
            BezierNet net = conversion.net(quad);
            if (moved)
                net = transformed(net, linear);
            SpaceError error(net);
            const auto chosen = chooseSpaceGrid(error, deviations[k]);
            if (!chosen)
                counts.failed.push_back(static_cast<std::uint32_t>(counts.grids.size()));
            Grid grid = chosen ? chosen->grid : Grid{};
            grid = {std::max(grid.u, least.u), std::max(grid.v, least.v)};
            if (turning) {
                const Grid asked = turning->cells(quad, glm::radians(*angleDegrees));
                grid = {std::max(grid.u, asked.u), std::max(grid.v, asked.v)};
            }
            const SpaceFigures& whole = error.whole().better();
            const Vec3 along = whole.a / (double(grid.u) * grid.u) + whole.c / (double(grid.v) * grid.v);
            counts.rising.push_back(glm::dot(along, whole.b) < 0 ? 1 : 0);
            counts.grids.push_back(grid);
            if (shapes != nullptr) {
                error.considerSurface();
                shapes->whole.push_back(error.whole());
                shapes->speeds.push_back(speedsOf(net));
            }
            counts.bounds.push_back(chosen ? chosen->bound : 0);
        }
    }
    return counts;
}

}  // namespace knotspan
