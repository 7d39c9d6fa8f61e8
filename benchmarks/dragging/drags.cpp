#include "benchmarks/dragging/drags.h"

#include "model/samples/sample_list.h"

namespace knotspan::benchmarks {

namespace {

ControlPointIndex gripOf(const NurbsSurface& surface, Grip grip)
{
    return {grip == Grip::inside ? (surface.countU() - 1) / 2 : 0, (surface.countV() - 1) / 2};
}

template <class Value>
Spread spreadOver(size_t count, const Value& value)
{
    std::vector<double> values;
    for (size_t k = 0; k < count; ++k)
        values.push_back(static_cast<double>(value(k)));
    return spreadOf(std::move(values));
}

}  // namespace

Result<DragsBenchmark::Drag> DragsBenchmark::begin(const DragsRequest& request, const std::string& sample,
                                                   Grip grip)
{
    auto renderer = Renderer::create(request.renderer);
    if (!renderer)
        return tl::unexpected(renderer.error());
    Scene scene = findSample(sample)->make();
    const auto& [id, object] = *scene.objects().begin();
    const PointSelection selection(id, NetSize{object->surface.countU(), object->surface.countV()},
                                   {gripOf(object->surface, grip)});
    auto drag = PointDrag::begin(scene, selection, {});
    if (!drag)
        return tl::unexpected(drag.error());
    Frame frame;
    frame.width = request.width;
    frame.height = request.height;
    frame.path = request.path.value_or((*renderer)->bestPath());
    frame.culling = request.culling.value_or(defaultCulling());
    frame.camera = namedView("iso", scene.hullPoints(), double(frame.width) / frame.height, false).value();
    const double step = 1e-3 * object->surface.bounds().diagonal();
    return Drag{sample, grip, std::move(*renderer), std::move(scene), std::move(*drag), step, frame, {}, {}};
}

Result<DragsBenchmark> DragsBenchmark::open(const DragsRequest& request)
{
    DragsBenchmark benchmark;
    for (const Grip grip : request.grips)
        for (const std::string& sample : request.samples) {
            auto drag = begin(request, sample, grip);
            if (!drag)
                return tl::unexpected(drag.error());
            benchmark.drags_.push_back(std::move(*drag));
        }
    return benchmark;
}

// To and fro, so that the model stays what it is.
Result<void> DragsBenchmark::drawNext(Drag& drag, int frame)
{
    const int phase = frame % 40;
    const double way = drag.step * (phase < 20 ? phase : 40 - phase);
    const double started = processorMs();
    auto edit = drag.drag.moved(Vec3(0, 0, way));
    if (!edit)
        return tl::unexpected(edit.error());
    edit->applyTo(drag.scene);
    const double edited = processorMs() - started;
    if (auto synced = drag.renderer->sync(drag.scene); !synced)
        return synced;
    auto stats = drag.renderer->draw(drag.frame);
    if (!stats)
        return tl::unexpected(stats.error());
    drag.edits.push_back(edited);
    drag.stats.push_back(std::move(*stats));
    return {};
}

Result<std::vector<DragRow>> DragsBenchmark::measure(int frames)
{
    // The first ones compile shaders, send the model and tear what the drag tears.
    constexpr int kWarm = 6;
    for (int frame = 0; frame < kWarm + frames; ++frame)
        for (Drag& drag : drags_) {
            if (auto drawn = drawNext(drag, frame); !drawn)
                return tl::unexpected(drawn.error());
            if (frame < kWarm) {
                drag.stats.clear();
                drag.edits.clear();
            }
        }
    std::vector<DragRow> rows;
    for (const Drag& drag : drags_) {
        const auto over = [&](const auto& value) { return spreadOver(drag.stats.size(), value); };
        const auto work = [&](size_t k) -> const FrameWork& { return drag.stats[k].work; };
        DragRow row{drag.sample,
                    drag.grip,
                    drag.stats.back().surfaces,
                    drag.stats.back().ksquads,
                    {},
                    {},
                    {},
                    {},
                    {},
                    {},
                    {},
                    {}};
        row.uploadBytes = over([&](size_t k) { return drag.stats[k].uploadBytesPerFrame; });
        row.edit = over([&](size_t k) { return drag.edits[k]; });
        row.sync = over([&](size_t k) { return work(k).sync; });
        row.prepare = over([&](size_t k) { return work(k).prepare; });
        row.record = over([&](size_t k) { return work(k).record; });
        row.finish = over([&](size_t k) { return work(k).finish; });
        row.outside = over([&](size_t k) { return drag.edits[k] + work(k).sync + work(k).prepare; });
        row.before = over([&](size_t k) { return drag.edits[k] + work(k).before(); });
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace knotspan::benchmarks
