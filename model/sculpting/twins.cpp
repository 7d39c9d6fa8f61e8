#include "model/sculpting/twins.h"

#include <algorithm>

#include "model/core/check.h"
#include "model/sculpting/net_neighbours.h"

namespace knotspan {

namespace {

std::vector<ControlPointIndex> borderOf(NetSize net)
{
    std::vector<ControlPointIndex> border;
    for (int i = 0; i < net.countU; ++i)
        for (int j = 0; j < net.countV; j += i == 0 || i == net.countU - 1 ? 1 : net.countV - 1)
            border.push_back({i, j});
    return border;
}

bool isOnBorder(NetSize net, ControlPointIndex index)
{
    return index.i == 0 || index.j == 0 || index.i == net.countU - 1 || index.j == net.countV - 1;
}

}  // namespace

PointSelection withTwins(const Scene& scene, const PointSelection& selection)
{
    PointSelection result = selection;
    for (const auto& [id, selected] : selection.objects()) {
        const SharedObject object = scene.find(id);
        check(object && netSizeOf(object->surface) == selected.net,
              "selected control points are the scene's");
        const NetNeighbours neighbours(object->surface);
        std::vector<ControlPointIndex> firsts;
        for (const ControlPointIndex index : selected.points)
            if (isOnBorder(selected.net, index))
                firsts.push_back(neighbours.first(index));
        std::sort(firsts.begin(), firsts.end(), comesBefore);
        std::vector<ControlPointIndex> twins;
        for (const ControlPointIndex index : borderOf(selected.net))
            if (std::binary_search(firsts.begin(), firsts.end(), neighbours.first(index), comesBefore))
                twins.push_back(index);
        result.add(PointSelection(id, selected.net, std::move(twins)));
    }
    return result;
}

}  // namespace knotspan
