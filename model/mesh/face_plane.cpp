#include "model/mesh/face_plane.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace knotspan {

namespace {

// Of a span along an axis, measured across the middle of the part.
double lengthInSpace(const OutlinedFace& face, int axis, int span, const Vec2& middle)
{
    constexpr int kSteps = 8;
    double length = 0;
    Vec3 last{};
    for (int k = 0; k <= kSteps; ++k) {
        OutlinePlace place{static_cast<int>(middle.x), static_cast<int>(middle.y), glm::fract(middle)};
        (axis == 0 ? place.a : place.b) = span;
        place.t[axis] = static_cast<double>(k) / kSteps;
        const Vec3 at = face.pointAt(place);
        length += k > 0 ? glm::distance(at, last) : 0;
        last = at;
    }
    return length;
}

}  // namespace

FacePlane::FacePlane(const OutlinedFace& face, const FaceErrors& errors, const Vec2& low, const Vec2& high)
{
    std::array<int, 2> counts{};
    for (const int axis : {0, 1}) {
        const auto a = static_cast<size_t>(axis);
        counts[a] =
            static_cast<int>((axis == 0 ? face.surface().knotsU() : face.surface().knotsV()).spans().size());
        first_[a] = std::clamp(static_cast<int>(std::floor(low[axis])), 0, counts[a] - 1);
        last_[a] = std::clamp(static_cast<int>(std::ceil(high[axis])) - 1, first_[a], counts[a] - 1);
    }
    std::array<std::vector<double>, 2> widths{std::vector<double>(static_cast<size_t>(counts[0]), 1.0),
                                              std::vector<double>(static_cast<size_t>(counts[1]), 1.0)};
    int finest = 1;
    for (int a = first_[0]; a <= last_[0]; ++a)
        for (int b = first_[1]; b <= last_[1]; ++b) {
            const Grid& grid = errors.grid(a, b);
            widths[0][static_cast<size_t>(a)] = std::max(widths[0][static_cast<size_t>(a)], double(grid.u));
            widths[1][static_cast<size_t>(b)] = std::max(widths[1][static_cast<size_t>(b)], double(grid.v));
            finest = std::max({finest, grid.u, grid.v});
        }
    const Vec2 middle = glm::min(0.5 * (low + high), Vec2(counts[0], counts[1]) - 1e-9);
    for (const int axis : {0, 1}) {
        const auto k = static_cast<size_t>(axis);
        if (finest == 1)
            for (int span = first_[k]; span <= last_[k]; ++span)
                widths[k][static_cast<size_t>(span)] = lengthInSpace(face, axis, span, middle);
        double sum = 0;
        for (const double width : widths[k])
            sum += width;
        starts_[k] = {0};
        for (const double width : widths[k])
            starts_[k].push_back(starts_[k].back() + std::max(width, 1e-4 * sum));
    }
    const auto place = [&](int axis, double at) {
        const std::vector<double>& starts = starts_[static_cast<size_t>(axis)];
        const auto span =
            static_cast<size_t>(std::clamp(std::floor(at), 0.0, static_cast<double>(starts.size()) - 2));
        return starts[span] + (at - static_cast<double>(span)) * (starts[span + 1] - starts[span]);
    };
    low_ = {place(0, low.x), place(1, low.y)};
    const Vec2 size = Vec2(place(0, high.x), place(1, high.y)) - low_;
    const double largest = std::max(size.x, size.y);
    scale_ = largest > 0 ? static_cast<double>(PlaneTriangulation::kMost) / largest : 1;
}

GridPlace FacePlane::at(const OutlinePlace& place) const
{
    GridPlace result;
    for (const int axis : {0, 1}) {
        const std::vector<double>& starts = starts_[static_cast<size_t>(axis)];
        const auto span = static_cast<size_t>(axis == 0 ? place.a : place.b);
        const double t = place.t[axis];
        const double at = t == 1 ? starts[span + 1] : starts[span] + t * (starts[span + 1] - starts[span]);
        (axis == 0 ? result.x : result.y) = std::clamp(std::llround((at - low_[axis]) * scale_), 0LL,
                                                       static_cast<long long>(PlaneTriangulation::kMost));
    }
    return result;
}

}  // namespace knotspan
