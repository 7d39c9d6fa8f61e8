#include "model/analysis/shell_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/analysis/bezier_curves.h"
#include "model/geometry/grid_evaluation.h"

namespace knotspan {

namespace {

// Places and weights on [0, 1] that integrate polynomials up to degree 2 count - 1.
struct GaussRule {
    explicit GaussRule(int count)
    {
        for (int k = 0; k < count; ++k) {
            double x = std::cos(std::numbers::pi * (k + 0.75) / (count + 0.5));
            double slope = 1;
            for (int step = 0; step < 8; ++step) {
                double before = 1;
                double legendre = x;
                for (int n = 2; n <= count; ++n)
                    before = std::exchange(legendre, ((2 * n - 1) * x * legendre - (n - 1) * before) / n);
                slope = count * (x * legendre - before) / (x * x - 1);
                x -= legendre / slope;
            }
            places.push_back((1 - x) / 2);
            weights.push_back(1 / ((1 - x * x) * slope * slope));
        }
    }
    std::vector<double> places;
    std::vector<double> weights;
};

// Parameters of one direction with how much each counts, its span's length included.
struct Rule {
    Rule(const KnotVector& knots, int count)
    {
        const GaussRule gauss(count);
        for (const int span : knots.spans())
            for (size_t k = 0; k < gauss.places.size(); ++k) {
                places.push_back({span, gauss.places[k]});
                weights.push_back(gauss.weights[k] * (knots[span + 1] - knots[span]));
            }
    }
    std::vector<SpanParameter> places;
    std::vector<double> weights;
};

// In the surface's own coordinates. S (S_u x S_v) has degree 3 p - 1 where no weights differ.
SweptVolume integrated(const GridEvaluator<double>& evaluator, const NurbsSurface& surface, int more)
{
    const Rule u(surface.knotsU(), (3 * surface.degreeU() + 1) / 2 + more);
    const Rule v(surface.knotsV(), (3 * surface.degreeV() + 1) / 2 + more);
    GridSamples<double> samples;
    evaluator.evaluate(u.places, v.places, samples, Threads::one);
    SweptVolume swept;
    swept.from = samples.origin();
    for (size_t row = 0; row < u.places.size(); ++row)
        for (size_t column = 0; column < v.places.size(); ++column) {
            const auto r = static_cast<int>(row);
            const auto c = static_cast<int>(column);
            const Vec3 normal =
                u.weights[row] * v.weights[column] * glm::cross(samples.du(r, c), samples.dv(r, c));
            swept.volume += glm::dot(samples.position(r, c), normal) / 3;
            swept.area += normal;
        }
    return swept;
}

SweptVolume sweptVolumeOf(const NurbsSurface& surface, const Mat4& transform)
{
    const GridEvaluator<double> evaluator(surface, {1, false});
    SweptVolume swept = integrated(evaluator, surface, 0);
    if (surface.isRational()) {
        const SweptVolume finer = integrated(evaluator, surface, 2);
        swept.error = std::abs(finer.volume - swept.volume);
        swept.areaError = glm::length(finer.area - swept.area);
        swept.volume = finer.volume;
        swept.area = finer.area;
    }
    const glm::dmat3 linear(transform);
    const double scale = glm::determinant(linear);
    swept.from = transformed(swept.from, transform);
    swept.volume *= scale;
    swept.error *= std::abs(scale);
    // Normals go with the cofactors: M a x M b = cof(M) (a x b).
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    swept.area = cofactors * swept.area;
    swept.areaError *= glm::length(cofactors[0]) + glm::length(cofactors[1]) + glm::length(cofactors[2]);
    return swept;
}

}  // namespace

double SweptVolume::seenFrom(const Vec3& point) const
{
    return volume + glm::dot(from - point, area) / 3;
}

double SweptVolume::errorFrom(const Vec3& point) const
{
    return error + glm::distance(from, point) * areaError / 3;
}

ShellPart::ShellPart(const PlacedSurface& placed)
    : transform_(placed.transform),
      nets_(std::make_unique<const Nets>(*placed.surface)),
      spansU_(static_cast<std::uint32_t>(placed.surface->knotsU().spans().size())),
      spansV_(static_cast<std::uint32_t>(placed.surface->knotsV().spans().size())),
      mirrored_(glm::determinant(glm::dmat3(placed.transform)) < 0),
      corners_((spansU_ + 1) * (spansV_ + 1))
{
    boxes_.reserve(spansU_ * spansV_);
    for (std::uint32_t a = 0; a < spansU_; ++a)
        for (std::uint32_t b = 0; b < spansV_; ++b) {
            const BezierNet here = net(a, b);
            boxes_.push_back(boundsOf(here));
            box_.add(boxes_.back());
            for (const std::uint32_t i : {0U, 1U})
                for (const std::uint32_t j : {0U, 1U})
                    corners_[(a + i) * (spansV_ + 1) + b + j] =
                        pointOf(here.at(i == 0 ? 0 : here.degreeU, j == 0 ? 0 : here.degreeV));
        }
}

SweptVolume ShellPart::sweptVolume() const
{
    return sweptVolumeOf(nets_->surface, transform_);
}

bool ShellPart::isSameAt(std::uint32_t a, std::uint32_t b, const ShellPart& other) const
{
    const NurbsSurface& one = nets_->surface;
    const NurbsSurface& another = other.nets_->surface;
    if (transform_ != other.transform_ || one.degreeU() != another.degreeU() ||
        one.degreeV() != another.degreeV() || one.countV() != another.countV())
        return false;
    const int firstU = one.knotsU().spans()[a] - one.degreeU();
    const int firstV = one.knotsV().spans()[b] - one.degreeV();
    for (int i = firstU; i <= firstU + one.degreeU(); ++i)
        for (int j = firstV; j <= firstV + one.degreeV(); ++j)
            if (!(one.controlPoint(i, j) == another.controlPoint(i, j)))
                return false;
    return true;
}

BezierNet ShellPart::net(std::uint32_t a, std::uint32_t b) const
{
    const NurbsSurface& surface = nets_->surface;
    return knotspan::transformed(
        nets_->conversion.net({surface.knotsU().spans()[a], surface.knotsV().spans()[b]}), transform_);
}

}  // namespace knotspan
