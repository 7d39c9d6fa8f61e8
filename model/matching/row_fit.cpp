#include "model/matching/row_fit.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/banded_system.h"
#include "model/geometry/basis.h"

namespace knotspan {

namespace {

constexpr double kNeedToMove = 1e3;
// Keeps control points in place that no sample asks to move.
constexpr double kRest = 1e-9;

// How much each of the control points from `first` on counts at v, weights included.
struct Shares {
    int first = 0;
    int count = 0;
    BasisRow values{};
    double weight = 0;
};

Shares sharesAt(const KnotVector& along, const std::vector<ControlPoint>& row, double v)
{
    const int span = along.findSpan(v);
    Shares shares{span - along.degree(), along.degree() + 1, basisOfDegrees(along, span, v)[0], 0};
    for (int k = 0; k < shares.count; ++k) {
        double& value = shares.values[static_cast<size_t>(k)];
        value *= row[static_cast<size_t>(shares.first + k)].weight;
        shares.weight += value;
    }
    for (int k = 0; k < shares.count; ++k)
        shares.values[static_cast<size_t>(k)] /= shares.weight;
    return shares;
}

void addSample(BandedSystem& system, std::vector<double>& right, const Shares& shares,
               const RowSample& sample, double typicalScale)
{
    const double need = kNeedToMove * typicalScale / std::max(sample.scale, 1e-3 * typicalScale);
    const double needed = need * need;
    for (int a = 0; a < shares.count; ++a)
        for (int i = 0; i < 3; ++i) {
            const double share = shares.values[static_cast<size_t>(a)];
            const int row = 3 * (shares.first + a) + i;
            right[static_cast<size_t>(row)] += share * (needed + 1) * sample.needed * sample.normal[i];
            for (int b = 0; b <= a; ++b)
                for (int j = 0; j < 3; ++j)
                    system.add(row, 3 * (shares.first + b) + j,
                               share * shares.values[static_cast<size_t>(b)] *
                                   (needed * sample.normal[i] * sample.normal[j] + (i == j ? 1 : 0)));
        }
}

}  // namespace

std::vector<double> sampleParameters(const KnotVector& along, int perSpan)
{
    std::vector<double> parameters;
    for (const int span : along.spans()) {
        const double start = along[span];
        const double length = along[span + 1] - start;
        parameters.push_back(start + 1e-9 * length);
        for (int k = 0; k < perSpan; ++k)
            parameters.push_back(start + length * (k + 0.5) / perSpan);
        parameters.push_back(start + (1 - 1e-9) * length);
    }
    return parameters;
}

ControlPoint rowPoint(const KnotVector& along, const std::vector<ControlPoint>& row, double v)
{
    const Shares shares = sharesAt(along, row, v);
    const Vec3 origin = row[static_cast<size_t>(shares.first)].position;
    Vec3 sum{0};
    for (int k = 1; k < shares.count; ++k)
        sum += shares.values[static_cast<size_t>(k)] *
               (row[static_cast<size_t>(shares.first + k)].position - origin);
    return {origin + sum, shares.weight};
}

std::optional<std::vector<ControlPoint>> fittedRow(const KnotVector& along,
                                                   const std::vector<ControlPoint>& row,
                                                   const std::vector<RowSample>& samples)
{
    const int size = 3 * static_cast<int>(row.size());
    BandedSystem system(size, 3 * along.degree() + 2);
    std::vector<double> right(static_cast<size_t>(size), 0.0);
    double typicalScale = 0;
    for (const RowSample& sample : samples)
        typicalScale += sample.scale / static_cast<double>(samples.size());
    for (const RowSample& sample : samples)
        addSample(system, right, sharesAt(along, row, sample.v), sample, typicalScale);
    for (int k = 0; k < size; ++k)
        system.add(k, k, kRest);
    if (!system.factor())
        return std::nullopt;
    const std::vector<double> moves = system.solve(std::move(right));
    std::vector<ControlPoint> result = row;
    for (size_t k = 0; k < result.size(); ++k)
        result[k].position += Vec3(moves[3 * k], moves[3 * k + 1], moves[3 * k + 2]);
    return result;
}

}  // namespace knotspan
