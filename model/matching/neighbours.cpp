#include "model/matching/neighbours.h"

#include "model/core/check.h"
#include "model/friends/box_tree.h"

namespace knotspan {

namespace {

Box grown(const Box& box, double gap)
{
    return {box.low - gap, box.high + gap};
}

}  // namespace

std::map<ObjectId, int> neighbours(const Scene& scene, const std::set<ObjectId>& of, int steps, double gap)
{
    std::map<ObjectId, int> found;
    std::vector<Box> reached;
    for (const ObjectId id : of) {
        const SharedObject object = scene.find(id);
        check(object != nullptr, "neighbours are asked for of objects that are there");
        found[id] = 0;
        reached.push_back(grown(object->bounds(), gap));
    }
    std::map<ObjectId, Box> others;
    for (const auto& [id, object] : scene.objects())
        if (object->visible && of.count(id) == 0)
            others.emplace(id, object->bounds());
    for (int step = 1; step <= steps; ++step) {
        std::vector<Box> next;
        for (auto other = others.begin(); other != others.end();) {
            bool isNear = false;
            for (size_t k = 0; k < reached.size() && !isNear; ++k)
                isNear = touch(reached[k], other->second);
            if (isNear) {
                found[other->first] = step;
                next.push_back(grown(other->second, gap));
            }
            other = isNear ? others.erase(other) : std::next(other);
        }
        reached = std::move(next);
    }
    return found;
}

Scene partOf(const Scene& scene, const std::map<ObjectId, int>& objects)
{
    Scene part;
    for (const auto& [id, step] : objects)
        part.exchange(id, scene.find(id));
    return part;
}

std::string nameOf(const Scene& scene, ObjectId id)
{
    const SharedObject object = scene.find(id);
    if (object && !object->name.empty())
        return "\"" + object->name + "\"";
    return "Surface " + std::to_string(static_cast<std::uint32_t>(id));
}

}  // namespace knotspan
