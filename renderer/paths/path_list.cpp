#include "renderer/paths/path_list.h"

#include <algorithm>

#include "model/core/check.h"
#include "renderer/paths/surface_path.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

const std::vector<PathFactory>& pathFactories()
{
    static const std::vector<PathFactory> factories = {
        meshPath(),     mesh9x9Path(), tessellationPath(), tessellationAdaptivePath(),
        geometryPath(), computePath(), cpuPath(),          wholeSurfacePath(),
        bezierPath(),
    };
    return factories;
}

void drawIndirect(VkCommandBuffer commands, const Device& device, const TileDraws& tiles)
{
    constexpr std::uint32_t kStride = sizeof(gpu::DrawRecord);
    const std::uint32_t most = device.limits().maxDrawIndirectCount;
    for (std::uint32_t first = 0; first < tiles.count; first += most)
        vkCmdDrawIndirect(commands, tiles.draws, static_cast<VkDeviceSize>(first) * kStride,
                          std::min(most, tiles.count - first), kStride);
}

const PathFactory& pathFactory(PathId id)
{
    for (const PathFactory& factory : pathFactories())
        if (factory.info.id == id)
            return factory;
    check(false, "every path is in the list");
    return pathFactories().front();
}

bool PathInfo::follows(SamplingRule rule) const
{
    return std::any_of(rules.begin(), rules.end(), [&](const SamplingRule& known) {
        return known.kind == rule.kind && (known.count == 0 || known.count == rule.count);
    });
}

std::vector<SamplingRule> tileRules()
{
    using Kind = SamplingRule::Kind;
    return {{Kind::bound}, {Kind::area}, {Kind::edge}, {Kind::fixed}};
}

const std::vector<PathInfo>& paths()
{
    static const std::vector<PathInfo> infos = [] {
        std::vector<PathInfo> list;
        for (const PathFactory& factory : pathFactories())
            list.push_back(factory.info);
        return list;
    }();
    return infos;
}

const PathInfo& pathInfo(PathId id)
{
    return pathFactory(id).info;
}

std::optional<PathId> findPath(std::string_view name)
{
    for (const PathInfo& path : paths())
        if (path.name == name)
            return path.id;
    return std::nullopt;
}

}  // namespace knotspan
