// What each path is worth on this machine: what a frame costs at a tolerance, and how far the picture is off.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/deformation.h"
#include "renderer/renderer.h"

namespace knotspan {

struct PathMeasurementRequest {
    Frame frame;  // camera, size, culling and rule; what is measured stands in place of the rest
    std::vector<Camera> flight;  // views in place of the frame's camera; empty: that one alone
    std::vector<PathId> paths;
    std::vector<double> tolerances;  // pixels, above 0
    std::vector<Evaluator> evaluators{Evaluator::automatic};
    std::vector<Deformation> motions{Deformation::none, Deformation::all};
    int frames = 5;  // that are timed in each view, after one that is not; fewer where they take long
};

struct PathRow {
    PathId path{};
    std::optional<double> tolerancePx;  // none: the path draws the same whatever the tolerance
    Evaluator evaluator{};              // as asked for; stats says which it was
    Deformation motion{};
    std::string unavailable;  // why there are no figures, as a sentence
    bool measured = false;
    // Of a frame with all its work, one thing after the other: the model's changes taken over, preparing and
    // recording, drawing. The first two are stats.cpuMs, the third is stats.gpuMs.
    Spread frameMs;
    FrameStats stats;  // of those frames; errors and leaks of each view's last one
};

// What there will be to measure: the combinations, with one row for a path that does not follow the tolerance
// and one for a path that cannot run, which has the reason.
[[nodiscard]] std::vector<PathRow> plannedRows(const PathMeasurementRequest& request,
                                               const std::function<std::string(PathId)>& whyUnavailable);

// The camera turns by a hair in every frame, as it does under a hand: what a path keeps for a picture that is
// drawn again would not be measured. Draws one frame a step, so that a caller can show how far it is, and
// stop. The renderer is the measurement's own until its end: it holds other scenes and pictures afterwards.
class PathMeasurement {
public:
    // The renderer outlives it.
    PathMeasurement(Renderer& renderer, Scene rest, PathMeasurementRequest request);

    // False where nothing is left. What fails is said in its row.
    bool step();

    [[nodiscard]] const std::vector<PathRow>& rows() const { return rows_; }
    [[nodiscard]] size_t rowsDone() const { return row_; }
    // Of the row that is being measured.
    [[nodiscard]] size_t viewsDone() const { return view_; }
    [[nodiscard]] size_t views() const { return std::max<size_t>(1, request_.flight.size()); }

private:
    [[nodiscard]] Result<void> drawFrame(PathRow& row);
    [[nodiscard]] Result<void> drawErrors(PathRow& row);
    [[nodiscard]] Result<void> countLeaks(PathRow& row);
    [[nodiscard]] bool hasFramesEnough() const;
    void endView(PathRow& row);
    [[nodiscard]] Frame frameOf(const PathRow& row, int k) const;
    void skipDone();
    void endRow();

    Renderer& renderer_;
    Scene rest_;
    bool isClosed_;
    PathMeasurementRequest request_;
    std::vector<PathRow> rows_;
    size_t row_ = 0;
    // Of the row that is being measured.
    int drawn_ = 0;
    size_t view_ = 0;
    int timedInView_ = 0;
    std::optional<Wave> wave_;  // of the last frame
    std::vector<FrameStats> frames_;
    std::vector<double> frameMs_;
    std::chrono::steady_clock::time_point timingStarted_;
};

}  // namespace knotspan
