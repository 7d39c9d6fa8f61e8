// Everything one picture depends on, beside the scene itself.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/friends/edge_part.h"
#include "model/geometry/basis_evaluators.h"
#include "model/scene/control_point_editing.h"
#include "model/scene/deformation.h"
#include "model/scene/scene.h"
#include "renderer/culling/cull_modes.h"
#include "renderer/paths/path_list.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/render_lists.h"

namespace knotspan {

// What a picture shows where no surface is: sRGB.
constexpr std::uint8_t kBackground[3] = {43, 46, 52};

// A control point to mark, and how.
struct ControlPointMark {
    ObjectId object{};
    ControlPointIndex index;
    bool selected = false;  // false: hovered

    [[nodiscard]] bool operator==(const ControlPointMark&) const = default;
};

// A line along an edge of an object.
struct EdgeLine {
    ObjectId object{};
    EdgePart edge;             // its `surface` does not count
    std::uint32_t colour = 0;  // 0xRRGGBB, sRGB
    double widthPx = 3;

    [[nodiscard]] bool operator==(const EdgeLine&) const = default;
};

struct Overlays {
    bool controlNets = false;           // of all objects
    std::vector<ObjectId> netsOf;       // of these, whatever controlNets says
    bool knotLines = false;             // the KSQuads' borders on every surface
    std::vector<ObjectId> highlighted;  // objects drawn as selected
    std::vector<ControlPointMark> marks;
    std::vector<EdgeLine> edgeLines;  // what surfaces hide of them does not show

    [[nodiscard]] bool operator==(const Overlays&) const = default;
    // Whether anything is drawn from control points.
    [[nodiscard]] bool showNets() const { return controlNets || !netsOf.empty() || !marks.empty(); }
};

struct Frame {
    Camera camera;
    int width = 1280;
    int height = 800;
    PathId path{};
    CullSet culling;
    bool countWrongCulls = false;  // how often culling drops what shows: costs time, changes nothing
    SamplingRule sampling;         // default: what the path takes by default
    double tolerancePx = 0.5;
    Evaluator evaluator = Evaluator::automatic;  // by the largest degree that shows
    Shading shading = Shading::shaded;
    std::optional<Wave>
        wave;  // moves control points on the device; paths that do not draw from there stay at rest
    Overlays overlays;
    // Where culling looks from, if not from `camera`. What it drops is outlined in the colours of the modes.
    std::optional<Camera> cullingCamera;

    [[nodiscard]] bool operator==(const Frame&) const = default;
};

}  // namespace knotspan
