#include "model/analysis/facing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/geometry/facing_kernels.h"

namespace knotspan {

namespace {

using Plane = std::vector<double>;

std::vector<double> binomials(int n)
{
    std::vector<double> row{1.0};
    for (int k = 1; k <= n; ++k)
        row.push_back(row.back() * (n - k + 1) / k);
    return row;
}

// Products of polynomials in two variables are taken as products in one: a coefficient of u^i v^j, times its
// binomials, is number i * stride + j, with a stride that leaves room for the last product's v. Loops over
// them are long and simple.
//
// T = p q [u Y0 ^ (X10 ^ X11) - (1 - u) Y1 ^ (X00 ^ X01)], X = (1-u)(1-v) X00 + u (1-v) X10 + (1-u) v X01 + u
// v X11 and X = (1-u) Y0 + u Y1: nets that are the surface's own without its first (1) or last (0) points
// along u, and v.
class Workspace {
public:
    void prepare(int degreeU, int degreeV);
    void multiply(const BezierNet& net);
    void take(std::vector<Vec4>& points) const;
    // The sum of the lengths of all that is added up for each coefficient.
    [[nodiscard]] std::vector<double> largestSums(const BezierNet& net) const;

private:
    [[nodiscard]] size_t place(int i, int j) const
    {
        return static_cast<size_t>(i) * stride_ + static_cast<size_t>(j);
    }
    void multiplyHalf(const BezierNet& net, int a);
    [[nodiscard]] double* minors(int a)
    {
        return minors_.data() + 6 * pitch_ * static_cast<size_t>(a) + front_;
    }

