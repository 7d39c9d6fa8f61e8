#include "renderer/scene/surface_trim.h"

namespace knotspan {

namespace {

bool leavesAll(const TrimIndex& index)
{
    for (std::uint32_t k = 0; k < index.ksquadCount(); ++k)
        if (index.classOf(k) != KsQuadTrim::inside)
            return false;
    return true;
}

}  // namespace

SharedTrim surfaceTrim(const SceneObject& object)
{
    if (object.trimLoops.empty())
        return nullptr;
    const TrimRegion region(object.trimLoops, object.surface);
    auto trim = std::make_shared<SurfaceTrim>();
    if (!region.isTrimmed()) {
        trim->refusal = region.report().empty() ? "Its trim loops are none" : region.report().front();
        return trim;
    }
    auto index = TrimIndex::create(region);
    if (!index)
        trim->refusal = index.error().sentence();
    else if (!leavesAll(*index))
        trim->index = std::move(*index);
    return trim;
}

}  // namespace knotspan
