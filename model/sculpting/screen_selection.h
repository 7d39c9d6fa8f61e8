// Control points chosen in the picture, by a box or a lasso drawn around them.
//
// The camera stands still while the hand draws, so positions are projected once a gesture.
#pragma once

#include <functional>
#include <optional>

#include "model/sculpting/point_selection.h"

namespace knotspan {

// From model space to pixels; nothing where the point is behind the eye.
using Projection = std::function<std::optional<Vec2>(const Vec3&)>;

// Where an object's control points are in the picture, stored as the surface stores them.
struct ProjectedNet {
    ObjectId object{};
    NetSize net;
    std::vector<std::optional<Vec2>> pixels;  // as many as the net has points
};

// Of the objects that the scene has.
[[nodiscard]] std::vector<ProjectedNet> projected(const Scene& scene, const std::set<ObjectId>& objects,
                                                  const Projection& projection);

// Those in the box with opposite corners a and b, its border included.
[[nodiscard]] PointSelection insideBox(const std::vector<ProjectedNet>& nets, const Vec2& a, const Vec2& b);

// A closed polygon, its last corner joined to the first. A place is inside where a ray from it crosses the
// polygon an odd number of times, so that loops over itself leave holes. Places exactly on its line belong to
// one side, always the same one.
class Lasso {
public:
    explicit Lasso(std::vector<Vec2> corners);

    // Looks only at the edges at the place's height.
    [[nodiscard]] bool contains(const Vec2& place) const;

private:
    struct Edge {
        Vec2 from;
        Vec2 to;
    };
    [[nodiscard]] size_t bandAt(double y) const;

    Vec2 low_{0};
    Vec2 high_{0};
    std::vector<std::vector<Edge>> bands_;  // by height, all as high; an edge is in each that it reaches
};

[[nodiscard]] PointSelection insideLasso(const std::vector<ProjectedNet>& nets, const Lasso& lasso);

}  // namespace knotspan
