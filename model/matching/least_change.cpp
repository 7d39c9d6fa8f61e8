#include "model/matching/least_change.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

struct UnitRow {
    std::vector<double> coefficients;
    Vec3 right{0};
};

double dot(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0;
    for (size_t k = 0; k < a.size(); ++k)
        sum += a[k] * b[k];
    return sum;
}

}  // namespace

// Conditions are made orthonormal one after the other; the answer is then their combination.
std::optional<std::vector<Vec3>> leastChange(int unknowns, const std::vector<LinearCondition>& conditions,
                                             double slack)
{
    std::vector<UnitRow> rows;
    for (const LinearCondition& condition : conditions) {
        UnitRow row{std::vector<double>(static_cast<size_t>(unknowns), 0.0), condition.right};
        for (const auto& [unknown, coefficient] : condition.terms)
            row.coefficients[static_cast<size_t>(unknown)] += coefficient;
        const double size = std::sqrt(dot(row.coefficients, row.coefficients));
        for (int pass = 0; pass < 2; ++pass)  // the second removes what rounding left
            for (const UnitRow& other : rows) {
                const double part = dot(row.coefficients, other.coefficients);
                for (size_t k = 0; k < row.coefficients.size(); ++k)
                    row.coefficients[k] -= part * other.coefficients[k];
                row.right -= part * other.right;
            }
        const double left = std::sqrt(dot(row.coefficients, row.coefficients));
        if (!(left > 1e-9 * size)) {
            if (!(glm::length(row.right) <= slack))
                return std::nullopt;
            continue;
        }
        for (double& coefficient : row.coefficients)
            coefficient /= left;
        row.right /= left;
        rows.push_back(std::move(row));
    }
    std::vector<Vec3> result(static_cast<size_t>(unknowns), Vec3(0));
    for (const UnitRow& row : rows)
        for (size_t k = 0; k < result.size(); ++k)
            result[k] += row.coefficients[k] * row.right;
    return result;
}

}  // namespace knotspan
