#include "model/trimming/projected_sheet.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace knotspan {

namespace {

constexpr int kMostSteps = 30;
constexpr double kLongestStep = 0.25;  // of the domain
constexpr double kFlattest = 1e-7;     // share of the steepest that the picture of the surface may shrink to

}  // namespace

ProjectedSheet::ProjectedSheet(const NurbsSurface& surface, const PlaneProjection& projection)
    : surface_(surface),
      transform_(projection.transform),
      toPlane_(projection.toPlane * projection.transform),
      low_(surface.knotsU().domainStart(), surface.knotsV().domainStart()),
      high_(surface.knotsU().domainEnd(), surface.knotsV().domainEnd()),
      isClosed_{surface.isClosedU(), surface.isClosedV()}
{
}

bool ProjectedSheet::Picture::isEdgeOn() const
{
    return std::abs(turn()) <= kFlattest * glm::length(byU) * glm::length(byV);
}

Vec2 ProjectedSheet::acrossSeams(Vec2 at) const
{
    for (const int axis : {0, 1})
        if (isClosed_[static_cast<size_t>(axis)] && (at[axis] < low_[axis] || at[axis] > high_[axis]))
            at[axis] -= std::floor((at[axis] - low_[axis]) / size()[axis]) * size()[axis];
    return at;
}

SurfacePoint ProjectedSheet::pointAt(Vec2 at) const
{
    at = acrossSeams(at);
    const Vec2 inside = glm::clamp(at, low_, high_);
    SurfacePoint point = evaluate(surface_, inside.x, inside.y);
    point.position += (at.x - inside.x) * point.du + (at.y - inside.y) * point.dv;
    return point;
}

Vec3 ProjectedSheet::position(const Vec2& at) const
{
    return Vec3(transform_ * Vec4(pointAt(at).position, 1));
}

std::optional<ProjectedSheet::Picture> ProjectedSheet::picture(const Vec2& at) const
{
    const SurfacePoint point = pointAt(at);
    const Vec4 place = toPlane_ * Vec4(point.position, 1);
    if (!(place.w > 0))
        return std::nullopt;
    const Vec4 byU = toPlane_ * Vec4(point.du, 0);
    const Vec4 byV = toPlane_ * Vec4(point.dv, 0);
    const Vec2 where = Vec2(place.x, place.y) / place.w;
    return Picture{where, (Vec2(byU.x, byU.y) - byU.w * where) / place.w,
                   (Vec2(byV.x, byV.y) - byV.w * where) / place.w};
}

std::optional<Vec2> ProjectedSheet::placeOf(const Vec2& point, const Vec2& start) const
{
    Vec2 at = start;
    for (int step = 0; step < kMostSteps; ++step) {
        const auto now = picture(at);
        if (!now || now->isEdgeOn())
            return std::nullopt;
        Vec2 by = now->solve(point - now->at);
        const double share = std::max(std::abs(by.x) / size().x, std::abs(by.y) / size().y);
        if (!std::isfinite(share))
            return std::nullopt;
        if (share > kLongestStep)
            by *= kLongestStep / share;
        at += by;
        if (share < 1e-13)
            return at;
    }
    const auto last = picture(at);
    return last && glm::length(last->at - point) < 1e-9 * (1 + glm::length(point)) ? std::optional(at)
                                                                                   : std::nullopt;
}

}  // namespace knotspan
