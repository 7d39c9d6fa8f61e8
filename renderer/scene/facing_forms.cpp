#include "renderer/scene/facing_forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include "model/analysis/facing.h"
#include "model/core/check.h"

namespace knotspan {

namespace {

constexpr double kFloatRounding = 0x1p-24;
constexpr double kLeastAlong =
    1e-4;  // of a ray of length 1: it then reaches far enough for no test to tell anything

// Its own coordinates: relative to the origin, in a unit that its size is about, weights of about 1.
struct LocalNet {
    BezierNet net;
    double unit = 0;      // 0: one point, or of no size that floats could tell
    double rounding = 0;  // of a point, for its length
};

double sum(const Vec3& v)
{
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

void makeLocal(const BezierNet& net, const Vec3& origin, LocalNet& local)
{
    double size = 0;
    double heaviest = 0;
    local.net = net;
    for (Vec4& point : local.net.points) {
        point = Vec4(Vec3(point) - point.w * origin, point.w);
        size = std::max(size, sum(Vec3(point)) / point.w);
        heaviest = std::max(heaviest, point.w);
    }
    constexpr double kSmallest = 1e-25;  // products of floats stay in their range
    constexpr double kLargest = 1e25;
    local.unit = 0;
    if (!(size > kSmallest && size < kLargest && heaviest > 0))
        return;
    local.unit = std::ldexp(1.0, std::ilogb(size));
    local.rounding = kFloatRounding * (1 + sum(origin) / local.unit);
    const double perWeight = 1 / heaviest;
    for (Vec4& point : local.net.points)
        point *= Vec4(Vec3(perWeight / local.unit), perWeight);
}

using Rays = std::vector<Vec4>;

// Coefficients of length 1. Those that are zero tell nothing: another stands in their place.
bool makeRays(const FacingNet& facing, Rays& rays)
{
    rays.assign(facing.points.begin(), facing.points.end());
    const Vec4* any = nullptr;
    for (Vec4& ray : rays) {
        const double length = glm::length(ray);
        if (length > 0) {
            ray *= 1 / length;
            any = &ray;
        }
    }
    if (any == nullptr)
        return false;
    std::replace(rays.begin(), rays.end(), Vec4(0), Vec4(*any));
    return true;
}

// The box's axis and the three directions across it, as facingEye() has them.
struct RayFrame {
    Vec4 axis;
    std::array<Vec4, 3> across;

    explicit RayFrame(const Vec4& direction) : axis(glm::normalize(direction))
    {
        const Vec4 mirror = axis + Vec4(axis.x < 0 ? -1 : 1, 0, 0, 0);
        for (int k = 0; k < 3; ++k) {
            across[k] = -axis[k + 1] / (1 + std::abs(axis.x)) * mirror;
            across[k][k + 1] += 1;
        }
    }
    [[nodiscard]] Vec3 operator()(const Vec4& ray) const
    {
        return 1 / glm::dot(axis, ray) *
               Vec3(glm::dot(across[0], ray), glm::dot(across[1], ray), glm::dot(across[2], ray));
    }
};

// A direction that all rays are on one side of, from their sum on towards the ones that are not: Badoiu and
// Clarkson's way to the middle of the smallest cone around them.
bool findAxis(const Rays& rays, Vec4& axis)
{
    axis = Vec4(0);
    for (const Vec4& ray : rays)
        axis += 1 / std::max(glm::length(Vec3(ray)), 0.01) * ray;
    constexpr double kWide = 0.1;
    constexpr int kSteps = 100;
    for (int step = 0;; ++step) {
        const double length = glm::length(axis);
        axis = length > 0 ? axis / length : rays.front();
        double least = 1;
        const Vec4* furthest = &rays.front();
        for (const Vec4& ray : rays) {
            const double along = glm::dot(axis, ray);
            if (along < least) {
                least = along;
                furthest = &ray;
            }
        }
        if (least > kWide || step == kSteps)
            return least > kLeastAlong;
        axis += *furthest / (2.0 + step);
    }
}

struct RayBox {
    Vec3 low{std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity()};
    double leastAlong = 1;
};

RayBox boxOf(const Rays& rays, const RayFrame& frame)
{
    RayBox box;
    for (const Vec4& ray : rays) {
        const Vec3 at = frame(ray);
        box.low = glm::min(box.low, at);
        box.high = glm::max(box.high, at);
        box.leastAlong = std::min(box.leastAlong, glm::dot(frame.axis, ray));
    }
    return box;
}

// Moves the axis to the middle of the rays' box. The box around them gets smaller, and the test stronger.
Vec4 centred(const Vec4& from, const Rays& rays)
{
    constexpr int kRounds = 3;
    Vec4 axis = from;
    Vec4 next = from;
    for (int round = 0; round < kRounds; ++round) {
        const RayFrame frame(next);
        const RayBox box = boxOf(rays, frame);
        if (!(box.leastAlong > kLeastAlong))
            return axis;
        axis = frame.axis;
        const Vec3 middle = 0.5 * (box.low + box.high);
        next =
            frame.axis + middle.x * frame.across[0] + middle.y * frame.across[1] + middle.z * frame.across[2];
    }
    return boxOf(rays, RayFrame(next)).leastAlong > kLeastAlong ? glm::normalize(next) : axis;
}

// To a half float, which has 11 digits.
float roundedUp(double value)
{
    constexpr double kSmallest = 0x1p-14;
    return glm::unpackHalf1x16(
        glm::packHalf1x16(static_cast<float>(std::max(value, kSmallest) * (1 + 0x1p-10))));
}

gpu::FacingRecord packed(const glm::vec4& axis, const glm::vec3& reach, double unit)
{
    const auto exponent = static_cast<std::uint32_t>(std::ilogb(unit) + 32768);
    return {{glm::packSnorm2x16({axis.x, axis.y}), glm::packSnorm2x16({axis.z, axis.w})},
            {glm::packHalf2x16({reach.x, reach.y}), glm::packHalf1x16(reach.z) | exponent << 16}};
}

std::uint32_t byteOf(double steps)
{
    return static_cast<std::uint32_t>(std::lrint(std::clamp(steps, -127.0, 127.0))) & 0xffU;
}

void packRays(const RayFrame& frame, const Vec3& reach, const Rays& rays, std::span<std::uint32_t> words)
{
    const Vec3 steps = 127.0 / reach;
    size_t byte = 0;
    for (size_t k = 0; k < words.size() / 3 * 4; ++k) {
        const Vec3 at = frame(rays[std::min(k, rays.size() - 1)]) * steps;  // the last one again behind it
        for (int c = 0; c < 3; ++c, ++byte)
            words[byte / 4] |= byteOf(at[c]) << 8 * (byte % 4);
    }
}

}  // namespace

// Dropped from nowhere.
gpu::FacingRecord neverFacingAway()
{
    return packed({1, 0, 0, 0}, {-1, 0, 0}, 1);
}

gpu::FacingRecord makeFacingForms(const BezierNet& net, const Vec3& origin, std::span<std::uint32_t> rays)
{
    thread_local LocalNet local;
    thread_local FacingNet facing;
    thread_local Rays sides;
    std::fill(rays.begin(), rays.end(), 0U);
    constexpr double kLost = 0x1p-14;  // of the normals
    makeLocal(net, origin, local);
    if (local.unit == 0 || local.rounding > kLost)
        return neverFacingAway();
    makeFacingNet(local.net, local.rounding, facing);
    Vec4 axis(0);
    if (!makeRays(facing, sides) || !findAxis(sides, axis))
        return neverFacingAway();

    // What the device gets is rounded; the box is for that.
    const glm::vec4 middle(centred(axis, sides));
    const RayFrame frame{Vec4(gpu::facingBoxOf(packed(middle, {}, 1)).axis)};
    const RayBox box = boxOf(sides, frame);
    const Vec3 reach = glm::max(glm::abs(box.low), glm::abs(box.high));
    const glm::vec3 up(roundedUp(reach.x), roundedUp(reach.y), roundedUp(reach.z));
    if (!rays.empty())
        packRays(frame, Vec3(up), sides, rays);
    return packed(middle, up, local.unit);
}

}  // namespace knotspan
