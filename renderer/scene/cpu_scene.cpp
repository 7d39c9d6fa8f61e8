#include "renderer/scene/cpu_scene.h"

#include <algorithm>
#include <cstring>

#include "model/core/check.h"

namespace knotspan {

namespace {

template <Evaluator evaluator>
gpu::Basis<double> basisBy(const CpuScene& scene, gpu::uint table, int degree, double t)
{
    return gpu::evaluateBasis<evaluator, double>(scene, table, degree, t);
}

auto basisFunction(Evaluator evaluator) -> decltype(&basisBy<Evaluator::triangular>)
{
#define KNOTSPAN_CHOICE(number, name, values, both, bent, sentence) \
    if (evaluator == Evaluator::name)                               \
        return basisBy<Evaluator::name>;
    KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_CHOICE)
#undef KNOTSPAN_CHOICE
    check(false, "the evaluator is chosen");
    return nullptr;
}

bool isShapedAlike(const Resident& a, const Resident& b)
{
    return a.id == b.id && isSameShape(*a.object, *b.object);
}

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool sameBits(const BorderTables& a, const BorderTables& b)
{
    return sameBits(a.sides, b.sides) && sameBits(a.corners, b.corners) && sameBits(a.pieces, b.pieces) &&
           sameBits(a.uses, b.uses);
}

bool isSameFrame(const PointFrame& a, const PointFrame& b)
{
    return a.origin == b.origin && a.weight == b.weight;
}

// The spans, from the first to one behind the last, that control point `index` of a direction shapes.
std::pair<size_t, size_t> spansOf(const KnotVector& knots, int index)
{
    const auto& spans = knots.spans();
    const auto first = std::lower_bound(spans.begin(), spans.end(), index);
    const auto end = std::upper_bound(spans.begin(), spans.end(), index + knots.degree());
    return {static_cast<size_t>(first - spans.begin()), static_cast<size_t>(end - spans.begin())};
}

}  // namespace

CpuScene::Changes CpuScene::update(const std::vector<Resident>& residents, const BorderTables& borders,
                                   Evaluator evaluator)
{
    Changes changes;
    auto& held = packed_.residents;
    if (evaluator != evaluator_ ||
        !std::equal(held.begin(), held.end(), residents.begin(), residents.end(), isShapedAlike)) {
        packed_ = packScene<double>(residents, evaluator);
        borders_ = borders;
        evaluator_ = evaluator;
        basis_ = basisFunction(evaluator);
        changes.all = true;
        return changes;
    }
    bool anyReplaced = false;
    for (size_t k = 0; k < held.size(); ++k)
        // Packed anew without a change, it counts from another origin.
        if (held[k].object != residents[k].object || !isSameFrame(held[k].frame, residents[k].frame)) {
            replace(held[k], residents[k], changes);
            anyReplaced = true;
        }
    if (anyReplaced && !sameBits(borders_, borders)) {
        borders_ = borders;
        changes.borders = true;
    }
    return changes;
}

void CpuScene::replace(Resident& held, const Resident& wanted, Changes& changes)
{
    const auto& before = held.object->surface.controlPoints();
    const auto& after = wanted.object->surface.controlPoints();
    const bool framed = !isSameFrame(held.frame, wanted.frame);
    for (size_t k = 0; k < after.size(); ++k)
        if (framed || !(before[k] == after[k])) {
            packed_.points[held.firstPoint + k] =
                packPoints<double>(wanted.frame, std::span(after).subspan(k, 1)).front();
            touch(wanted, k, changes);
        }
    held = wanted;
    packed_.surfaces[static_cast<size_t>(&held - packed_.residents.data())] = surfaceRecordOf(held);
}

void CpuScene::touch(const Resident& resident, size_t point, Changes& changes) const
{
    changes.touched.resize(ksquadCount());
    const NurbsSurface& surface = resident.object->surface;
    const auto row = static_cast<size_t>(surface.countV());
    const auto [firstU, endU] = spansOf(surface.knotsU(), static_cast<int>(point / row));
    const auto [firstV, endV] = spansOf(surface.knotsV(), static_cast<int>(point % row));
    const size_t spansV = surface.knotsV().spans().size();
    for (size_t a = firstU; a < endU; ++a)
        for (size_t b = firstV; b < endV; ++b)
            changes.touched[resident.firstKsquad + a * spansV + b] = 1;
}

}  // namespace knotspan
