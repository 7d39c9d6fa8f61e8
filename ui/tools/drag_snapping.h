// What a dragged place jumps to: control points that are near it on the picture, knot lines and surfaces that
// are near it in space, the grid from everywhere; of several kinds the first of these.
#pragma once

#include "model/sculpting/screen_selection.h"
#include "model/sculpting/surface_snapping.h"
#include "ui/tools/picture_moves.h"
#include "ui/tools/tool.h"

namespace knotspan {

class DragSnapping {
public:
    // What moves is no target.
    struct Moving {
        PointSelection points;
        std::set<ObjectId> objects;  // as a whole
        bool friends = false;        // what other objects have where a moving point stands goes along
    };
    // Of the scene as it stands when the drag begins. Looks at the visible objects once, as far as the
    // settings ask.
    DragSnapping(const Scene& scene, const SnapSettings& settings, Moving moving);

    // `hand`: the place in the view plane that is under the hand; `place`: where the dragged thing would be,
    // the same but for drags along an axis.
    [[nodiscard]] std::optional<Vec3> target(const PictureView& view, const Vec3& hand, const Vec3& place);

private:
    struct SeenPoint {
        Vec2 pixel;
        ScenePoint point;
    };
    void look(const PictureView& view);
    [[nodiscard]] bool goesAlong(const ScenePoint& point) const;
    [[nodiscard]] std::optional<Vec3> pointAt(const PictureView& view, const Vec3& hand) const;

    Scene scene_;
    SnapSettings settings_;
    Moving moving_;
    std::optional<NearestPoints> friendPlaces_;  // where the moving points stand, if friends go along
    std::set<ObjectId> pointObjects_;            // whose control points are targets
    std::optional<SurfaceSnap> knotLines_;
    std::optional<SurfaceSnap> surfaces_;

    std::optional<PictureView> view_;  // that the points were looked at in
    std::vector<SeenPoint> seen_;
    std::optional<NearestPoints> tree_;  // their pixels
};

// A small cross where it went.
void showTarget(const PictureView& view, const Vec3& target, Overlays& overlays);

}  // namespace knotspan
