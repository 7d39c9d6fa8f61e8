#include "model/geometry/difference_nets.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace knotspan {

namespace {

// degree / (U_{i+p+1} - U_{i+1}) for each control point of the derivative of order `order` (1: of the points
// themselves); 0 where there is no span to it. One more, so that a difference of the last ones may be formed.
std::vector<double> factors(const KnotVector& knots, int order)
{
    const int p = knots.degree();
    std::vector<double> result(static_cast<size_t>(knots.controlPointCount() + 1));
    for (int i = 0; i + order < knots.controlPointCount(); ++i)
        if (const double length = knots[i + p + 1] - knots[i + order]; length > 0)
            result[static_cast<size_t>(i)] = (p + 1 - order) / length;
    return result;
}

double weightScale(const NurbsSurface& surface)
{
    double heaviest = 0;
    for (const ControlPoint& point : surface.controlPoints())
        heaviest = std::max(heaviest, point.weight);
    return std::exp2(-std::floor(std::log2(heaviest)));
}

template <class Real, int C>
class NetMaker {
public:
    NetMaker(const NurbsSurface& surface, const Vec3& origin)
        : points_(surface.controlPoints().data()),
          countU_(surface.countU()),
          countV_(surface.countV()),
          origin_(origin),
          weightScale_(weightScale(surface))
    {
        for (int order = 1; order <= 2; ++order) {
            factorsU_[order - 1] = factors(surface.knotsU(), order);
            factorsV_[order - 1] = factors(surface.knotsV(), order);
        }
    }

    [[nodiscard]] DifferenceNet<Real> net(int orderU, int orderV) const
    {
        switch (orderU * 3 + orderV) {
        case 0:
            return filled(0, 0, [this](int i, int j) { return point(i, j); });
        case 3:
            return filled(1, 0, [this](int i, int j) { return du(i, j); });
        case 1:
            return filled(0, 1, [this](int i, int j) { return dv(i, j); });
        case 6:
            return filled(2, 0, [this](int i, int j) {
                return factorsU_[1][static_cast<size_t>(i)] * (du(i + 1, j) - du(i, j));
            });
        case 4:
            return filled(1, 1, [this](int i, int j) {
                return factorsV_[0][static_cast<size_t>(j)] * (du(i, j + 1) - du(i, j));
            });
        default:
            return filled(0, 2, [this](int i, int j) {
                return factorsV_[1][static_cast<size_t>(j)] * (dv(i, j + 1) - dv(i, j));
            });
        }
    }

private:
    // Sums of products with basis functions and quotients of them stay finite below this.
    static constexpr double kLargest = std::numeric_limits<Real>::max() / 1e6;

    [[nodiscard]] const ControlPoint& at(int i, int j) const
    {
        return points_[static_cast<size_t>(i) * static_cast<size_t>(countV_) + static_cast<size_t>(j)];
    }

    [[nodiscard]] double weight(const ControlPoint& point) const
    {
        // Not zero: a point of no weight that shapes a KSQuad alone would be nowhere. Nor so small that a
        // second derivative, a sum over the square of the weight, would be beyond the range.
        constexpr double kLightest = sizeof(Real) == 4 ? 1e-12 : 1e-120;
        return C == 3 ? 1.0 : std::max(point.weight * weightScale_, kLightest);
    }

    [[nodiscard]] Vec4 point(int i, int j) const
    {
        const double w = weight(at(i, j));
        return {w * glm::clamp(at(i, j).position - origin_, -kLargest, kLargest), w};
    }

    // From differences of positions and of weights, so that points which almost coincide cancel nothing:
    // w1 p1 - w0 p0 = w1 (p1 - p0) + (w1 - w0) p0.
    [[nodiscard]] Vec4 difference(const ControlPoint& from, const ControlPoint& to) const
    {
        const Vec3 step = to.position - from.position;
        if constexpr (C == 3)
            return {step, 0.0};
        const double w = weight(to);
        const double growth = w - weight(from);
        return {w * step + growth * (from.position - origin_), growth};
    }
    [[nodiscard]] Vec4 du(int i, int j) const
    {
        return factorsU_[0][static_cast<size_t>(i)] * difference(at(i, j), at(i + 1, j));
    }
    [[nodiscard]] Vec4 dv(int i, int j) const
    {
        return factorsV_[0][static_cast<size_t>(j)] * difference(at(i, j), at(i, j + 1));
    }

    template <class Value>
    [[nodiscard]] DifferenceNet<Real> filled(int orderU, int orderV, const Value& value) const
    {
        DifferenceNet<Real> net{
            orderU, orderV, std::max(countU_ - orderU, 0), std::max(countV_ - orderV, 0), {}, {}, {}};
        const size_t row = static_cast<size_t>(net.countV);
        const size_t size = static_cast<size_t>(net.countU) * C * row;
        net.numbers.reset(new Real[size + DifferenceNets<Real>::kPadding]);
        net.largestOfI.resize(static_cast<size_t>(net.countU));
        net.largestOfJ.resize(row);
        for (int i = 0; i < net.countU; ++i) {
            Real* to = net.numbers.get() + static_cast<size_t>(i) * C * row;
            Real largestOfI = 0;
            for (size_t j = 0; j < row; ++j, ++to) {
                const Vec4 h = value(i, static_cast<int>(j));
                Real largest = 0;
                for (int c = 0; c < C; ++c) {
                    // Differences of infinities are no numbers; they become 0.
                    const double finite = h[c] == h[c] ? h[c] : 0.0;
                    const auto number = static_cast<Real>(std::min(std::max(finite, -kLargest), kLargest));
                    to[static_cast<size_t>(c) * row] = number;
                    largest = std::max(largest, std::abs(number));
                }
                largestOfI = std::max(largestOfI, largest);
                net.largestOfJ[j] = std::max(net.largestOfJ[j], largest);
            }
            net.largestOfI[static_cast<size_t>(i)] = largestOfI;
        }
        std::fill_n(net.numbers.get() + size, DifferenceNets<Real>::kPadding, Real(0));
        return net;
    }

    const ControlPoint* points_;
    int countU_;
    int countV_;
    Vec3 origin_;
    double weightScale_;
    std::vector<double> factorsU_[2];
    std::vector<double> factorsV_[2];
};

template <class Real, int C>
std::vector<DifferenceNet<Real>> netsOf(const NurbsSurface& surface, const Vec3& origin, int order)
{
    const NetMaker<Real, C> maker(surface, origin);
    std::vector<DifferenceNet<Real>> nets;
    for (int total = 0; total <= order; ++total)
        for (int orderV = 0; orderV <= total; ++orderV)
            nets.push_back(maker.net(total - orderV, orderV));
    return nets;
}

}  // namespace

template <class Real>
DifferenceNets<Real>::DifferenceNets(const NurbsSurface& surface, int order)
    : origin(surface.bounds().centre()),
      components(surface.isRational() ? 4 : 3),
      nets(components == 4 ? netsOf<Real, 4>(surface, origin, order)
                           : netsOf<Real, 3>(surface, origin, order))
{
}

template struct DifferenceNets<float>;
template struct DifferenceNets<double>;

}  // namespace knotspan
