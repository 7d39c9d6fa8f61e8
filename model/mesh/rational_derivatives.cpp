#include "model/mesh/rational_derivatives.h"

namespace knotspan {

namespace {

double binomial(int n, int k)
{
    double result = 1;
    for (int i = 1; i <= k; ++i)
        result = result * (n - k + i) / i;
    return result;
}

// A polynomial of some degree each way, its Bernstein coefficients times the binomials: a product is then the
// product of ordinary polynomials.
template <class Value>
struct Scaled {
    int degreeU = 0;
    int degreeV = 0;
    std::vector<Value> values;

    Scaled(int p, int q) : degreeU(p), degreeV(q), values(static_cast<size_t>((p + 1) * (q + 1)), Value(0)) {}
    [[nodiscard]] Value& at(int i, int j) { return values[static_cast<size_t>(i * (degreeV + 1) + j)]; }
    [[nodiscard]] const Value& at(int i, int j) const
    {
        return values[static_cast<size_t>(i * (degreeV + 1) + j)];
    }
};
using Numbers = Scaled<double>;
using Vectors = Scaled<Vec3>;

template <class Value>
Scaled<Value> product(const Numbers& f, const Scaled<Value>& g)
{
    Scaled<Value> result(f.degreeU + g.degreeU, f.degreeV + g.degreeV);
    for (int i = 0; i <= f.degreeU; ++i)
        for (int j = 0; j <= f.degreeV; ++j)
            for (int k = 0; k <= g.degreeU; ++k)
                for (int l = 0; l <= g.degreeV; ++l)
                    result.at(i + k, j + l) += f.at(i, j) * g.at(k, l);
    return result;
}

void add(Vectors& to, double factor, const Vectors& what)
{
    for (size_t k = 0; k < to.values.size(); ++k)
        to.values[k] += factor * what.values[k];
}

// A and w of a derivative.
struct Derived {
    Vectors a;
    Numbers w;
};

// The derivative of that order, all of degree 1 and above; zero where the degree leaves none.
Derived derived(const BezierNet& net, int orderU, int orderV)
{
    BezierNet at = net;
    for (int k = 0; k < orderU; ++k) {
        BezierNet next{at.degreeU - 1, at.degreeV, {}};
        for (int i = 0; i < at.degreeU; ++i)
            for (int j = 0; j <= at.degreeV; ++j)
                next.points.push_back(double(at.degreeU) * (at.at(i + 1, j) - at.at(i, j)));
        at = std::move(next);
    }
    for (int k = 0; k < orderV; ++k) {
        BezierNet next{at.degreeU, at.degreeV - 1, {}};
        for (int i = 0; i <= at.degreeU; ++i)
            for (int j = 0; j < at.degreeV; ++j)
                next.points.push_back(double(at.degreeV) * (at.at(i, j + 1) - at.at(i, j)));
        at = std::move(next);
    }
    Derived result{Vectors(at.degreeU, at.degreeV), Numbers(at.degreeU, at.degreeV)};
    for (int i = 0; i <= at.degreeU; ++i)
        for (int j = 0; j <= at.degreeV; ++j) {
            const double scale = binomial(at.degreeU, i) * binomial(at.degreeV, j);
            result.a.at(i, j) = scale * Vec3(at.at(i, j));
            result.w.at(i, j) = scale * at.at(i, j).w;
        }
    return result;
}

std::vector<Vec4> coefficients(const Vectors& scaled)
{
    std::vector<Vec4> result;
    for (int i = 0; i <= scaled.degreeU; ++i)
        for (int j = 0; j <= scaled.degreeV; ++j)
            result.emplace_back(scaled.at(i, j) / (binomial(scaled.degreeU, i) * binomial(scaled.degreeV, j)),
                                0.0);
    return result;
}

}  // namespace

std::array<std::vector<Vec4>, 3> secondDerivativesOfSurface(const BezierNet& net)
{
    const Derived f = derived(net, 0, 0);
    // w^3 S_xy = w (w A_xy - w_xy A) - w (w_x A_y + w_y A_x) + 2 w_x w_y A
    const auto second = [&](int orderU, int orderV) {
        const Derived x = orderU > 0 ? derived(net, 1, 0) : derived(net, 0, 1);
        const Derived y = orderV > 0 ? derived(net, 0, 1) : derived(net, 1, 0);
        Vectors sum = product(product(x.w, y.w), f.a);
        add(sum, 1, sum);
        add(sum, -1, product(f.w, product(x.w, y.a)));
        add(sum, -1, product(f.w, product(y.w, x.a)));
        if (net.degreeU >= orderU && net.degreeV >= orderV) {
            const Derived xy = derived(net, orderU, orderV);
            add(sum, 1, product(product(f.w, f.w), xy.a));
            add(sum, -1, product(product(f.w, xy.w), f.a));
        }
        return coefficients(sum);
    };
    return {second(2, 0), second(1, 1), second(0, 2)};
}

}  // namespace knotspan
