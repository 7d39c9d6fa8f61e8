#include "renderer/scene/packed_scene.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "model/core/check.h"
#include "shaders/shared/facing_forms.glsl"
#include "shaders/shared/trimming.glsl"

namespace knotspan {

const Resident* findResident(const std::vector<Resident>& residents, ObjectId id)
{
    const auto found =
        std::lower_bound(residents.begin(), residents.end(), id,
                         [](const Resident& resident, ObjectId wanted) { return resident.id < wanted; });
    return found != residents.end() && found->id == id ? &*found : nullptr;
}

KsQuadName ksquadName(const std::vector<Resident>& residents, std::uint32_t number)
{
    const auto next =
        std::upper_bound(residents.begin(), residents.end(), number,
                         [](std::uint32_t k, const Resident& resident) { return k < resident.firstKsquad; });
    check(next != residents.begin(), "the KSQuad is one of the scene");
    const Resident& resident = *(next - 1);
    const auto& spansU = resident.object->surface.knotsU().spans();
    const auto& spansV = resident.object->surface.knotsV().spans();
    const size_t local = number - resident.firstKsquad;
    check(local < spansU.size() * spansV.size(), "the KSQuad is one of the scene");
    return {resident.id, {spansU[local / spansV.size()], spansV[local % spansV.size()]}};
}

std::optional<std::uint32_t> ksquadNumber(const std::vector<Resident>& residents, const KsQuadName& name)
{
    const Resident* resident = findResident(residents, name.object);
    if (resident == nullptr)
        return std::nullopt;
    const auto& spansU = resident->object->surface.knotsU().spans();
    const auto& spansV = resident->object->surface.knotsV().spans();
    const auto u = std::lower_bound(spansU.begin(), spansU.end(), name.ksquad.spanU);
    const auto v = std::lower_bound(spansV.begin(), spansV.end(), name.ksquad.spanV);
    if (u == spansU.end() || *u != name.ksquad.spanU || v == spansV.end() || *v != name.ksquad.spanV)
        return std::nullopt;
    return resident->firstKsquad +
           static_cast<std::uint32_t>(static_cast<size_t>(u - spansU.begin()) * spansV.size() +
                                      static_cast<size_t>(v - spansV.begin()));
}

bool isSameShape(const SceneObject& a, const SceneObject& b)
{
    return &a == &b || (a.surface.knotsU() == b.surface.knotsU() &&
                        a.surface.knotsV() == b.surface.knotsV() && a.trimLoops == b.trimLoops);
}

PlacedSurface placedSurface(const SceneObject& object)
{
    return {&object.surface, object.transform};
}

std::vector<PlacedSurface> placedSurfaces(const std::vector<Resident>& residents)
{
    std::vector<PlacedSurface> placed;
    placed.reserve(residents.size());
    for (const Resident& resident : residents)
        placed.push_back(placedSurface(*resident.object));
    return placed;
}

VisibleObjects visibleObjects(const Scene& scene)
{
    VisibleObjects visible;
    for (const auto& [id, object] : scene.objects())
        if (object->visible)
            visible.emplace_back(id, object);
    return visible;
}

int largestDegree(const VisibleObjects& objects)
{
    int degree = 1;
    for (const auto& [id, object] : objects)
        degree = std::max({degree, object->surface.degreeU(), object->surface.degreeV()});
    return degree;
}

template <class Real>
PackedTables<Real> packTables(const std::vector<Resident>& residents, Evaluator evaluator)
{
    PackedTables<Real> packed;
    SpanTablePool<Real> pool;
    for (size_t surface = 0; surface < residents.size(); ++surface)
        for (gpu::KsQuadRecord record :
             makeKsQuadRecords(residents[surface].object->surface, evaluator, pool)) {
            record.surface = static_cast<std::uint32_t>(surface);
            record.firstPoint += residents[surface].firstPoint;
            packed.ksquads.push_back(record);
        }
    packed.spanTables = pool.takeNumbers();
    return packed;
}

std::vector<Resident> makeResidents(const VisibleObjects& objects, const std::vector<Resident>& before)
{
    std::vector<Resident> residents;
    std::uint32_t firstPoint = 0;
    std::uint32_t firstKsquad = 0;
    std::uint32_t firstBorder = 0;
    std::uint32_t firstFacingWord = 0;
    for (const auto& [id, object] : objects) {
        residents.push_back({id, object, PointFrame::of(object->surface), firstPoint, firstKsquad,
                             firstBorder, firstFacingWord, nullptr});
        firstPoint += static_cast<std::uint32_t>(object->surface.controlPoints().size());
        const auto ksquads = static_cast<std::uint32_t>(ksQuadCount(object->surface));
        firstKsquad += ksquads;
        firstFacingWord += ksquads * gpu::facingWordCount(static_cast<gpu::uint>(object->surface.degreeU()),
                                                          static_cast<gpu::uint>(object->surface.degreeV()));
        firstBorder += static_cast<std::uint32_t>(
            2 * (object->surface.knotsU().spans().size() + object->surface.knotsV().spans().size()));
    }
    tbb::parallel_for(size_t{0}, residents.size(), [&](size_t k) {
        Resident& resident = residents[k];
        const Resident* const held = findResident(before, resident.id);
        resident.trim = held != nullptr && isSameShape(*held->object, *resident.object)
                            ? held->trim
                            : surfaceTrim(*resident.object);
    });
    return residents;
}

std::vector<std::uint32_t> packTrims(const std::vector<Resident>& residents)
{
    if (std::none_of(residents.begin(), residents.end(), isTrimmed))
        return {};
    const Resident& last = residents.back();
    const size_t ksquads = last.firstKsquad + ksQuadCount(last.object->surface);
    // No record starts at a place that is also a verdict.
    std::vector<std::uint32_t> packed(std::max(ksquads, size_t{TRIM_RECORDS}), TRIM_WHOLE);
    for (const Resident& resident : residents) {
        if (!isTrimmed(resident))
            continue;
        const TrimIndex& index = *resident.trim->index;
        const std::vector<std::uint32_t>& words = index.words();
        const size_t records = std::max(index.ksquadCount(), TRIM_RECORDS);
        const size_t moved = packed.size() - records;
        for (size_t k = 0; k < index.ksquadCount(); ++k)
            packed[resident.firstKsquad + k] =
                words[k] >= TRIM_RECORDS ? static_cast<std::uint32_t>(words[k] + moved) : words[k];
        packed.insert(packed.end(), words.begin() + static_cast<std::ptrdiff_t>(records), words.end());
    }
    return packed;
}

gpu::SurfaceRecord surfaceRecordOf(const Resident& resident)
{
    gpu::SurfaceRecord record = makeSurfaceRecord(*resident.object, resident.frame, resident.firstPoint);
    record.firstKsquad = resident.firstKsquad;
    record.firstBorder = resident.firstBorder;
    record.firstFacingWord = resident.firstFacingWord;
    return record;
}

template <class Real>
PackedScene<Real> packScene(std::vector<Resident> residents, Evaluator evaluator)
{
    PackedScene<Real> packed;
    for (const Resident& resident : residents) {
        const auto points = packPoints<Real>(resident.frame, resident.object->surface.controlPoints());
        packed.points.insert(packed.points.end(), points.begin(), points.end());
        packed.surfaces.push_back(surfaceRecordOf(resident));
    }
    packed.tables = packTables<Real>(residents, evaluator);
    packed.residents = std::move(residents);
    return packed;
}

template PackedTables<float> packTables(const std::vector<Resident>&, Evaluator);
template PackedTables<double> packTables(const std::vector<Resident>&, Evaluator);
template PackedScene<float> packScene(std::vector<Resident>, Evaluator);
template PackedScene<double> packScene(std::vector<Resident>, Evaluator);

}  // namespace knotspan
