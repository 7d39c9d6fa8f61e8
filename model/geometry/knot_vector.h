// A knot vector with its degree: which spans a curve or one direction of a surface has, and where they lie.
//
// n + 1 control points of degree p have n + p + 2 knots U_0 <= ... <= U_{n+p+1}; the domain is [U_p,
// U_{n+1}]. Clamped and unclamped (uniform, periodic) vectors are both allowed. The NURBS Book, chapter 2.
#pragma once

#include <algorithm>
#include <vector>

#include "model/core/result.h"

namespace knotspan {

constexpr int kMinDegree = 1;
constexpr int kMaxDegree = 15;

class KnotVector {
public:
    // Refuses, with a sentence: a degree outside 1..15; fewer than 2 * (degree + 1) knots; knots that are not
    // finite or decrease; an interior knot more often than `degree` times; an end knot more often than degree
    // + 1 times; a domain or a whole vector without length.
    [[nodiscard]] static Result<KnotVector> create(int degree, std::vector<double> knots);

    // 0 (degree + 1 times), 1/spans, ..., 1 (degree + 1 times).
    [[nodiscard]] static KnotVector clampedUniform(int degree, int spans);

    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] int controlPointCount() const { return static_cast<int>(knots_.size()) - degree_ - 1; }
    [[nodiscard]] const std::vector<double>& values() const { return knots_; }
    [[nodiscard]] double operator[](int index) const { return knots_[static_cast<size_t>(index)]; }
    [[nodiscard]] double domainStart() const { return knots_[static_cast<size_t>(degree_)]; }
    [[nodiscard]] double domainEnd() const { return knots_[static_cast<size_t>(controlPointCount())]; }

    // `u`, taken to the domain's nearer end where it lies outside; its start where `u` is no number.
    [[nodiscard]] double inDomain(double u) const
    {
        return u > domainStart() ? std::min(u, domainEnd()) : domainStart();
    }

    // The index i with U_i <= u < U_{i+1}; the last non-empty span at the domain's end (The NURBS Book,
    // A2.1). A parameter outside the domain is taken to its nearer end.
    [[nodiscard]] int findSpan(double u) const;

    // The indices i of the spans [U_i, U_{i+1}) of non-zero length inside the domain, increasing.
    [[nodiscard]] const std::vector<int>& spans() const { return spans_; }

    [[nodiscard]] bool operator==(const KnotVector& other) const
    {
        return degree_ == other.degree_ && knots_ == other.knots_;
    }

private:
    KnotVector(int degree, std::vector<double> knots);

    int degree_;
    std::vector<double> knots_;
    std::vector<int> spans_;
};

}  // namespace knotspan
