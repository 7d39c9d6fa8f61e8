// One control point dragged in each of several models, frame by frame in turn: what a frame uploads and what
// it costs the application.
//
// Each drag has a Renderer of its own, and each frame is one event of the hand: the edit, the scene taken
// over, a picture. Times are processor time of the thread, so that they do not count what others do.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/core/spread.h"
#include "model/sculpting/point_drag.h"
#include "renderer/renderer.h"

namespace knotspan::benchmarks {

enum class Grip { inside, border };  // of the first surface's net: the middle; the middle of its first row

struct DragsRequest {
    std::vector<std::string> samples;
    std::vector<Grip> grips{Grip::inside, Grip::border};
    int frames = 200;
    int width = 64;
    int height = 64;
    std::optional<PathId> path;      // nothing: the best one here
    std::optional<CullSet> culling;  // nothing: the default
    RendererOptions renderer;
};

// Spreads over the frames, in milliseconds.
struct DragRow {
    std::string sample;
    Grip grip{};
    std::uint64_t surfaces = 0;
    std::uint64_t ksquads = 0;
    Spread uploadBytes;
    Spread edit;  // PointDrag::moved() and applying it
    Spread sync;
    Spread prepare;
    Spread record;
    Spread finish;   // FrameWork: the driver's, mostly
    Spread outside;  // of the driver: edit, sync, prepare
    Spread before;   // outside and record
};

class DragsBenchmark {
public:
    // Fails where there is no device, or it refuses a model.
    [[nodiscard]] static Result<DragsBenchmark> open(const DragsRequest& request);

    [[nodiscard]] const std::string& deviceName() const { return drags_.front().renderer->deviceName(); }
    [[nodiscard]] const std::string& pathName() const { return pathInfo(drags_.front().frame.path).name; }
    // By grip, within it by sample.
    [[nodiscard]] Result<std::vector<DragRow>> measure(int frames);

private:
    struct Drag {
        std::string sample;
        Grip grip;
        std::unique_ptr<Renderer> renderer;
        Scene scene;
        PointDrag drag;
        double step = 0;  // of the hand, in model units
        Frame frame;
        std::vector<FrameStats> stats;
        std::vector<double> edits;
    };
    [[nodiscard]] static Result<Drag> begin(const DragsRequest& request, const std::string& sample,
                                            Grip grip);
    [[nodiscard]] static Result<void> drawNext(Drag& drag, int frame);

    std::vector<Drag> drags_;
};

}  // namespace knotspan::benchmarks
