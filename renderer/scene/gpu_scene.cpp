#include "renderer/scene/gpu_scene.h"

#include <algorithm>
#include <cstring>

#include <glm/matrix.hpp>

#include "model/core/check.h"
#include "renderer/scene/surface_views.h"

namespace knotspan {

namespace {

template <class T>
std::span<const T> all(const std::vector<T>& elements)
{
    return elements;
}

}  // namespace

GpuScene::GpuScene(Bindings& bindings, Uploader& uploader) : bindings_(bindings), uploader_(uploader) {}

void GpuScene::rebuild(const VisibleObjects& visible)
{
    auto residents = makeResidents(visible, residents_);
    // Where the device refuses, nothing is left that looks as if it were there.
    forget();
    edges_ = SharedEdges(placedSurfaces(residents));
    unsearched_.clear();
    const BorderTables& borders = edges_.tables();
    send(borderSides_, BINDING_BORDER_SIDES, borders.sides);
    send(borderCorners_, BINDING_BORDER_CORNERS, borders.corners);
    send(borderPieces_, BINDING_BORDER_PIECES, borders.pieces);
    send(borderUses_, BINDING_BORDER_USES, borders.uses);
    sendModel(std::move(residents));
}

void GpuScene::usePacking(Packing packing, bool withNets)
{
    // KSQuads are indices into the nets.
    withNets = withNets || packing == Packing::ksquads;
    if (packing == packing_ && withNets == withNets_)
        return;
    packing_ = packing;
    withNets_ = withNets;
    sendModel(std::exchange(residents_, {}));
}

// What depends on the packing; they become the residents where the device took them.
void GpuScene::sendModel(std::vector<Resident> residents)
{
    ksquadCount_ = 0;
    pointCount_ = 0;
    beziers_ = BezierNets(packing_ == Packing::bezier ? residents : std::vector<Resident>());
    records_.clear();
    for (const Resident& resident : residents)
        records_.push_back(recordOf(resident));
    send(surfaces_, BINDING_SURFACES, records_);
    const auto tables = tablesOf(residents);
    sendTables(tables);
    sendPoints(residents);
    sendTrims(residents);
    std::vector<Box> boxes;
    for (const Resident& resident : residents)
        boxes.push_back(resident.object->bounds());
    boxes_ = Totals<Box>(boxes);
    residents_ = std::move(residents);
    ksquadCount_ = static_cast<std::uint32_t>(tables.ksquads.size());
    log_.restart();
    rebuilt_ = true;
}

void GpuScene::sendPoints(const std::vector<Resident>& residents)
{
    std::vector<glm::vec4> points(beziers_.pointCount());
    beziers_.make(residents, 0, beziers_.residentCount(), points);
    for (const Resident& resident : residents)
        if (withNets_) {
            const auto net = packPoints<float>(resident.frame, resident.object->surface.controlPoints());
            points.insert(points.end(), net.begin(), net.end());
        }
    send(controlPoints_, BINDING_CONTROL_POINTS, points);
    pointCount_ = static_cast<std::uint32_t>(points.size());
}

void GpuScene::sendTrims(const std::vector<Resident>& residents)
{
    const std::vector<std::uint32_t> words = packTrims(residents);
    send(trimWords_, BINDING_TRIM_WORDS, words);
    trims_ = {};
    for (const Resident& resident : residents) {
        trims_.trimmed += knotspan::isTrimmed(resident) ? 1 : 0;
        if (resident.trim && !resident.trim->refusal.empty() && trims_.refused++ == 0)
            trims_.refusal = resident.trim->refusal;
    }
}

PackedTables<float> GpuScene::tablesOf(const std::vector<Resident>& residents) const
{
    return packing_ == Packing::bezier ? beziers_.tables(residents, evaluator_)
                                       : packTables<float>(residents, evaluator_);
}

// Own nets lie behind those of the Bezier patches.
gpu::SurfaceRecord GpuScene::recordOf(const Resident& resident) const
{
    gpu::SurfaceRecord record = surfaceRecordOf(resident);
    if (packing_ == Packing::bezier) {
        record.stride = record.degreeV + 1;
        record.firstPoint += static_cast<std::uint32_t>(beziers_.pointCount());
    }
    return record;
}

void GpuScene::useEvaluator(Evaluator evaluator)
{
    if (evaluator == evaluator_)
        return;
    evaluator_ = evaluator;
    const auto tables = tablesOf(residents_);
    // Where the device refuses, nothing is left that looks as if it were there.
    auto residents = std::exchange(residents_, {});
    ksquadCount_ = 0;
    sendTables(tables);
    residents_ = std::move(residents);
    ksquadCount_ = static_cast<std::uint32_t>(tables.ksquads.size());
}

void GpuScene::sendTables(const PackedTables<float>& tables)
{
    send(ksquads_, BINDING_KSQUADS, tables.ksquads);
    send(spanTables_, BINDING_SPAN_TABLES, tables.spanTables);
}

void GpuScene::setFriends(const std::vector<std::uint8_t>& sides)
{
    if (const auto before = edges_.setFriends(sides))
        sendBorders(*before);
}

void GpuScene::sendBorders(const BorderTables& before)
{
    const BorderTables& after = edges_.tables();
    sendChanges(borderSides_, BINDING_BORDER_SIDES, before.sides, after.sides);
    sendChanges(borderCorners_, BINDING_BORDER_CORNERS, before.corners, after.corners);
    sendChanges(borderPieces_, BINDING_BORDER_PIECES, before.pieces, after.pieces);
    sendChanges(borderUses_, BINDING_BORDER_USES, before.uses, after.uses);
}

Box GpuScene::bounds() const
{
    Box box = boxes_.all();
    box.add(meshBox_);
    return box;
}

void GpuScene::listMemory(std::vector<HeldMemory>& to) const
{
    to.push_back({"control points", controlPoints_.bytes()});
    to.push_back({"span tables", spanTables_.bytes()});
    to.push_back({"KSQuad records", ksquads_.bytes()});
    to.push_back({"surface records", surfaces_.bytes()});
    to.push_back({"trim loops", trimWords_.bytes()});
    to.push_back({"surface views", surfaceViews_.bytes() + shownShellBuffer_.bytes()});
    to.push_back({"borders", borderSides_.bytes() + borderCorners_.bytes() + borderPieces_.bytes() +
                                 borderUses_.bytes()});
}

void GpuScene::forget()
{
    residents_.clear();
    held_ = {};
    boxes_ = {};
    trims_ = {};
    log_.restart();
    records_.clear();
    views_.clear();
    shownShells_.clear();
    ksquadCount_ = 0;
    pointCount_ = 0;
}

void GpuScene::updateViews(const Camera& camera, const Tinted& tinted, const SideTables& sides)
{
    Viewed wanted{camera, tinted.highlighted, tinted.hovered, sides.revision};
    const auto changed = log_.since(std::exchange(viewedAt_, log_.now()));
    if (changed && sides.revision != 0 && wanted == viewed_ && views_.size() == residents_.size()) {
        for (const std::uint32_t k : *changed) {
            const gpu::SurfaceView before = std::exchange(views_[k], viewOf(k, wanted, sides));
            if (std::memcmp(&before, &views_[k], sizeof(before)) != 0)
                uploader_.write(surfaceViews_, k, all(views_).subspan(k, 1));
        }
        return;
    }
    std::vector<gpu::SurfaceView> views;
    views.reserve(residents_.size());
    for (size_t k = 0; k < residents_.size(); ++k)
        views.push_back(viewOf(k, wanted, sides));
    viewed_ = std::move(wanted);
    const auto before = std::exchange(views_, std::move(views));
    sendChanges(surfaceViews_, BINDING_SURFACE_VIEWS, before, views_);
    const auto shownBefore = std::exchange(shownShells_, sides.shown);
    sendChanges(shownShellBuffer_, BINDING_SHOWN_SHELLS, shownBefore, shownShells_);
}

gpu::SurfaceView GpuScene::viewOf(size_t k, const Viewed& as, const SideTables& sides) const
{
    const Resident& resident = residents_[k];
    gpu::SurfaceView view = surfaceView(resident, as.camera, sides.sides[k], sides.shells[k]);
    if (std::find(as.highlighted.begin(), as.highlighted.end(), resident.id) != as.highlighted.end())
        view.highlight = 1.0F;
    else if (resident.id == as.hovered)
        view.highlight = 0.5F;
    return view;
}

void GpuScene::provide(Buffer& buffer, int binding, VkDeviceSize bytes)
{
    uploader_.forget(buffer);
    bindings_.provide(binding, buffer, bytes);
}

template <class T>
void GpuScene::send(Buffer& buffer, int binding, const std::vector<T>& elements)
{
    provide(buffer, binding, elements.size() * sizeof(T));
    uploader_.write(buffer, 0, all(elements));
}

// Runs of records that differ.
template <class T>
void GpuScene::sendChanges(Buffer& buffer, int binding, const std::vector<T>& before,
                           const std::vector<T>& after)
{
    if (before.size() != after.size()) {
        send(buffer, binding, after);
        return;
    }
    for (size_t first = 0; first < after.size();) {
        size_t end = first;
        while (end < after.size() && std::memcmp(&before[end], &after[end], sizeof(T)) != 0)
            ++end;
        uploader_.write(buffer, first, all(after).subspan(first, end - first));
        first = end + 1;
    }
}

}  // namespace knotspan
