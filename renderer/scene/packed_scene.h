// A whole scene packed for the GPU, ready to be sent: the records and numbers of all visible objects, one
// behind the other, and the names that its numbers stand for.
#pragma once

#include <optional>
#include <utility>

#include "model/analysis/border_curves.h"
#include "model/scene/scene.h"
#include "renderer/scene/patch_table.h"
#include "renderer/scene/surface_trim.h"

namespace knotspan {

// One visible object, in the order of the surface records, which is that of the ids.
struct Resident {
    ObjectId id{};
    SharedObject object;
    PointFrame frame;
    std::uint32_t firstPoint = 0;
    std::uint32_t firstKsquad = 0;
    std::uint32_t firstBorder = 0;
    std::uint32_t firstFacingWord = 0;  // of the rays of its KSQuads (facing_forms.h)
    SharedTrim trim;                    // null: it has no trim loops
};

// Whether there is less of it than the surface.
[[nodiscard]] inline bool isTrimmed(const Resident& resident)
{
    return resident.trim && resident.trim->index;
}

[[nodiscard]] const Resident* findResident(const std::vector<Resident>& residents,
                                           ObjectId id);  // null: none

// Between the numbers of the records and the model's names of KSQuads.
struct KsQuadName {
    ObjectId object{};
    KsQuad ksquad;
};
[[nodiscard]] KsQuadName ksquadName(const std::vector<Resident>& residents, std::uint32_t number);
[[nodiscard]] std::optional<std::uint32_t> ksquadNumber(const std::vector<Resident>& residents,
                                                        const KsQuadName& name);  // nothing: no such one

// Same records, knots, number of points and trim loops: only coordinates, weights, colour and transform may
// differ.
[[nodiscard]] bool isSameShape(const SceneObject& a, const SceneObject& b);
[[nodiscard]] PlacedSurface placedSurface(const SceneObject& object);
[[nodiscard]] std::vector<PlacedSurface> placedSurfaces(const std::vector<Resident>& residents);

using VisibleObjects = std::vector<std::pair<ObjectId, SharedObject>>;
[[nodiscard]] VisibleObjects visibleObjects(const Scene& scene);
[[nodiscard]] int largestDegree(const VisibleObjects& objects);  // 1 where there is none

// The part that depends on the evaluator.
template <class Real>
struct PackedTables {
    std::vector<gpu::KsQuadRecord> ksquads;
    std::vector<Real> spanTables;
};
template <class Real>
[[nodiscard]] PackedTables<Real> packTables(const std::vector<Resident>& residents, Evaluator evaluator);

template <class Real>
struct PackedScene {
    std::vector<Resident> residents;
    std::vector<gpu::SurfaceRecord> surfaces;
    std::vector<glm::vec<4, Real>> points;
    PackedTables<Real> tables;
};
// Trims are taken over from those of `before` that are of the same shape.
[[nodiscard]] std::vector<Resident> makeResidents(const VisibleObjects& objects,
                                                  const std::vector<Resident>& before = {});
// As shaders/shared/trimming.glsl reads them: a word for each KSQuad of all surfaces, then the records. None
// where no surface is trimmed.
[[nodiscard]] std::vector<std::uint32_t> packTrims(const std::vector<Resident>& residents);
[[nodiscard]] gpu::SurfaceRecord surfaceRecordOf(const Resident& resident);
template <class Real>
[[nodiscard]] PackedScene<Real> packScene(std::vector<Resident> residents, Evaluator evaluator);

extern template PackedTables<float> packTables(const std::vector<Resident>&, Evaluator);
extern template PackedTables<double> packTables(const std::vector<Resident>&, Evaluator);
extern template PackedScene<float> packScene(std::vector<Resident>, Evaluator);
extern template PackedScene<double> packScene(std::vector<Resident>, Evaluator);

}  // namespace knotspan
