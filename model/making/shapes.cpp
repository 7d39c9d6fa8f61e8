#include "model/making/shapes.h"

#include <algorithm>

#include "model/geometry/primitives.h"
#include "model/making/numbers.h"

namespace knotspan {

namespace {

Result<void> requireSizes(const std::string& first, double a, const std::string& second, double b)
{
    if (auto size = requireSize(first, a); !size)
        return size;
    return requireSize(second, b);
}

// Of a cone: 0 is allowed.
Result<void> requireSizeOrZero(const std::string& what, double size)
{
    return size == 0 ? Result<void>{} : requireSize(what, size);
}

}  // namespace

Result<NurbsSurface> planeShape(const Placement& placement, double sizeU, double sizeV)
{
    if (auto sizes = requireSizes("The size along u", sizeU, "The size along v", sizeV); !sizes)
        return tl::unexpected(sizes.error());
    return placed(plane({-sizeU / 2, -sizeV / 2, 0}, {sizeU, 0, 0}, {0, sizeV, 0}), placement);
}

Result<NurbsSurface> cylinderShape(const Placement& placement, double radius, double height)
{
    if (auto sizes = requireSizes("The radius", radius, "The height", height); !sizes)
        return tl::unexpected(sizes.error());
    return placed(cylinder(Vec3(0), radius, height), placement);
}

Result<NurbsSurface> coneShape(const Placement& placement, double radiusBelow, double radiusAbove,
                               double height)
{
    for (const auto& size :
         {requireSizeOrZero("The lower radius", radiusBelow),
          requireSizeOrZero("The upper radius", radiusAbove), requireSizeOrZero("The height", height)})
        if (!size)
            return tl::unexpected(size.error());
    if (radiusBelow == 0 && radiusAbove == 0)
        return failure("Both radii are 0", "Give at least one above zero");
    if (height == 0 && radiusBelow == radiusAbove)
        return failure("The height is 0 and both radii are the same, so that there is no area",
                       "Give a height, or two different radii");
    return placed(cone(Vec3(0), radiusBelow, radiusAbove, height), placement);
}

Result<NurbsSurface> sphereShape(const Placement& placement, double radius)
{
    if (auto size = requireSize("The radius", radius); !size)
        return tl::unexpected(size.error());
    return placed(sphere(Vec3(0), radius), placement);
}

Result<NurbsSurface> torusShape(const Placement& placement, double major, double minor)
{
    if (auto sizes = requireSizes("The radius of the ring", major, "The radius of the tube", minor); !sizes)
        return tl::unexpected(sizes.error());
    if (!(minor < major))
        return failure("The tube is as thick as the ring, so that no hole is left",
                       "Give a radius of the tube below that of the ring");
    return placed(torus(Vec3(0), major, minor), placement);
}

}  // namespace knotspan
