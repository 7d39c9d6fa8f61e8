// The renderer: takes scenes and frames, gives pictures and figures. No Qt, no display needed.
//
// sync() uploads what changed, draw() makes one picture in the renderer's own image, capture() reads it back,
// present() copies it to a window. Calls come from one thread. After a call failed because the device was
// lost, all further ones fail and a new Renderer is to be made.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/basis_evaluators.h"
#include "model/scene/scene.h"
#include "renderer/frame.h"
#include "renderer/scene/held_memory.h"
#include "renderer/stats/frame_stats.h"
#include "renderer/swapchain.h"

namespace knotspan {

// 8-bit sRGB with opacity, rows from the top, no padding.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

// Which KSQuad each pixel shows: 0 the background, k the k-th of all visible objects' KSQuads, object by
// object as Scene has them, counted from 1. Rows from the top, no padding. Colours have no part in it.
struct KsQuadIndices {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> indices;
};

// What is under a pixel.
struct PickedControlPoint {
    ObjectId object{};
    ControlPointIndex index;
};
struct PickedPlace {
    ObjectId object{};
    int spanU = 0;  // the KSQuad (model/geometry/ksquad.h)
    int spanV = 0;
    Vec3 position{0};  // in model space, as far off the surface as the picture is
};
struct Pick {
    // The nearest one of a shown net within the radius; none of locked objects, nor where points do not show.
    std::optional<PickedControlPoint> controlPoint;
    double distancePx = 0;             // from there
    std::optional<PickedPlace> place;  // of the surface at the pixel

    [[nodiscard]] std::optional<ObjectId> object() const
    {
        return place ? std::optional(place->object) : std::nullopt;
    }
};

// A vertex as a GPU stage computed it, for tests and measurements.
struct CapturedVertex {
    ObjectId object{};
    int spanU = 0;
    int spanV = 0;
    double u = 0;  // local to the span, 0 .. 1
    double v = 0;
    Vec3 position{};  // relative to surfaceOrigin(object), object space
    Vec3 normal{};    // unit, object space
    Vec4 clip{};      // where it is drawn, as the stage has it: neighbours share these bits along their edges
};

// Evaluation by itself, in the compute stage. Where in a KSQuad of a visible object:
struct EvaluationPoint {
    ObjectId object{};
    int spanU = 0;
    int spanV = 0;
    double u = 0;  // local to the span, 0 .. 1
    double v = 0;
};

// How: with which evaluator (automatic: by the largest degree that shows), in which number type, and how
// often, so that the device's time is a median.
struct EvaluationOptions {
    Evaluator evaluator = Evaluator::automatic;
    Precision precision = Precision::float32;
    int repeats = 1;
};

struct EvaluatedPoint {
    Vec3 position{};  // relative to surfaceOrigin(object), object space, as the rest
    Vec3 du{};        // by the span's own u, 0 .. 1
    Vec3 dv{};
    Vec3 normal{};  // unit
};
struct Evaluations {
    Evaluator evaluator{};               // the one in use
    std::vector<EvaluatedPoint> points;  // in the order of the question
    double gpuMs = 0;                    // without transfers; 0 where the device has no clock
};

// On what it draws, as a bug report names it.
struct DeviceInfo {
    std::string name;
    std::string driver;  // its name and version
    std::string vulkan;  // the version that the device has: "1.3.230"
};

struct RendererOptions {
    std::optional<int> device;  // index into devices(); default: the fastest kind of device
    bool validation = false;    // fails where the validation layer is not installed
    // Extensions that the window system asks for to make surfaces are switched on where the loader has them.
};

class Renderer {
public:
    // Fails, and says which package helps, where no Vulkan 1.3 device is found.
    [[nodiscard]] static Result<std::unique_ptr<Renderer>> create(const RendererOptions& options = {});
    // The names of the Vulkan devices of this machine, in the order of `--device N`.
    [[nodiscard]] static Result<std::vector<std::string>> devices();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    [[nodiscard]] const std::string& deviceName() const;
    [[nodiscard]] DeviceInfo deviceInfo() const;
    // Empty where the device can run the path, otherwise the reason, as a sentence.
    [[nodiscard]] std::string whyUnavailable(PathId path) const;
    [[nodiscard]] std::string whyUnavailable(Precision precision) const;  // the same for evaluate()
    [[nodiscard]] PathId bestPath() const;  // the first of paths() that is available

    // `kept`: nothing that lay along something else was torn from it or put to it since the last sync, and
    // the borders are not searched. A later sync does it, where it does not say so too.
    [[nodiscard]] Result<void> sync(const Scene& scene, Joins joins = Joins::anew);
    // Whether a frame like it was drawn: else the driver compiles its stages first, which may take seconds.
    [[nodiscard]] bool isPrepared(const Frame& frame) const;
    [[nodiscard]] Result<FrameStats> draw(const Frame& frame);
    [[nodiscard]] Result<Picture> capture();
    [[nodiscard]] Result<KsQuadIndices> captureKsQuads();
    // In the last drawn frame; x, y in pixels from its upper left corner.
    [[nodiscard]] Result<Pick> pick(double x, double y, double radiusPx = 8);

    // For a window: `surface` is a VkSurfaceKHR made for instance(), both as plain handles so that this
    // header needs no Vulkan. The renderer owns the surface's swapchain, not the surface.
    [[nodiscard]] void* instance() const;
    [[nodiscard]] Result<std::unique_ptr<Swapchain>> createSwapchain(std::uint64_t surface, int width,
                                                                     int height);
    // Shows the last drawn frame. False: the swapchain no longer fits its window and is to be made anew.
    [[nodiscard]] Result<bool> present(Swapchain& swapchain);

    // Diagnostics. captureVertices() draws the frame and returns every vertex that the path's stage computed.
    // evaluate() takes any number of points, fails where one is on no visible KSQuad or the device lacks the
    // precision.
    [[nodiscard]] Result<std::vector<CapturedVertex>> captureVertices(const Frame& frame);
    [[nodiscard]] Result<Evaluations> evaluate(const std::vector<EvaluationPoint>& points,
                                               const EvaluationOptions& options = {});
    [[nodiscard]] Vec3 surfaceOrigin(ObjectId object) const;
    // What of the scene and of its culling and sampling lies on the device, by kind.
    [[nodiscard]] std::vector<HeldMemory> memory() const;
    // What the validation layer said so far; empty without the layer and in a clean run.
    [[nodiscard]] std::vector<std::string> validationMessages() const;

private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace knotspan
