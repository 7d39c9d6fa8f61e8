// One drag of selected control points from its press to its release: who moves, which way and how far.
//
// Made when the hand takes hold, it looks at the objects once; every answer is from where they stood then, so
// coming back to the start is coming back to the bit, and an event costs what the moving points and their own
// nets cost, whatever else there is in the scene.
#pragma once

#include "model/scene/edit.h"
#include "model/sculpting/mirroring.h"
#include "model/sculpting/point_moving.h"

namespace knotspan {

enum class DragAxis {
    free,  // wherever the hand goes
    x,     // of the model
    y,
    z,
    u,       // along the net
    v,       // along the net
    normal,  // of the surface, at the control point's Greville parameters
};

struct DragSettings {
    DragAxis axis = DragAxis::free;
    // Of u, v and normal: each point goes its own way instead of all along the mean of the selected points'
    // directions.
    bool eachItsOwn = false;
    Falloff falloff;
    Symmetry symmetry;
    std::set<ObjectId> others;  // may follow too, by falloff in space or as mirror images

    [[nodiscard]] bool operator==(const DragSettings&) const = default;
};

class PointDrag {
public:
    // The selection is of this scene (PointSelection::keepOnly). Fails, with a sentence, where
    // the axis has no direction at the selected points (u round a pole).
    //
    // With symmetry a point that is near both the selection and its mirror image follows the one that it has
    // the larger share of; with equal shares it keeps to the plane in between.
    [[nodiscard]] static Result<PointDrag> begin(const Scene& scene, const PointSelection& selection,
                                                 const DragSettings& settings);

    // Unit, in model space: where a drag along its axis points to; of `free` zero. With `eachItsOwn` the
    // mean.
    [[nodiscard]] const Vec3& direction() const { return direction_; }

    // The selected points moved by `by` (model space): the whole of it where they are free, otherwise what it
    // has along direction(). An object that ends where it was is the same pointer as at the start. Fails,
    // with a sentence, where a point would go infinitely far.
    [[nodiscard]] Result<Edit> moved(const Vec3& by) const;
    // Along the axis, in model units; for drags that are not free.
    [[nodiscard]] Result<Edit> movedAlong(double distance) const;

    // By object, in model space, in the order of comesBefore().
    [[nodiscard]] std::map<ObjectId, std::vector<PointShift>> shifts(const Vec3& by) const;

    [[nodiscard]] const Followers& followers() const { return followers_; }  // to be shown; no mirror images
    [[nodiscard]] PointSelection moving() const;                             // followers and mirror images
    [[nodiscard]] size_t withoutPartner() const { return withoutPartner_; }  // of followers, where mirrored

private:
    // Free points move by response * by, others by response * (distance, 0, 0).
    struct Moving {
        ControlPointIndex index;
        double share = 0;
        Mat3 response;  // share included
    };
    struct Part {
        SharedObject start;
        std::vector<Moving> points;
    };
    using Responses = std::map<ObjectId, std::vector<Mat3>>;  // of followers_, share included

    PointDrag() = default;
    [[nodiscard]] Result<void> findDirection(const Scene& scene, const PointSelection& selection);
    [[nodiscard]] Responses responses(const Scene& scene) const;
    void addParts(const Scene& scene, const Responses& responses, const MirrorFollowers& images);
    [[nodiscard]] static std::vector<Moving> joined(const std::vector<Moving>& own,
                                                    const std::vector<Moving>& images);
    [[nodiscard]] Result<Edit> movedBy(const Vec3& input) const;
    [[nodiscard]] std::map<ObjectId, std::vector<PointShift>> shiftsBy(const Vec3& input) const;

    DragSettings settings_;
    Vec3 direction_{0};
    Followers followers_;
    std::map<ObjectId, Part> parts_;
    size_t withoutPartner_ = 0;
};

}  // namespace knotspan
