#include "model/analysis/surface_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "model/analysis/gauss_rule.h"
#include "model/geometry/grid_evaluation.h"

namespace knotspan {

namespace {

constexpr double kAccuracy = 1e-10;  // of the whole area
constexpr double kRounding = 1e-15;
constexpr int kMostHalvings = 10;
constexpr int kMostQuarterings = 20000;
constexpr size_t kStripSamples = 60000;  // evaluated at once, so that memory stays small

// A part of a KSQuad: a square of side `side` from `low` on, in its own t.
struct Cell {
    int spanU = 0;
    int spanV = 0;
    Vec2 low{0};
    double side = 1;
};

struct Sum {
    double value = 0;
    double difference = 0;  // of the two rules
};

class Integration {
public:
    Integration(const NurbsSurface& surface, const Mat4& transform, const std::function<bool()>& isOff,
                const KsQuadChoice& takes)
        : surface_(surface),
          linear_(transform),
          isOff_(isOff),
          takes_(takes),
          evaluator_(surface, {.derivatives = 1})
    {
    }

    [[nodiscard]] Area run()
    {
        const std::vector<int>& spansU = surface_.knotsU().spans();
        const std::vector<int>& spansV = surface_.knotsV().spans();
        const size_t perSpan = fineGauss().places.size() * fineGauss().places.size() * spansV.size();
        const size_t strip = std::max<size_t>(1, kStripSamples / perSpan);
        for (size_t first = 0; first < spansU.size(); first += strip) {
            if (isOff_())
                return off();
            const std::span<const int> some(spansU.data() + first, std::min(strip, spansU.size() - first));
            addStrip(some, spansV);
        }
        if (takes_)
            for (size_t k = 0; k < sums_.size(); ++k)
                if (!takes_(static_cast<int>(k / spansV.size()), static_cast<int>(k % spansV.size())))
                    sums_[k] = {};
        double whole = 0;
        for (const Sum& sum : sums_)
            whole += sum.value;
        const double allowed = kAccuracy * whole / static_cast<double>(sums_.size());
        floor_ = kRounding * whole;
        Area area;
        for (size_t k = 0; k < sums_.size(); ++k) {
            const Cell cell{spansU[k / spansV.size()], spansV[k % spansV.size()]};
            refine(cell, sums_[k], std::max(allowed, floor_), 0, area);
            if (isOff_())
                return off();
        }
        area.error += kRounding * whole;
        return area;
    }

private:
    [[nodiscard]] static Area off() { return {0, std::numeric_limits<double>::infinity()}; }

    static std::vector<SpanParameter> parameters(std::span<const int> spans, const GaussRule& rule,
                                                 double low, double side)
    {
        std::vector<SpanParameter> result;
        for (const int span : spans)
            for (const double place : rule.places)
                result.push_back({span, low + side * place});
        return result;
    }

    // How much |S_u x S_v| is at a sample, per unit of the parameters.
    [[nodiscard]] double stretch(int row, int column) const
    {
        return glm::length(
            glm::cross(linear_ * samples_.du(row, column), linear_ * samples_.dv(row, column)));
    }

    // By one rule, of each pair of spans; added to `sums` with `sign`.
    template <class Add>
    void integrate(std::span<const int> spansU, std::span<const int> spansV, const GaussRule& rule, Vec2 low,
                   double side, const Add& add)
    {
        evaluator_.evaluate(parameters(spansU, rule, low.x, side), parameters(spansV, rule, low.y, side),
                            samples_);
        const int points = static_cast<int>(rule.places.size());
        for (size_t a = 0; a < spansU.size(); ++a)
            for (size_t b = 0; b < spansV.size(); ++b) {
                double sum = 0;
                for (int i = 0; i < points; ++i)
                    for (int j = 0; j < points; ++j)
                        sum += rule.weights[static_cast<size_t>(i)] * rule.weights[static_cast<size_t>(j)] *
                               stretch(static_cast<int>(a) * points + i, static_cast<int>(b) * points + j);
                const double lengthU = surface_.knotsU()[spansU[a] + 1] - surface_.knotsU()[spansU[a]];
                const double lengthV = surface_.knotsV()[spansV[b] + 1] - surface_.knotsV()[spansV[b]];
                add(a * spansV.size() + b, sum * lengthU * lengthV * side * side);
            }
    }

    void addStrip(std::span<const int> spansU, std::span<const int> spansV)
    {
        const size_t first = sums_.size();
        sums_.resize(first + spansU.size() * spansV.size());
        integrate(spansU, spansV, fineGauss(), Vec2(0), 1, [&](size_t k, double sum) {
            sums_[first + k] = {sum, sum};
        });
        integrate(spansU, spansV, coarseGauss(), Vec2(0), 1,
                  [&](size_t k, double sum) { sums_[first + k].difference -= sum; });
    }

    [[nodiscard]] Sum sumOf(const Cell& cell)
    {
        Sum found;
        const std::span<const int> u(&cell.spanU, 1);
        const std::span<const int> v(&cell.spanV, 1);
        integrate(u, v, fineGauss(), cell.low, cell.side, [&](size_t, double sum) { found = {sum, sum}; });
        integrate(u, v, coarseGauss(), cell.low, cell.side,
                  [&](size_t, double sum) { found.difference -= sum; });
        return found;
    }

    void refine(const Cell& cell, const Sum& sum, double allowed, int halvings, Area& area)
    {
        const double difference = std::abs(sum.difference);
        if (difference <= allowed || halvings == kMostHalvings || quarterings_ == kMostQuarterings ||
            isOff_()) {
            area.value += sum.value;
            area.error += difference;
            return;
        }
        ++quarterings_;
        for (const Vec2 corner : {Vec2(0, 0), Vec2(0, 1), Vec2(1, 0), Vec2(1, 1)}) {
            const Cell quarter{cell.spanU, cell.spanV, cell.low + 0.5 * cell.side * corner, 0.5 * cell.side};
            refine(quarter, sumOf(quarter), std::max(0.25 * allowed, floor_), halvings + 1, area);
        }
    }

    const NurbsSurface& surface_;
    glm::dmat3 linear_;
    const std::function<bool()>& isOff_;
    const KsQuadChoice& takes_;
    GridEvaluator<double> evaluator_;
    GridSamples<double> samples_;
    std::vector<Sum> sums_;  // of each KSQuad
    double floor_ = 0;
    int quarterings_ = 0;
};

}  // namespace

Area surfaceArea(const NurbsSurface& surface, const Mat4& transform, const std::function<bool()>& isOff,
                 const KsQuadChoice& takes)
{
    return Integration(surface, transform, isOff, takes).run();
}

double meshArea(const TriangleMesh& mesh, const Mat4& transform)
{
    const glm::dmat3 linear(transform);
    double sum = 0;
    for (const Triangle& triangle : mesh.triangles) {
        const Vec3& corner = mesh.vertices[triangle[0]];
        sum += 0.5 * glm::length(glm::cross(linear * (mesh.vertices[triangle[1]] - corner),
                                            linear * (mesh.vertices[triangle[2]] - corner)));
    }
    return sum;
}

}  // namespace knotspan
