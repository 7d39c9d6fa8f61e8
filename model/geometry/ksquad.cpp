#include "model/geometry/ksquad.h"

namespace knotspan {

std::vector<KsQuad> ksQuads(const NurbsSurface& surface)
{
    std::vector<KsQuad> result;
    result.reserve(ksQuadCount(surface));
    for (const int spanU : surface.knotsU().spans())
        for (const int spanV : surface.knotsV().spans())
            result.push_back({spanU, spanV});
    return result;
}

size_t ksQuadCount(const NurbsSurface& surface)
{
    return surface.knotsU().spans().size() * surface.knotsV().spans().size();
}

}  // namespace knotspan
