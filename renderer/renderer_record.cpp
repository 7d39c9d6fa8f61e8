// A frame as the stages read it.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/trigonometric.hpp>

#include "renderer/renderer_parts.h"
#include "renderer/scene/look_record.h"

namespace knotspan {

namespace {

// The area and edge rules' KSDie at a tolerance: half a pixel of tolerance gives the papers' 8 pixels.
constexpr double kDiePxPerTolerance = 16.0;

double pixelsPerUnit(const Camera& camera, int height)
{
    const double half = std::tan(glm::radians(camera.verticalFovDegrees) * 0.5);
    return 0.5 * height / (camera.orthographic ? half * camera.distance() : half);
}

std::uint32_t ruleNumber(SamplingRule::Kind kind)
{
    switch (kind) {
    case SamplingRule::Kind::area:
    case SamplingRule::Kind::areaNoFriends:
        return RULE_AREA;
    case SamplingRule::Kind::edge:
        return RULE_EDGE;
    case SamplingRule::Kind::fixed:
        return RULE_FIXED;
    default:
        return RULE_BOUND;
    }
}

}  // namespace

void Renderer::Parts::uploadRecord(const gpu::FrameRecord& record)
{
    if (frameRecord_ && std::memcmp(&*frameRecord_, &record, sizeof(record)) == 0)
        return;
    frameRecord_ = record;
    uploader.write(frameBuffer_, 0, std::span(&record, 1));
}

void Renderer::Parts::updateFrameRecord(const Frame& frame, SurfacePath& path, SamplingRule rule,
                                        bool capture)
{
    gpu::FrameRecord record{};
    Box bounds = scene.bounds();
    if (frame.wave && !bounds.isEmpty()) {
        const Vec3 reach(2 * frame.wave->amplitude);
        bounds.add(bounds.low - reach);
        bounds.add(bounds.high + reach);
    }
    record.projection =
        gpu::mat4(frame.camera.projection(static_cast<double>(frame.width) / frame.height, bounds));
    record.pixelsPerUnit = static_cast<float>(pixelsPerUnit(frame.camera, frame.height));
    record.pixels = {static_cast<float>(frame.width), static_cast<float>(frame.height)};
    record.tolerancePx = static_cast<float>(frame.tolerancePx);
    record.samplingRule = ruleNumber(rule.kind);
    record.diePx = static_cast<float>(kDiePxPerTolerance * frame.tolerancePx);
    record.fixedDice = static_cast<std::uint32_t>(rule.count);
    if (const auto limits = path.tiles()) {
        record.snap = limits->snap;
        record.tileSide = limits->side;
        record.tileVertices = limits->vertices;
        record.tileTriangles = limits->triangles;
        record.ringTriangles = limits->ringTriangles;
        record.tileCapacity = sampling.tileCapacity();
        record.tilesPerDraw = std::max(1U, std::min(limits->tilesPerDraw, sampling.tileCapacity()));
        record.taskTiles = limits->taskTiles;
    }
    record.cullBits = frame.culling.bits;
    record.judgedBits = judgedBits(frame, path, rule);
    record.ksquadCount = scene.ksquadCount();
    record.surfaceCount = static_cast<std::uint32_t>(scene.residents().size());
    record.pointCount = scene.controlPointCount();
    record.flags = (frame.overlays.knotLines ? FRAME_KNOT_LINES : 0U) | (capture ? FRAME_CAPTURE : 0U) |
                   (frame.camera.orthographic ? FRAME_ORTHOGRAPHIC : 0U) |
                   (frame.shading == Shading::error ? FRAME_MEASURE_ERROR : 0U) |
                   (scene.isTrimmed() ? FRAME_TRIMMED : 0U) | verdictFlag_;
    record.handPx = static_cast<float>(frame.pixelRatio);
    record.isoCurves = static_cast<std::uint32_t>(std::max(frame.overlays.isoCurves, 0));
    record.captureCapacity = counters.captureCapacity();
    const double size = scene.bounds().diagonal();
    NumberRange range;
    if (frame.shading == Shading::curvature)
        range = curvatureRange.of(scene.residents(), frame.look, size, &scene.changes());
    else if (frame.shading == Shading::deviation)
        range = frame.look.deviationRange.value_or(deviations.range());
    fillLook(record, frame.shading, frame.look, frame.camera, size, range);
    if (path.tiles() && path.tiles()->wholeGrids)
        record.flags |= FRAME_WHOLE_TILES;
    path.prepare({scene, frame.camera, rule, frame.tolerancePx, static_cast<double>(frame.width),
                  static_cast<double>(frame.height), sides_, facing.arrays(), uploader, verdicts_},
                 record);
    uploadRecord(record);
}

}  // namespace knotspan
