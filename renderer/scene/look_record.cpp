#include "renderer/scene/look_record.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace knotspan {

static_assert(static_cast<int>(Shading::error) == SHADING_ERROR &&
              static_cast<int>(Shading::draft) == SHADING_DRAFT &&
              static_cast<int>(Shading::checker) == SHADING_CHECKER &&
              static_cast<int>(Shading::deviation) == SHADING_DEVIATION);
static_assert(static_cast<int>(CurvatureKind::mean) == LOOK_MEAN &&
              static_cast<int>(CurvatureKind::smallest) == LOOK_SMALLEST);
static_assert(static_cast<int>(Matcap::clay) == LOOK_CLAY && static_cast<int>(Matcap::pearl) == LOOK_PEARL);

namespace {

std::uint32_t kindOf(Shading shading, const Look& look)
{
    switch (shading) {
    case Shading::matcap:
        return static_cast<std::uint32_t>(look.matcap);
    case Shading::curvature:
        return static_cast<std::uint32_t>(look.curvature);
    default:
        return 0;
    }
}

double countOf(Shading shading, const Look& look, double size)
{
    if (shading != Shading::checker)
        return std::clamp(look.stripes, 1, kMostStripes);
    if (look.checker == CheckerBy::length)
        return 1 / look.checkerLength.value_or(checkerLengthFor(size));
    return std::clamp(look.checkerCells, 1, kMostCheckerCells);
}

}  // namespace

void fillLook(gpu::FrameRecord& record, Shading shading, const Look& look, const Camera& camera, double size,
              const NumberRange& numbers)
{
    record.shading = static_cast<std::uint32_t>(shading);
    record.lookKind = kindOf(shading, look);
    record.lookCount = static_cast<float>(countOf(shading, look, size));
    Vec3 axis;
    NumberRange range = numbers;
    if (shading == Shading::draft) {
        axis = Vec3(camera.rotation() * Vec4(look.pull, 0));
        range = {-look.draftDegrees, look.draftDegrees};
    } else {
        const double turned = glm::radians(look.stripesTurnedDegrees);
        axis = {-std::sin(turned), std::cos(turned), 0};
    }
    record.lookAxis = glm::length(axis) > 0 ? gpu::vec3(glm::normalize(axis)) : gpu::vec3(0, 0, 1);
    record.lookRange = {static_cast<float>(range.low), static_cast<float>(range.high)};
}

}  // namespace knotspan
