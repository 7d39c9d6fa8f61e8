#include "model/friends/bernstein_products.h"

#include "model/core/check.h"

namespace knotspan {

const std::vector<double>& binomials(int n)
{
    static const std::vector<std::vector<double>> kRows = [] {
        std::vector<std::vector<double>> rows(kMaxFormDegree + 1);
        for (size_t row = 0; row < rows.size(); ++row) {
            rows[row].assign(row + 1, 1.0);
            for (size_t k = 1; k < row; ++k)
                rows[row][k] = rows[row - 1][k - 1] + rows[row - 1][k];
        }
        return rows;
    }();
    check(n >= 0 && n <= kMaxFormDegree, "a product's degree is in the table of binomials");
    return kRows[static_cast<size_t>(n)];
}

Scalars bernsteinOf(Scalars scaled)
{
    const auto& factors = binomials(static_cast<int>(scaled.size()) - 1);
    for (size_t k = 0; k < scaled.size(); ++k)
        scaled[k] /= factors[k];
    return scaled;
}

Scalars scaledOf(Scalars bernstein)
{
    const auto& factors = binomials(static_cast<int>(bernstein.size()) - 1);
    for (size_t k = 0; k < bernstein.size(); ++k)
        bernstein[k] *= factors[k];
    return bernstein;
}

Vectors scaledOf(Vectors bernstein)
{
    const auto& factors = binomials(static_cast<int>(bernstein.size()) - 1);
    for (size_t k = 0; k < bernstein.size(); ++k)
        bernstein[k] *= factors[k];
    return bernstein;
}

void halve(Form& firstHalf, Form& secondHalf)
{
    const size_t degree = firstHalf.size() - 1;
    secondHalf.resize(degree + 1);
    for (size_t level = 0; level <= degree; ++level) {
        secondHalf[degree - level] = firstHalf[degree];
        for (size_t k = degree; k > level; --k)
            firstHalf[k] = 0.5 * (firstHalf[k - 1] + firstHalf[k]);
    }
}

}  // namespace knotspan
