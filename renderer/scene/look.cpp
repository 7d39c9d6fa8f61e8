#include "renderer/scene/look.h"

#include <algorithm>
#include <cmath>

#include "shaders/shared/colour_ramp.glsl"

namespace knotspan {

namespace {

template <class Info>
auto found(const std::vector<Info>& list, std::string_view name) -> std::optional<decltype(Info::id)>
{
    const auto at =
        std::find_if(list.begin(), list.end(), [&](const Info& info) { return info.name == name; });
    if (at == list.end())
        return std::nullopt;
    return at->id;
}

}  // namespace

const std::vector<CurvatureKindInfo>& curvatureKinds()
{
    static const std::vector<CurvatureKindInfo> list = {
        {CurvatureKind::mean, "mean", "Half the sum of both principal curvatures"},
        {CurvatureKind::gauss, "gauss", "Their product: bowls and domes above zero, saddles below"},
        {CurvatureKind::largest, "k1", "The larger principal curvature"},
        {CurvatureKind::smallest, "k2", "The smaller principal curvature"}};
    return list;
}

std::optional<CurvatureKind> findCurvatureKind(std::string_view name)
{
    return found(curvatureKinds(), name);
}

const std::vector<MatcapInfo>& matcaps()
{
    static const std::vector<MatcapInfo> list = {
        {Matcap::clay, "clay", "Warm and dull: shape alone"},
        {Matcap::chrome, "chrome", "A mirror with a horizon: waves show"},
        {Matcap::pearl, "pearl", "Hues that change with the slope"}};
    return list;
}

std::optional<Matcap> findMatcap(std::string_view name)
{
    return found(matcaps(), name);
}

const std::vector<CheckerByInfo>& checkers()
{
    static const std::vector<CheckerByInfo> list = {
        {CheckerBy::parameter, "parameter",
         "Equal shares of the domain: where knots are uneven, it is stretched"},
        {CheckerBy::length, "length", "Equal lengths along the surface, as far as it can be rolled out"}};
    return list;
}

std::optional<CheckerBy> findChecker(std::string_view name)
{
    return found(checkers(), name);
}

double checkerLengthFor(double size)
{
    if (!(size > 0))
        return 1;
    const double wanted = size / 40;
    const double power = std::pow(10, std::floor(std::log10(wanted)));
    for (const double step : {1.0, 2.0, 5.0})
        if (wanted <= step * power)
            return step * power;
    return 10 * power;
}

Vec3 colourOnRamp(double place)
{
    return Vec3(gpu::rampColour(static_cast<float>(place)));
}

}  // namespace knotspan
