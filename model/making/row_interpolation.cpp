#include "model/making/row_interpolation.h"

#include <algorithm>
#include <cmath>

#include "model/core/check.h"
#include "model/geometry/basis.h"

namespace knotspan {

namespace {

using Matrix = std::vector<NumberRow>;

void subtract(NumberRow& from, double factor, const NumberRow& row)
{
    for (size_t c = 0; c < from.size(); ++c)
        from[c] -= factor * row[c];
}

// Gaussian elimination with the greatest pivot of each column; matrix * solution = right.
std::optional<Matrix> solved(Matrix matrix, Matrix right)
{
    const size_t n = matrix.size();
    for (size_t c = 0; c < n; ++c) {
        size_t pivot = c;
        for (size_t r = c + 1; r < n; ++r)
            if (std::abs(matrix[r][c]) > std::abs(matrix[pivot][c]))
                pivot = r;
        std::swap(matrix[c], matrix[pivot]);
        std::swap(right[c], right[pivot]);
        if (!(std::abs(matrix[c][c]) > 1e-14))  // the matrix' rows sum to 1
            return std::nullopt;
        for (size_t r = c + 1; r < n; ++r)
            if (matrix[r][c] != 0) {
                const double factor = matrix[r][c] / matrix[c][c];
                subtract(matrix[r], factor, matrix[c]);
                subtract(right[r], factor, right[c]);
            }
    }
    for (size_t c = n; c-- > 0;) {
        for (double& number : right[c])
            number /= matrix[c][c];
        for (size_t r = 0; r < c; ++r)
            if (matrix[r][c] != 0)
                subtract(right[r], matrix[r][c], right[c]);
    }
    return right;
}

// Row k: the basis functions at parameter k. Beyond the last unknown they begin again with the first.
Matrix collocation(const KnotVector& knots, const std::vector<double>& parameters, size_t unknowns)
{
    Matrix matrix(unknowns, NumberRow(unknowns, 0.0));
    for (size_t k = 0; k < unknowns; ++k) {
        const int span = knots.findSpan(parameters[k]);
        const BasisRow basis = basisOfDegrees(knots, span, parameters[k])[0];
        for (int r = 0; r <= knots.degree(); ++r)
            matrix[k][static_cast<size_t>(span - knots.degree() + r) % unknowns] +=
                basis[static_cast<size_t>(r)];
    }
    return matrix;
}

// Solved for what the rows differ from the first, so that numbers which all rows share stay what they are;
// then once more for what the solution misses: it is right to the rounding of its rows.
std::optional<Matrix> interpolating(const Matrix& matrix, const Matrix& rows)
{
    Matrix right = rows;
    for (NumberRow& row : right)
        subtract(row, 1, rows.front());
    auto solution = solved(matrix, right);
    if (!solution)
        return solution;
    for (size_t r = 0; r < matrix.size(); ++r)
        for (size_t c = 0; c < matrix.size(); ++c)
            if (matrix[r][c] != 0)
                subtract(right[r], matrix[r][c], (*solution)[c]);
    const auto correction = solved(matrix, std::move(right));
    for (size_t r = 0; r < matrix.size(); ++r) {
        subtract((*solution)[r], -1, (*correction)[r]);
        subtract((*solution)[r], -1, rows.front());
    }
    return solution;
}

}  // namespace

std::optional<RowSpline> splineThrough(const std::vector<double>& parameters,
                                       const std::vector<NumberRow>& rows)
{
    check(rows.size() >= 2 && parameters.size() == rows.size(), "each row has a parameter");
    const int n = static_cast<int>(rows.size());
    const int degree = std::min(3, n - 1);
    std::vector<double> values(static_cast<size_t>(degree) + 1, parameters.front());
    for (int j = 1; j < n - degree; ++j) {  // The NURBS Book, 9.8
        double sum = 0;
        for (int k = j; k < j + degree; ++k)
            sum += parameters[static_cast<size_t>(k)];
        values.push_back(sum / degree);
    }
    values.insert(values.end(), static_cast<size_t>(degree) + 1, parameters.back());
    auto knots = KnotVector::create(degree, std::move(values));
    if (!knots)
        return std::nullopt;
    auto solution = interpolating(collocation(*knots, parameters, rows.size()), rows);
    if (!solution)
        return std::nullopt;
    solution->front() = rows.front();
    solution->back() = rows.back();
    return RowSpline{*std::move(knots), *std::move(solution)};
}

std::optional<RowSpline> periodicSplineThrough(const std::vector<double>& parameters,
                                               const std::vector<NumberRow>& rows)
{
    check(rows.size() >= 3 && parameters.size() == rows.size() + 1, "each row has a parameter");
    const size_t n = rows.size();
    const double period = parameters.back() - parameters.front();
    std::vector<double> values;
    for (size_t k = n - 3; k < n; ++k)
        values.push_back(parameters[k] - period);
    values.insert(values.end(), parameters.begin(), parameters.end());
    for (size_t k = 1; k <= 3; ++k)
        values.push_back(parameters[k] + period);
    auto knots = KnotVector::create(3, std::move(values));
    if (!knots)
        return std::nullopt;
    auto solution = interpolating(collocation(*knots, parameters, n), rows);
    if (!solution)
        return std::nullopt;
    for (size_t k = 0; k < 3; ++k)
        solution->push_back(NumberRow((*solution)[k]));
    return RowSpline{*std::move(knots), *std::move(solution)};
}

}  // namespace knotspan
