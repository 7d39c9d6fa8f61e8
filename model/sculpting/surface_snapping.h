// The place of a surface, or of its knot lines, that is nearest to a position: what a dragged point snaps to.
//
// A plain search: samples of every KSQuad, kept in a tree, then Newton's method from the nearest of them.
// Where two places are nearly as near as each other, closer than the samples can tell, it may give the other
// one. Trim loops are not looked at: a place that is trimmed away counts.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "model/geometry/ksquad.h"
#include "model/scene/scene.h"
#include "model/sculpting/nearest_points.h"

namespace knotspan {

enum class SnapTarget {
    surface,
    knotLines,  // lines of u or v at a knot of the domain, its border included
};

struct SurfacePlace {
    ObjectId object{};
    double u = 0;
    double v = 0;
    Vec3 position{0};     // in model space
    double distance = 0;  // from where it was asked for
};

// The same for a position that is known to be near one KSQuad, as a picture tells: searched from there on.
[[nodiscard]] SurfacePlace nearestFrom(ObjectId id, const SceneObject& object, const KsQuad& ksquad,
                                       const Vec3& position);

class SurfaceSnap {
public:
    // Of objects as they stand when a gesture begins; those that the scene has not are none. Costs what
    // evaluating 16 points a KSQuad costs.
    SurfaceSnap(const Scene& scene, const std::set<ObjectId>& objects, SnapTarget target);

    using Place = SurfacePlace;
    // No further than `reach` (0 or more), all in model space.
    [[nodiscard]] std::optional<Place> nearest(const Vec3& position, double reach) const;

private:
    // On a knot line only one parameter may change.
    struct Seed {
        ObjectId object{};
        double u = 0;
        double v = 0;
        bool freeU = true;
        bool freeV = true;
        Vec3 position{0};
    };
    struct Grid;
    void addSamples(ObjectId id, const SceneObject& object, const Grid& grid);
    [[nodiscard]] static std::vector<Vec3> positionsOf(const std::vector<Seed>& seeds);

    std::map<ObjectId, SharedObject> objects_;
    double gap_ = 0;  // the largest between neighbouring samples
    std::vector<Seed> seeds_;
    std::optional<NearestPoints> tree_;
};

}  // namespace knotspan
