// One way to turn visible KSQuads into triangles. A path is one file with a class and a
// factory, and one line in path_list.cpp; it knows no other path and no culling.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "model/geometry/basis_evaluators.h"
#include "renderer/paths/path_list.h"
#include "renderer/scene/facing_arrays.h"
#include "renderer/scene/gpu_scene.h"
#include "renderer/scene/render_lists.h"
#include "renderer/vulkan/pipeline.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

// What a path can draw at once: limits of a tile, a part of a KSQuad's grid.
struct TileLimits {
    std::uint32_t side = 64;  // cells along one side
    std::uint32_t vertices = ~0U;
    std::uint32_t triangles = ~0U;
    std::uint32_t tilesPerDraw = ~0U;  // where tiles are drawn as vertices, one each
    std::uint32_t taskTiles = 0;       // tiles a task group takes, where a task stage draws them
    std::uint32_t snap = 0;  // SNAP_... (shaders/shared/borders.glsl), by what triangles the path can draw
    // With SNAP_RING: whether a grid that fits may be one tile, and the most triangles of a part of a ring.
    bool wholeGrids = false;
    std::uint32_t ringTriangles = 254;
};

// The draws through the list of tiles.
struct TileDraws {
    VkBuffer draws = VK_NULL_HANDLE;  // gpu::DrawRecord, of which task stages read the first three numbers
    std::uint32_t count = 0;
};

// What a path that works on the CPU needs of a frame.
struct PathFrame {
    const GpuScene& scene;
    const Camera& camera;
    SamplingRule rule;
    double tolerancePx;
    double width;
    double height;
    const SideTables& sides;
    const FacingArrays& facing;  // made where a culling mode that is on reads it
    Uploader& uploader;
    const Buffer& verdicts;  // as verdicts.glsl has them, where the record says so
};

// What a path's pipelines are made for.
struct PathVariant {
    Specialization specialization;
    enum class Fragments { lit, exact, error };
    Fragments fragments = Fragments::lit;
    bool cullsDice = false;  // culling by evs, where PathInfo says that the path can
    bool trimmed = false;    // surfaces are, in the fragment stage

    [[nodiscard]] const char* fragmentStage() const
    {
        if (fragments == Fragments::error)
            return trimmed ? "surface_error_trimmed.frag" : "surface_error.frag";
        if (fragments == Fragments::exact)
            return trimmed ? "surface_exact_trimmed.frag" : "surface_exact.frag";
        return trimmed ? "surface_trimmed.frag" : "surface.frag";
    }
    [[nodiscard]] auto operator<=>(const PathVariant&) const = default;
};

class SurfacePath {
public:
    virtual ~SurfacePath() = default;

    // Nothing: the path culls and samples by itself. Otherwise culling and sampling make the list of tiles.
    [[nodiscard]] virtual std::optional<TileLimits> tiles() const = 0;

    // What of the scene its stages read.
    [[nodiscard]] virtual Packing packing() const { return Packing::ksquads; }

    // Which of the culling modes that are on the path follows.
    [[nodiscard]] virtual std::uint32_t followed(std::uint32_t cullBits, SamplingRule /*rule*/) const
    {
        return cullBits;
    }

    // What of the device holds the path back, as a sentence; empty: nothing worth telling.
    [[nodiscard]] virtual std::string limit() const { return {}; }

    // Whether the rule draws borders otherwise where they have a friend (BORDER_FRIEND).
    [[nodiscard]] virtual bool asksForFriends(const SamplingRule& /*rule*/) const { return false; }

    // What the path does on the CPU before the frame is recorded, and its limits in the frame's record.
    virtual void prepare(const PathFrame& /*frame*/, gpu::FrameRecord& /*record*/) {}
    // What it computes on the device before the rendering; bindings are set for compute.
    virtual void compute(VkCommandBuffer /*commands*/) const {}
    // What it counts itself, beside what stages count.
    virtual void count(gpu::Counters& /*counters*/) const {}
    // What was written to the device for the last frame may not have arrived.
    virtual void forget() {}
    // False: the frame wanted more room than there was; there is now, and it is to be drawn again.
    [[nodiscard]] virtual bool hadRoom(const gpu::Counters& /*counted*/) { return true; }

    // Inside a rendering, with viewport and bindings set.
    virtual void draw(VkCommandBuffer commands, std::uint32_t ksquads, const TileDraws& tiles) const = 0;
};

// What sampling.comp can do for any path that draws its tiles.
[[nodiscard]] std::vector<SamplingRule> tileRules();

// The draws of tiles as vertices.
void drawIndirect(VkCommandBuffer commands, const Device& device, const TileDraws& tiles);

struct PathFactory {
    PathInfo info;
    // Empty where the device can run it, otherwise the reason as a sentence.
    std::string (*whyUnavailable)(const Device& device);
    std::unique_ptr<SurfacePath> (*create)(const Device& device, Bindings& bindings,
                                           const PathVariant& variant);
};

// In the order of paths().
[[nodiscard]] const std::vector<PathFactory>& pathFactories();
[[nodiscard]] const PathFactory& pathFactory(PathId id);

// One a file.
[[nodiscard]] PathFactory computePath();
[[nodiscard]] PathFactory cpuPath();
[[nodiscard]] PathFactory geometryPath();
[[nodiscard]] PathFactory meshPath();
[[nodiscard]] PathFactory mesh9x9Path();
[[nodiscard]] PathFactory tessellationPath();
[[nodiscard]] PathFactory tessellationAdaptivePath();
[[nodiscard]] PathFactory wholeSurfacePath();
[[nodiscard]] PathFactory bezierPath();

}  // namespace knotspan
