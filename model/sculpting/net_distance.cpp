#include "model/sculpting/net_distance.h"

#include <functional>
#include <queue>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/sculpting/net_neighbours.h"

namespace knotspan {

namespace {

class NetWalk {
public:
    NetWalk(const SceneObject& object, NetMeasure measure, double reach)
        : object_(object),
          size_(netSizeOf(object.surface)),
          neighbours_(object.surface),
          measure_(measure),
          reach_(reach),
          distances_(size_.count(), std::numeric_limits<double>::infinity())
    {
    }

    void start(ControlPointIndex index)
    {
        check(size_.contains(index), "the control point's index lies inside the net");
        come(index, 0);
    }

    std::vector<double> walk()
    {
        while (!waiting_.empty()) {
            const auto [distance, place] = waiting_.top();
            waiting_.pop();
            if (distance == distances_[place])
                leave(size_.indexAt(place), distance);
        }
        return std::move(distances_);
    }

private:
    using Reached = std::pair<double, size_t>;

    void come(ControlPointIndex index, double distance)
    {
        double& known = distances_[size_.place(index)];
        if (!(distance < known) || (distance > 0 && !(distance < reach_)))
            return;
        known = distance;
        waiting_.emplace(distance, size_.place(index));
    }

    void leave(ControlPointIndex index, double distance)
    {
        const ControlPointIndex grid[] = {
            {index.i - 1, index.j}, {index.i + 1, index.j}, {index.i, index.j - 1}, {index.i, index.j + 1}};
        for (const ControlPointIndex other : grid)
            if (size_.contains(other))
                come(other, distance + between(index, other));
        if (neighbours_.isJoined(Direction::U) && (index.i == 0 || index.i == size_.countU - 1))
            come({size_.countU - 1 - index.i, index.j}, distance);
        if (neighbours_.isJoined(Direction::V) && (index.j == 0 || index.j == size_.countV - 1))
            come({index.i, size_.countV - 1 - index.j}, distance);
    }

    [[nodiscard]] double between(ControlPointIndex a, ControlPointIndex b) const
    {
        if (measure_ == NetMeasure::steps)
            return 1;
        return glm::distance(controlPointInModel(object_, a), controlPointInModel(object_, b));
    }

    const SceneObject& object_;
    NetSize size_;
    NetNeighbours neighbours_;
    NetMeasure measure_;
    double reach_;
    std::vector<double> distances_;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> waiting_;
};

}  // namespace

std::vector<double> distancesAlongNet(const SceneObject& object, const std::vector<ControlPointIndex>& from,
                                      NetMeasure measure, double reach)
{
    NetWalk walk(object, measure, reach);
    for (const ControlPointIndex index : from)
        walk.start(index);
    return walk.walk();
}

}  // namespace knotspan
