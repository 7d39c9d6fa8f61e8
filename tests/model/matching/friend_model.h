// A model whose control points are pulled while friends are kept, and how well its edges fit, measured
// without any code of what is tested.
#pragma once

#include "model/matching/keep_friends.h"

namespace knotspan::testing {

// Surfaces, and the edges between them.
struct FriendModel {
    std::vector<NurbsSurface> surfaces;
    std::vector<FriendEdge> edges;
    std::vector<Mat4> transforms;  // none: the identity

    [[nodiscard]] Mat4 transform(size_t k) const { return transforms.empty() ? Mat4(1.0) : transforms[k]; }
    [[nodiscard]] std::vector<PlacedSurface> placed() const;
    [[nodiscard]] FriendKeeper keeper() const { return {placed(), edges}; }
    [[nodiscard]] Vec3 pointAt(const PointMove& move) const;

    void join(size_t a, Side sideA, size_t b, Side sideB);  // whole edges, G1
    void findEdges();                                       // as Friends finds them
    void apply(const std::vector<PointMove>& moves);
};

struct EdgeBreak {
    double gap = 0;
    double angleDeg = 0;  // between planes
    bool runsOn = true;   // and not back
};
// At 31 points.
[[nodiscard]] EdgeBreak breakOf(const FriendModel& model, const FriendEdge& edge);

}  // namespace knotspan::testing
