#include "model/refining/spline_fit.h"

#include <array>
#include <set>

#include "model/core/check.h"
#include "model/geometry/banded_system.h"
#include "model/geometry/basis.h"

namespace knotspan {

namespace {

// The basis functions of a spline space at one place.
struct Sample {
    int first = 0;
    BasisRow basis{};
};

Sample sampleAt(const KnotVector& knots, double t)
{
    const int span = knots.findSpan(t);
    return {span - knots.degree(), basisOfDegrees(knots, span, t)[0]};
}

// Places inside every span that both have.
std::vector<double> placesFor(const KnotVector& a, const KnotVector& b)
{
    std::set<double> cuts;
    for (const KnotVector* const knots : {&a, &b})
        for (const int span : knots->spans()) {
            cuts.insert((*knots)[span]);
            cuts.insert((*knots)[span + 1]);
        }
    const int count = std::max(a.degree(), b.degree()) + 2;
    std::vector<double> places;
    for (auto low = cuts.begin(), high = std::next(low); high != cuts.end(); ++low, ++high)
        for (int k = 0; k < count; ++k)
            places.push_back(*low + (*high - *low) * (k + 0.5) / count);
    return places;
}

// Least squares of one row of numbers after the other.
class Fitting {
public:
    Fitting(const KnotVector& from, const KnotVector& to)
        : from_(from),
          to_(to),
          inner_(to.controlPointCount() - 2),
          system_(std::max(inner_, 1), to.degree())
    {
        for (const double place : placesFor(from, to)) {
            before_.push_back(sampleAt(from, place));
            after_.push_back(sampleAt(to, place));
        }
        if (inner_ <= 0)
            return;
        for (const Sample& sample : after_)
            for (int i = 0; i <= to.degree(); ++i)
                for (int k = 0; k <= i; ++k)
                    if (isInner(sample.first + i) && isInner(sample.first + k))
                        system_.add(sample.first + i - 1, sample.first + k - 1,
                                    sample.basis[static_cast<size_t>(i)] *
                                        sample.basis[static_cast<size_t>(k)]);
        check(system_.factor(), "every control point is seen by a sample");
    }

    [[nodiscard]] std::vector<double> fitted(const std::vector<double>& row) const
    {
        std::vector<double> result(static_cast<size_t>(inner_ + 2), 0.0);
        result.front() = row.front();
        result.back() = row.back();
        // Once more for what the first solution leaves.
        for (int round = 0; round < 2 && inner_ > 0; ++round) {
            std::vector<double> right(static_cast<size_t>(inner_), 0.0);
            for (size_t s = 0; s < after_.size(); ++s) {
                const double left = valueAt(before_[s], from_, row) - valueAt(after_[s], to_, result);
                for (int i = 0; i <= to_.degree(); ++i)
                    if (isInner(after_[s].first + i))
                        right[static_cast<size_t>(after_[s].first + i - 1)] +=
                            after_[s].basis[static_cast<size_t>(i)] * left;
            }
            const std::vector<double> change = system_.solve(std::move(right));
            for (size_t k = 0; k < change.size(); ++k)
                result[k + 1] += change[k];
        }
        return result;
    }

private:
    [[nodiscard]] bool isInner(int point) const { return point > 0 && point <= inner_; }
    [[nodiscard]] static double valueAt(const Sample& sample, const KnotVector& knots,
                                        const std::vector<double>& row)
    {
        double sum = 0;
        for (int i = 0; i <= knots.degree(); ++i)
            sum += sample.basis[static_cast<size_t>(i)] * row[static_cast<size_t>(sample.first + i)];
        return sum;
    }

    const KnotVector& from_;
    const KnotVector& to_;
    int inner_;
    BandedSystem system_;
    std::vector<Sample> before_;
    std::vector<Sample> after_;
};

}  // namespace

Result<NurbsSurface> fittedTo(const NurbsSurface& given, Direction direction, const KnotVector& knots)
{
    const bool byU = direction == Direction::U;
    const KnotVector& old = byU ? given.knotsU() : given.knotsV();
    check(knots.domainStart() == old.domainStart() && knots.domainEnd() == old.domainEnd(),
          "a surface is fitted over its own domain");
    const NurbsSurface surface = clampedPart(given, direction, old.domainStart(), old.domainEnd());
    const KnotVector& from = byU ? surface.knotsU() : surface.knotsV();
    const Fitting fitting(from, knots);
    const Vec3 centre = surface.bounds().centre();
    const int rows = byU ? surface.countV() : surface.countU();
    const int count = knots.controlPointCount();
    std::vector<ControlPoint> points(static_cast<size_t>(rows) * static_cast<size_t>(count));
    for (int row = 0; row < rows; ++row) {
        std::array<std::vector<double>, 4> columns;
        for (int k = 0; k < from.controlPointCount(); ++k) {
            const ControlPoint& point = byU ? surface.controlPoint(k, row) : surface.controlPoint(row, k);
            const Vec3 weighted = point.weight * (point.position - centre);
            for (int axis = 0; axis < 3; ++axis)
                columns[static_cast<size_t>(axis)].push_back(weighted[axis]);
            columns[3].push_back(point.weight);
        }
        const bool rational = surface.isRational();
        for (size_t axis = 0; axis < 4; ++axis)
            columns[axis] = axis < 3 || rational
                                ? fitting.fitted(columns[axis])
                                : std::vector<double>(static_cast<size_t>(count), columns[3].front());
        for (int k = 0; k < count; ++k) {
            const auto at = static_cast<size_t>(k);
            const double weight = columns[3][at];
            if (!(weight > 0))
                return failure("The weights vary too much for so few knots",
                               "Keep more knots, or a higher degree");
            ControlPoint& point = points[static_cast<size_t>(byU ? k * rows + row : row * count + k)];
            point = {centre + Vec3(columns[0][at], columns[1][at], columns[2][at]) / weight, weight};
            if (k == 0 || k == count - 1) {
                const int last = k == 0 ? 0 : from.controlPointCount() - 1;
                point = byU ? surface.controlPoint(last, row) : surface.controlPoint(row, last);
            }
        }
    }
    return NurbsSurface::create(byU ? knots : surface.knotsU(), byU ? surface.knotsV() : knots,
                                std::move(points));
}

}  // namespace knotspan
