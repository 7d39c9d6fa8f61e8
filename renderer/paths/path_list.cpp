#include "renderer/paths/path_list.h"

#include "model/core/check.h"
#include "renderer/paths/surface_path.h"

namespace knotspan {

const std::vector<PathFactory>& pathFactories()
{
    static const std::vector<PathFactory> factories = {
        mesh9x9Path(),
        tessellationPath(),
    };
    return factories;
}

const PathFactory& pathFactory(PathId id)
{
    for (const PathFactory& factory : pathFactories())
        if (factory.info.id == id)
            return factory;
    check(false, "every path is in the list");
    return pathFactories().front();
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
