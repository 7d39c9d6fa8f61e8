#include "model/analysis/pixel_painter.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace knotspan {

namespace {

constexpr double kGap = 0.1;  // pixels: that close to a triangle is covered, too

double beforeNear(const Vec4& point)
{
    return point.w - point.z;
}

Vec4 onNear(const Vec4& a, const Vec4& b)
{
    const double da = beforeNear(a);
    return a + (b - a) * (da / (da - beforeNear(b)));
}

Vec2 pixel(const Vec4& point)
{
    return Vec2(point) / point.w;
}

}  // namespace

PixelPainter::PixelPainter(int width, int height, double margin) : margin_(margin)
{
    const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
    covered_ = {width, height, std::vector<std::uint8_t>(pixels, 0)};
    keptOff_.assign(pixels, 0);
}

PixelPainter::PixelRange PixelPainter::pixelsAround(Vec2 low, Vec2 high, double reach) const
{
    const Vec2 size(covered_.width, covered_.height);
    const Vec2 first = glm::clamp(glm::ceil(low - reach - 0.5), Vec2(0), size);
    const Vec2 end = glm::clamp(glm::floor(high + reach - 0.5) + 1.0, Vec2(0), size);
    return {static_cast<int>(first.x), static_cast<int>(end.x), static_cast<int>(first.y),
            static_cast<int>(end.y)};
}

void PixelPainter::cover(const Vec4& a, const Vec4& b, const Vec4& c)
{
    const Vec4 corners[] = {a, b, c};
    std::vector<Vec2> shown;
    std::vector<Vec4> cut;
    for (int k = 0; k < 3; ++k) {
        const Vec4& here = corners[k];
        const Vec4& next = corners[(k + 1) % 3];
        const bool shows = beforeNear(here) >= 0;
        if (shows)
            shown.push_back(pixel(here));
        if (shows != (beforeNear(next) >= 0)) {
            cut.push_back(onNear(here, next));
            shown.push_back(pixel(cut.back()));
        }
    }
    if (cut.size() == 2)
        keepOff(pixel(cut[0]), pixel(cut[1]), keptOff_);
    if (shown.size() >= 3)
        coverConvex(shown);
}

void PixelPainter::coverConvex(const std::vector<Vec2>& corners)
{
    double area = 0;
    Vec2 low = corners[0];
    Vec2 high = corners[0];
    for (size_t k = 0; k < corners.size(); ++k) {
        const Vec2 along = corners[k] - corners[0];
        const Vec2 next = corners[(k + 1) % corners.size()] - corners[0];
        area += along.x * next.y - along.y * next.x;
        low = glm::min(low, corners[k]);
        high = glm::max(high, corners[k]);
    }
    if (area == 0)
        return;
    // Positive inside, in pixels: distance from each edge.
    std::vector<Vec3> edges;
    for (size_t k = 0; k < corners.size(); ++k) {
        const Vec2 along = corners[(k + 1) % corners.size()] - corners[k];
        const double length = glm::length(along);
        if (length == 0)
            continue;
        const Vec2 inwards = Vec2(-along.y, along.x) * (area > 0 ? 1.0 : -1.0) / length;
        edges.emplace_back(inwards, -glm::dot(inwards, corners[k]));
    }
    const PixelRange range = pixelsAround(low, high, kGap);
    for (int y = range.firstY; y < range.endY; ++y)
        for (int x = range.firstX; x < range.endX; ++x) {
            const Vec3 centre(x + 0.5, y + 0.5, 1.0);
            if (std::all_of(edges.begin(), edges.end(),
                            [&](const Vec3& edge) { return glm::dot(edge, centre) >= -kGap; }))
                covered_.covered[covered_.index(x, y)] = 1;
        }
}

void PixelPainter::keepOff(Vec4 a, Vec4 b)
{
    const bool showsA = beforeNear(a) >= 0;
    const bool showsB = beforeNear(b) >= 0;
    if (!showsA && !showsB)
        return;
    if (showsA != showsB)
        (showsA ? b : a) = onNear(a, b);
    keepOff(pixel(a), pixel(b), keptOff_);
}

void PixelPainter::keepOff(const Vec2& a, const Vec2& b, std::vector<std::uint8_t>& kept) const
{
    const Vec2 along = b - a;
    const double squared = glm::dot(along, along);
    const PixelRange range = pixelsAround(glm::min(a, b), glm::max(a, b), margin_);
    for (int y = range.firstY; y < range.endY; ++y)
        for (int x = range.firstX; x < range.endX; ++x) {
            const Vec2 from = Vec2(x + 0.5, y + 0.5) - a;
            const double at = squared > 0 ? std::clamp(glm::dot(from, along) / squared, 0.0, 1.0) : 0.0;
            const Vec2 aside = from - along * at;
            if (glm::dot(aside, aside) <= margin_ * margin_)
                kept[covered_.index(x, y)] = 1;
        }
}

PixelMask PixelPainter::mask() const
{
    std::vector<std::uint8_t> kept = keptOff_;
    const auto isCovered = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < covered_.width && y < covered_.height && covered_.at(x, y);
    };
    for (int y = 0; y < covered_.height; ++y)
        for (int x = 0; x < covered_.width; ++x)
            if (!covered_.at(x, y) &&
                (isCovered(x - 1, y) || isCovered(x + 1, y) || isCovered(x, y - 1) || isCovered(x, y + 1))) {
                const Vec2 centre(x + 0.5, y + 0.5);
                keepOff(centre, centre, kept);
            }
    PixelMask mask = covered_;
    for (size_t k = 0; k < kept.size(); ++k)
        if (kept[k] != 0)
            mask.covered[k] = 0;
    return mask;
}

}  // namespace knotspan
