#include "renderer/measurement/path_measurement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "renderer/leak_count.h"
#include "renderer/measurement/closed_model.h"

namespace knotspan {

namespace {

using Clock = std::chrono::steady_clock;

// Where frames take longer than this together, fewer of them do.
constexpr double kPatienceMs = 1500;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

template <class Number>
std::optional<Number> larger(const std::optional<Number>& a, const std::optional<Number>& b)
{
    return a && b ? std::max(*a, *b) : a ? a : b;
}

template <class Number>
std::optional<Number> sum(const std::optional<Number>& a, const std::optional<Number>& b)
{
    return a && b ? *a + *b : a ? a : b;
}

// Around the target, by Rodrigues' formula; too little for other triangles.
Camera turned(Camera camera, int k)
{
    const double angle = 1e-5 * k;
    const Vec3 axis = glm::normalize(camera.up);
    const Vec3 arm = camera.eye - camera.target;
    camera.eye = camera.target + arm * std::cos(angle) + glm::cross(axis, arm) * std::sin(angle) +
                 axis * glm::dot(axis, arm) * (1 - std::cos(angle));
    return camera;
}

}  // namespace

std::vector<PathRow> plannedRows(const PathMeasurementRequest& request,
                                 const std::function<std::string(PathId)>& whyUnavailable)
{
    std::vector<PathRow> rows;
    for (const Deformation motion : request.motions)
        for (const PathId path : request.paths) {
            PathRow row{.path = path, .motion = motion, .unavailable = whyUnavailable(path)};
            if (!row.unavailable.empty()) {
                rows.push_back(row);
                continue;
            }
            for (const Evaluator evaluator : request.evaluators) {
                row.evaluator = evaluator;
                if (!pathInfo(path).followsTolerance) {
                    rows.push_back(row);
                    continue;
                }
                for (const double tolerance : request.tolerances) {
                    rows.push_back(row);
                    rows.back().tolerancePx = tolerance;
                }
            }
        }
    return rows;
}

PathMeasurement::PathMeasurement(Renderer& renderer, Scene rest, PathMeasurementRequest request)
    : renderer_(renderer),
      rest_(std::move(rest)),
      isClosed_(isClosedModel(rest_)),
      request_(std::move(request)),
      rows_(plannedRows(request_, [&](PathId path) { return renderer_.whyUnavailable(path); }))
{
    check(request_.frames > 0, "a measurement has frames");
    request_.frame.overlays = {};
    skipDone();
}

void PathMeasurement::skipDone()
{
    while (row_ < rows_.size() && !rows_[row_].unavailable.empty())
        ++row_;
}

bool PathMeasurement::step()
{
    if (row_ == rows_.size())
        return false;
    PathRow& row = rows_[row_];
    const bool errorsAreNext = hasFramesEnough();
    const Result<void> drawn = errorsAreNext ? drawErrors(row) : drawFrame(row);
    if (!drawn)
        row.unavailable = drawn.error().sentence();
    if (!drawn)
        endRow();
    else if (errorsAreNext)
        endView(row);
    return row_ < rows_.size();
}

void PathMeasurement::endView(PathRow& row)
{
    timedInView_ = 0;
    if (++view_ < views())
        return;
    row.frameMs = spreadOf(frameMs_);
    const FrameStats errors = std::move(row.stats);
    row.stats = combined(frames_);
    row.stats.errorPxMax = errors.errorPxMax;
    row.stats.errorPxMean = errors.errorPxMean;
    row.stats.errorPixelsLost = errors.errorPixelsLost;
    row.stats.errorBoundPx = errors.errorBoundPx;
    row.stats.leakPixels = errors.leakPixels;
    endRow();
}

void PathMeasurement::endRow()
{
    rows_[row_].measured = rows_[row_].unavailable.empty();
    drawn_ = 0;
    view_ = 0;
    timedInView_ = 0;
    frames_.clear();
    frameMs_.clear();
    ++row_;
    skipDone();
}

bool PathMeasurement::hasFramesEnough() const
{
    return timedInView_ == request_.frames ||
           (timedInView_ > 0 && millisecondsSince(timingStarted_) > kPatienceMs);
}

Frame PathMeasurement::frameOf(const PathRow& row, int k) const
{
    Frame frame = request_.frame;
    frame.camera = turned(request_.flight.empty() ? frame.camera : request_.flight[view_], k);
    frame.path = row.path;
    frame.evaluator = row.evaluator;
    frame.tolerancePx = row.tolerancePx.value_or(frame.tolerancePx);
    frame.shading = Shading::shaded;
    frame.wave = wave_;
    return frame;
}

Result<void> PathMeasurement::drawFrame(PathRow& row)
{
    const DeformedScene moved =
        deformedFor(pathInfo(row.path).drawsFromDevice, rest_, row.motion, drawn_ + 1);
    if (auto synced = renderer_.sync(moved.scene, moved.joins); !synced)
        return synced;
    wave_ = moved.wave;
    Result<FrameStats> stats = renderer_.draw(frameOf(row, drawn_));
    if (!stats)
        return tl::unexpected(stats.error());
    // The first one compiled shaders and took whatever was new to the renderer.
    if (drawn_++ == 0) {
        timingStarted_ = Clock::now();
        return {};
    }
    if (++timedInView_ == 1 && view_ > 0)
        timingStarted_ = Clock::now();
    frameMs_.push_back(stats->cpuMs.median + stats->gpuMs.median);
    frames_.push_back(std::move(*stats));
    return {};
}

// The last frame once more, so that its figures and its errors are of one picture.
Result<void> PathMeasurement::drawErrors(PathRow& row)
{
    Frame frame = frameOf(row, drawn_ - 1);
    frame.shading = Shading::error;
    const Result<FrameStats> errors = renderer_.draw(frame);
    if (!errors)
        return tl::unexpected(errors.error());
    // The largest of all views, the mean of their means.
    FrameStats& sofar = row.stats;
    sofar.errorPxMax = larger(sofar.errorPxMax, errors->errorPxMax);
    sofar.errorBoundPx = larger(sofar.errorBoundPx, errors->errorBoundPx);
    sofar.errorPixelsLost = sum(sofar.errorPixelsLost, errors->errorPixelsLost);
    if (errors->errorPxMean)
        sofar.errorPxMean =
            sofar.errorPxMean.value_or(0) + *errors->errorPxMean / static_cast<double>(views());
    return isClosed_ ? countLeaks(row) : Result<void>();
}

// A deformation moves what is at one place alike, so that a closed model stays one.
Result<void> PathMeasurement::countLeaks(PathRow& row)
{
    const auto shown = renderer_.captureKsQuads();
    if (!shown)
        return tl::unexpected(shown.error());
    const double error = std::max(frames_.back().tolerancePx, row.stats.errorPxMax.value_or(0));
    const auto leaks =
        knotspan::countLeaks(deformed(rest_, row.motion, drawn_), frameOf(row, drawn_ - 1), *shown, error);
    row.stats.leakPixels = row.stats.leakPixels.value_or(0) + leaks;
    return {};
}

}  // namespace knotspan
