// Everything one picture depends on, beside the scene itself.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "model/friends/edge_part.h"
#include "model/geometry/basis_evaluators.h"
#include "model/geometry/knot_insertion.h"
#include "model/scene/control_point_editing.h"
#include "model/scene/deformation.h"
#include "model/scene/scene.h"
#include "model/scene/surface_numbers.h"
#include "renderer/culling/cull_modes.h"
#include "renderer/paths/path_list.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/look.h"
#include "renderer/scene/render_lists.h"

namespace knotspan {

// What a picture shows where no surface is: sRGB.
constexpr std::uint8_t kBackground[3] = {43, 46, 52};

// Colours of overlays: 0xRRGGBB, sRGB. Blue lines and orange points stay apart for colour-blind eyes.
constexpr std::uint32_t kSelectedColour = 0xff6b1a;
constexpr std::uint32_t kHoverColour = 0xffffff;

// A control point to mark.
struct ControlPointMark {
    ObjectId object{};
    ControlPointIndex index;
    std::uint32_t colour = kSelectedColour;
    float sizePx = 10;

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

// A line on an object's surface where one of its parameters has a value.
struct IsoLine {
    ObjectId object{};
    Direction across = Direction::U;  // the parameter that stands still
    double parameter = 0;             // in the domain
    std::uint32_t colour = kHoverColour;
    double widthPx = 3;

    [[nodiscard]] bool operator==(const IsoLine&) const = default;
};

// A straight line in the picture itself, in front of everything; it may taper, as an arrow's head does.
struct Stroke {
    Vec2 from{0};  // pixels from the upper left corner
    Vec2 to{0};
    std::uint32_t colour = kHoverColour;
    float widthFromPx = 2;
    float widthToPx = 2;
    float opacity = 1;

    [[nodiscard]] bool operator==(const Stroke&) const = default;
};

// A flat piece of the picture itself, in front of everything but strokes.
struct Patch {
    std::array<Vec2, 4> corners{};  // pixels from the upper left corner, around it, convex
    std::uint32_t colour = 0;       // 0xRRGGBB, sRGB
    float opacity = 1;

    [[nodiscard]] bool operator==(const Patch&) const = default;
};

// Straight lines in the model itself, of one colour and width. What surfaces hide of them does not show.
struct SpaceLine {
    Vec3 from{0};  // model space
    Vec3 to{0};

    [[nodiscard]] bool operator==(const SpaceLine&) const = default;
};
struct SpaceLines {
    std::vector<SpaceLine> lines;
    std::uint32_t colour = kHoverColour;
    float widthPx = 1.5F;
};
// Equal where it is the same one: so whoever shows the same lines again hands the same pointer on.
using SharedSpaceLines = std::shared_ptr<const SpaceLines>;

struct Overlays {
    bool controlNets = false;           // of all objects that are not locked
    std::vector<ObjectId> netsOf;       // of these, whatever controlNets says
    bool points = true;                 // of those nets: the control points
    bool hulls = true;                  // and the lines between them
    bool knotLines = false;             // the KSQuads' borders on every surface
    int isoCurves = 0;                  // parts that lines cut every KSQuad into, each way; below 2: none
    bool outlines = false;              // the borders of what trim loops leave of each surface
    bool normals = false;               // a line to the front of each KSQuad of which something is left
    std::vector<ObjectId> highlighted;  // objects drawn as selected
    std::optional<ObjectId> hovered;    // drawn as what a click would take
    std::vector<ControlPointMark> marks;
    std::vector<EdgeLine> edgeLines;           // what surfaces hide of them does not show
    std::vector<IsoLine> isoLines;             // likewise
    std::vector<SharedSpaceLines> spaceLines;  // none of them null
    std::vector<Patch> patches;
    std::vector<Stroke> strokes;

    [[nodiscard]] bool operator==(const Overlays&) const = default;
    // Whether anything is drawn from control points.
    [[nodiscard]] bool showNets() const
    {
        return ((controlNets || !netsOf.empty()) && (points || hulls)) || !marks.empty();
    }
};

// Where a frame stands in a picture of several views.
struct Pane {
    int x = 0;  // of its upper left corner, pixels
    int y = 0;
    int sheetWidth = 0;  // of the whole picture
    int sheetHeight = 0;

    [[nodiscard]] bool operator==(const Pane&) const = default;
};

struct Frame {
    Camera camera;
    int width = 1280;
    int height = 800;
    PathId path{};
    CullSet culling;
    bool countWrongCulls = false;  // how often culling drops what shows: costs time, changes nothing
    SamplingRule sampling;         // default: what the path takes by default
    double pixelRatio = 1;  // pixels in one of the hand's: overlays say their widths and sizes in those,
                            // but for patches and strokes
    double tolerancePx = 0.5;
    bool smoothEdges = true;  // of trimmed surfaces, by how much of a pixel they cover; without it is faster
    Evaluator evaluator = Evaluator::automatic;  // by the largest degree that shows
    Shading shading = Shading::shaded;
    Look look;                        // what those shadings are told that have something to choose
    SharedSurfaceNumbers deviations;  // that the shading `deviation` shows; null: none are known
    std::optional<Wave>
        wave;  // moves control points on the device; paths that do not draw from there stay at rest
    Overlays overlays;
    // Where culling looks from, if not from `camera`. What it drops is outlined in the colours of the modes.
    std::optional<Camera> cullingCamera;
    // What is shown and captured is then the whole picture, which keeps what earlier frames put beside this.
    std::optional<Pane> pane;

    [[nodiscard]] bool operator==(const Frame&) const = default;
};

}  // namespace knotspan
