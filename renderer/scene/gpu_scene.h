// The scene on the device. sync() compares pointers: an equal one is an unchanged object, and of one whose
// net and knots have the same shape only the control points that differ travel. Objects that come, go, hide
// or get another shape have the whole scene packed anew.
#pragma once

#include <set>
#include <utility>

#include "model/core/totals.h"
#include "model/scene/deformation.h"
#include "renderer/scene/bezier_nets.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/held_memory.h"
#include "renderer/scene/packed_scene.h"
#include "renderer/scene/resident_changes.h"
#include "renderer/scene/shared_edges.h"
#include "renderer/scene/shown_sides.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

// What of the surfaces the device has: KSQuads as indices into their nets, or each as a Bezier patch with a
// net of its own, which every edit makes again.
enum class Packing { ksquads, bezier };

class GpuScene {
public:
    GpuScene(Bindings& bindings, Uploader& uploader);

    // Refuses, with a sentence, what exceeds the device's buffers; nothing is held then.
    void sync(const Scene& scene, Joins joins = Joins::anew);
    // Whether a sync() to it would change control points, colours and places at most.
    [[nodiscard]] bool isOfSameShape(const Scene& scene) const { return changesTo(scene).has_value(); }
    // What was written may not have arrived: the next sync() sends everything.
    void forget();
    // An evaluator other than `automatic`. Where it changes, the tables of the spans are sent and the KSQuad
    // records, that say where those start; no control point.
    void useEvaluator(Evaluator evaluator);
    [[nodiscard]] Evaluator evaluator() const { return evaluator_; }
    // Where that changes, the surfaces are sent again. `withNets`: Bezier patches hide the surfaces' own
    // nets; with them, which overlays draw, or without.
    void usePacking(Packing packing, bool withNets);
    // Whether everything was packed anew since the last call.
    [[nodiscard]] bool takeRebuilt() { return std::exchange(rebuilt_, false); }

    // What of the surfaces is tinted.
    struct Tinted {
        const std::vector<ObjectId>& highlighted;
        std::optional<ObjectId> hovered;
    };
    // All surfaces as a camera sees them; uploaded where they differ from the last ones.
    void updateViews(const Camera& camera, const Tinted& tinted, const SideTables& sides);

    [[nodiscard]] const std::vector<Resident>& residents() const { return residents_; }
    // Their log.
    [[nodiscard]] const ResidentChanges& changes() const { return log_; }
    // Null where it is not on the device.
    [[nodiscard]] const Resident* find(ObjectId id) const { return findResident(residents_, id); }
    [[nodiscard]] std::uint32_t indexOf(const Resident& resident) const
    {
        return static_cast<std::uint32_t>(&resident - residents_.data());
    }

    [[nodiscard]] std::uint32_t ksquadCount() const { return ksquadCount_; }
    // Those of which trim loops leave a part, and those whose loops cannot be followed.
    struct Trims {
        std::uint64_t trimmed = 0;
        std::uint64_t refused = 0;
        std::string refusal;  // of the first one
    };
    [[nodiscard]] const Trims& trims() const { return trims_; }
    [[nodiscard]] bool isTrimmed() const { return trims_.trimmed > 0; }
    // Of all surfaces, as packed.
    [[nodiscard]] VkBuffer controlPointBuffer() const { return controlPoints_.get(); }
    [[nodiscard]] std::uint32_t controlPointCount() const { return pointCount_; }
    [[nodiscard]] bool isRebuilt() const { return rebuilt_; }  // see takeRebuilt()
    // Of all that is in the picture, meshes as well.
    [[nodiscard]] Box bounds() const;
    [[nodiscard]] const BorderTables& borders() const { return edges_.tables(); }
    // Which border sides have a friend, as FriendSides says.
    void setFriends(const std::vector<std::uint8_t>& sides);
    [[nodiscard]] const CoincidentEdges& edges() const { return edges_.edges(); }
    [[nodiscard]] Packing packing() const { return packing_; }
    void listMemory(std::vector<HeldMemory>& to) const;

private:
    // The residents that are other objects in that scene; nothing where others would be on the device, or
    // one of another shape.
    [[nodiscard]] std::optional<std::vector<size_t>> changesTo(const Scene& scene) const;
    [[nodiscard]] std::optional<std::vector<size_t>> exchangedIn(const Scene& scene,
                                                                 std::vector<ObjectId> ids) const;
    void rebuild(const VisibleObjects& visible);
    void sendModel(std::vector<Resident> residents);
    void sendPoints(const std::vector<Resident>& residents);
    void sendTrims(const std::vector<Resident>& residents);
    void sendTables(const PackedTables<float>& tables);
    [[nodiscard]] PackedTables<float> tablesOf(const std::vector<Resident>& residents) const;
    [[nodiscard]] gpu::SurfaceRecord recordOf(const Resident& resident) const;

    // What the views of the surfaces are made for.
    struct Viewed {
        Camera camera;
        std::vector<ObjectId> highlighted;
        std::optional<ObjectId> hovered;
        std::uint64_t sides = 0;  // their revision

        [[nodiscard]] bool operator==(const Viewed&) const = default;
    };
    // A resident that is now another object of the same shape.
    struct Change {
        size_t index = 0;
        SharedObject before;
        bool moved = false;   // some control point
        bool framed = false;  // its points count from another origin
        bool recordDiffers = false;
    };
    void replace(const Scene& scene, const std::vector<size_t>& changed, Joins joins);
    void lookAt(Change& change);
    void sendChangedPoints(const Change& change);
    template <class Test, class Send>
    static void sendRuns(const std::vector<Change>& changes, const Test& test, const Send& sendOne);
    [[nodiscard]] gpu::SurfaceView viewOf(size_t k, const Viewed& as, const SideTables& sides) const;
    void updateBorders();
    void sendBorders(const BorderTables& before);
    void provide(Buffer& buffer, int binding, VkDeviceSize bytes);
    template <class T>
    void send(Buffer& buffer, int binding, const std::vector<T>& elements);
    template <class T>
    void sendChanges(Buffer& buffer, int binding, const std::vector<T>& before, const std::vector<T>& after);

    Bindings& bindings_;
    Uploader& uploader_;
    std::vector<Resident> residents_;
    Evaluator evaluator_ = Evaluator::triangular;
    Packing packing_ = Packing::ksquads;
    bool withNets_ = true;  // the surfaces' own
    BezierNets beziers_;    // none where KSQuads are packed
    std::uint32_t ksquadCount_ = 0;
    std::uint32_t pointCount_ = 0;
    bool rebuilt_ = false;
    Scene held_;  // that the residents are of
    ResidentChanges log_;
    Totals<Box> boxes_;  // by resident
    Trims trims_;
    Box meshBox_;
    std::vector<gpu::SurfaceRecord> records_;
    std::vector<gpu::SurfaceView> views_;
    Viewed viewed_;
    ResidentChanges::Moment viewedAt_ = 0;
    std::vector<std::uint32_t> shownShells_;
    Buffer surfaces_;
    Buffer surfaceViews_;
    Buffer shownShellBuffer_;
    Buffer ksquads_;
    Buffer spanTables_;
    Buffer controlPoints_;
    Buffer trimWords_;
    SharedEdges edges_;
    std::set<std::size_t> unsearched_;  // residents that moved since
    Buffer borderSides_;
    Buffer borderCorners_;
    Buffer borderPieces_;
    Buffer borderUses_;
};

}  // namespace knotspan