    int p_ = 0;
    int q_ = 0;
    size_t stride_ = 0;
    size_t minorCount_ = 0;
    size_t sumCount_ = 0;
    size_t front_ = 0;  // zeros before each plane
    size_t pitch_ = 0;
    std::vector<double> lowerU_;  // binomials of p - 1, q - 1 and q
    std::vector<double> lowerV_;
    std::vector<double> fullV_;
    Plane scales_;  // p q / (binomials of T)
    Plane points_;  // x, y, z, w of a net
    Plane minors_;  // xy, xz, xw, yz, yw, zw of both halves
    Plane sums_;
    std::vector<kernels::FacingTerm> terms_;
};

void Workspace::prepare(int degreeU, int degreeV)
{
    if (p_ == degreeU && q_ == degreeV)
        return;
    p_ = degreeU;
    q_ = degreeV;
    stride_ = static_cast<size_t>(3 * q_ - 1);
    minorCount_ = place(2 * p_ - 2, 2 * q_ - 1);
    sumCount_ = place(3 * p_ - 1, 0);
    front_ = place(p_, q_);
    pitch_ = front_ + sumCount_ + 2 * kernels::kFacingPadding;
    lowerU_ = binomials(p_ - 1);
    lowerV_ = binomials(q_ - 1);
    fullV_ = binomials(q_);
    scales_.clear();
    for (const double alongU : binomials(3 * p_ - 2))
        for (const double alongV : binomials(3 * q_ - 2))
            scales_.push_back(p_ * q_ / (alongU * alongV));
    scales_.resize(pitch_, 0.0);
    points_.assign(4 * pitch_, 0.0);
    minors_.assign(12 * pitch_, 0.0);
    sums_.assign(4 * pitch_, 0.0);
}

// Xa0 ^ Xa1.
void Workspace::multiplyHalf(const BezierNet& net, int a)
{
    double* const points = points_.data() + front_;
    terms_.clear();
    for (int i = 0; i < p_; ++i)
        for (int j = 0; j < q_; ++j) {
            const double scale = lowerU_[i] * lowerV_[j];
            const Vec4 second = scale * net.at(i + a, j + 1);
            for (int c = 0; c < 4; ++c)
                points[static_cast<size_t>(c) * pitch_ + place(i, j)] = second[c];
            const Vec4 first = scale * net.at(i + a, j);
            terms_.push_back({first.x, first.y, first.z, first.w, points - place(i, j)});
        }
    kernels::sumFacingMinors(terms_.data(), terms_.size(), pitch_, minorCount_, minors(a));
}

void Workspace::multiply(const BezierNet& net)
{
    multiplyHalf(net, 0);
    multiplyHalf(net, 1);
    terms_.clear();
    for (int a = 0; a < 2; ++a)
        for (int i = 0; i < p_; ++i)
            for (int j = 0; j <= q_; ++j) {
                const double scale = (a == 0 ? -1 : 1) * lowerU_[i] * fullV_[j];
                const Vec4 point = scale * net.at(i + 1 - a, j);
                terms_.push_back({point.x, point.y, point.z, point.w, minors(a) - place(i + a, j)});
            }
    kernels::sumFacingProducts(terms_.data(), terms_.size(), pitch_, sumCount_, scales_.data(), sums_.data());
}

void Workspace::take(std::vector<Vec4>& points) const
{
    points.resize(sumCount_);
    const double* const sums = sums_.data();
    for (size_t k = 0; k < sumCount_; ++k)
        points[k] = {sums[k], sums[pitch_ + k], sums[2 * pitch_ + k], sums[3 * pitch_ + k]};
}

std::vector<double> Workspace::largestSums(const BezierNet& net) const
{
    std::vector<double> sums(sumCount_, 0.0);
    for (int a = 0; a < 2; ++a) {
        std::vector<double> pairs(minorCount_, 0.0);
        for (int i = 0; i < p_; ++i)
            for (int j = 0; j < q_; ++j)
                for (int k = 0; k < p_; ++k)
                    for (int l = 0; l < q_; ++l)
                        pairs[place(i + k, j + l)] += lowerU_[i] * lowerV_[j] * lowerU_[k] * lowerV_[l] *
                                                      glm::length(net.at(i + a, j)) *
                                                      glm::length(net.at(k + a, l + 1));
        for (int i = 0; i < p_; ++i)
            for (int j = 0; j <= q_; ++j) {
                const double size = lowerU_[i] * fullV_[j] * glm::length(net.at(i + 1 - a, j));
                for (size_t m = 0; m < pairs.size(); ++m)
                    sums[place(i + a, j) + m] += size * pairs[m];
            }
    }
    for (size_t k = 0; k < sums.size(); ++k)
        sums[k] *= scales_[k];
    return sums;
}

}  // namespace

void makeFacingNet(const BezierNet& net, double rounding, FacingNet& facing)
{
    check(net.degreeU >= 1 && net.degreeV >= 1, "a surface has both directions");
    thread_local Workspace work;
    work.prepare(net.degreeU, net.degreeV);
    work.multiply(net);
    work.take(facing.points);
    facing.degreeU = 3 * net.degreeU - 2;
    facing.degreeV = 3 * net.degreeV - 2;

    double least = std::numeric_limits<double>::infinity();  // squared
    double largest = 0;
    for (const Vec4& point : facing.points) {
        least = std::min(least, glm::dot(point, point));
        largest = std::max(largest, glm::dot(point, point));
    }
    // Most nets have no coefficient that is that small.
    constexpr double kSuspect = 1e-3;
    if (least > kSuspect * kSuspect * largest)
        return;
    const std::vector<double> sums = work.largestSums(net);
    for (size_t k = 0; k < facing.points.size(); ++k)
        if (!(glm::length(facing.points[k]) > rounding * sums[k]))
            facing.points[k] = Vec4(0);
}

FacingNet facingNet(const BezierNet& net, double rounding)
{
    FacingNet facing;
    makeFacingNet(net, rounding, facing);
    return facing;
}

bool facesAway(const FacingNet& facing, const Vec4& eye, double margin)
{
    const double least = margin * glm::length(eye);
    bool any = false;
    for (const Vec4& point : facing.points) {
        if (point == Vec4(0))
            continue;
        const double along = glm::dot(point, eye);
        if (!(along < 0) || along > -least * glm::length(point))
            return false;
        any = true;
    }
    return any;
}

}  // namespace knotspan
