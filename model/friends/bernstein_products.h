// Sums and products of polynomials on [0, 1] in Bernstein form.
//
// `Poly` holds scaled coefficients: those of t^k (1-t)^(n-k), the binomial multiplied in, so that a product
// is a plain convolution and nothing cancels in it. Farouki and Rajan, Algorithms for polynomials in
// Bernstein form, CAGD 5 (1988).
#pragma once

#include <vector>

#include <glm/geometric.hpp>

#include "model/core/space.h"

namespace knotspan {

template <class T>
using Poly = std::vector<T>;
using Scalars = Poly<double>;
using Vectors = Poly<Vec3>;

// C(n, 0) ... C(n, n); n up to kMaxFormDegree.
constexpr int kMaxFormDegree = 840;  // what curvatures along rational rows of kMaxEdgeDegree need
[[nodiscard]] const std::vector<double>& binomials(int n);

// Coefficients of the Bernstein basis from scaled ones, and back.
[[nodiscard]] Scalars bernsteinOf(Scalars scaled);
[[nodiscard]] Scalars scaledOf(Scalars bernstein);
[[nodiscard]] Vectors scaledOf(Vectors bernstein);

template <class A, class B, class Multiply>
[[nodiscard]] auto product(const Poly<A>& a, const Poly<B>& b, const Multiply& multiply)
{
    using Result = decltype(multiply(a[0], b[0]));
    Poly<Result> result(a.size() + b.size() - 1, Result(0));
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t k = 0; k < b.size(); ++k)
            result[i + k] += multiply(a[i], b[k]);
    return result;
}
template <class B>
[[nodiscard]] auto operator*(const Scalars& a, const Poly<B>& b)
{
    return product(a, b, [](double x, const B& y) { return x * y; });
}
[[nodiscard]] inline Scalars dot(const Vectors& a, const Vectors& b)
{
    return product(a, b, [](const Vec3& x, const Vec3& y) { return glm::dot(x, y); });
}
[[nodiscard]] inline Vectors cross(const Vectors& a, const Vectors& b)
{
    return product(a, b, [](const Vec3& x, const Vec3& y) { return glm::cross(x, y); });
}

// The same polynomial with more coefficients.
template <class T>
[[nodiscard]] Poly<T> raised(const Poly<T>& poly, size_t degree)
{
    if (poly.size() == degree + 1)
        return poly;
    return binomials(static_cast<int>(degree + 1 - poly.size())) * poly;
}
template <class T>
[[nodiscard]] Poly<T> sum(const Poly<T>& a, const Poly<T>& b, double factorOfB = 1)
{
    const size_t degree = std::max(a.size(), b.size()) - 1;
    Poly<T> result = raised(a, degree);
    const Poly<T> other = raised(b, degree);
    for (size_t k = 0; k <= degree; ++k)
        result[k] += factorOfB * other[k];
    return result;
}
template <class T>
[[nodiscard]] Poly<T> difference(const Poly<T>& a, const Poly<T>& b)
{
    return sum(a, b, -1);
}

// Four figures that belong together, coefficients of the Bernstein basis: divided at 1/2 (de Casteljau).
using Form = std::vector<Vec4>;
void halve(Form& firstHalf, Form& secondHalf);  // `firstHalf` holds the whole before

}  // namespace knotspan
