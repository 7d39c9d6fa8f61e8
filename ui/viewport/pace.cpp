#include "ui/viewport/pace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace knotspan {

namespace {

// Clocks are noisy: one frame in ten takes twice as long for no reason of ours. So nothing is decided by
// fewer frames than these, and by their median or by three quarters of them.
constexpr size_t kFewFrames = 3;    // where the answer is plain
constexpr size_t kManyFrames = 11;  // that are remembered

constexpr double kMuchTooLong = 2 * Pace::kFrameMs;
constexpr double kAimMs = 0.8 * Pace::kFrameMs;
// So far below the frame's time that even where all of it goes with the triangles some may come back.
constexpr double kPlentyMs = 0.6 * Pace::kFrameMs;
constexpr double kUseful = 0.9;  // of the time before: a looser tolerance has to save a tenth

constexpr double kLeastStep = 1.4;
constexpr double kMostStep = 4;

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

template <class Test>
bool threeQuartersOf(const std::vector<double>& values, const Test& test)
{
    return 4 * static_cast<size_t>(std::count_if(values.begin(), values.end(), test)) >= 3 * values.size();
}

}  // namespace

double Pace::afterDrawing(const Drawn& drawn, double askedPx)
{
    if (askedPx != askedPx_) {
        rest();
        askedPx_ = tolerancePx_ = askedPx;
        loosestPx_ = std::max(kLoosestPx, askedPx);
    }
    // A frame that was on its way when the tolerance changed tells nothing about this one.
    if (!std::isfinite(drawn.ms) || std::abs(drawn.tolerancePx - tolerancePx_) > 1e-6 * tolerancePx_)
        return tolerancePx_;
    times_.push_back(drawn.ms);
    if (times_.size() > kManyFrames)
        times_.erase(times_.begin());
    if (times_.size() < kFewFrames)
        return tolerancePx_;
    if (trial_)
        judge(*trial_);
    else if (threeQuartersOf(times_, [](double ms) { return ms > kFrameMs; }))
        loosen();
    else
        tighten();
    return tolerancePx_;
}

void Pace::changeTo(double tolerancePx)
{
    tolerancePx_ = tolerancePx;
    times_.clear();
}

// Plain gains are believed soon; else many frames are asked.
void Pace::judge(const Trial& trial)
{
    const double enough = kUseful * trial.beforeMs;
    const bool plain = std::all_of(times_.begin(), times_.end(), [&](double ms) { return ms <= enough; });
    if (!plain && times_.size() < kManyFrames)
        return;
    if (!plain && medianOf(times_) > enough) {
        loosestPx_ = trial.beforePx;
        changeTo(trial.beforePx);
    }
    trial_.reset();
}

void Pace::loosen()
{
    const bool plain = std::all_of(times_.begin(), times_.end(), [](double ms) { return ms > kMuchTooLong; });
    if (tolerancePx_ >= loosestPx_ || (!plain && times_.size() < kManyFrames))
        return;
    // Of few frames two may be among those that take twice as long.
    const double ms = plain ? *std::min_element(times_.begin(), times_.end()) : medianOf(times_);
    const double step = std::clamp(ms / kAimMs, kLeastStep, kMostStep);
    trial_ = Trial{tolerancePx_, ms};
    changeTo(std::min(tolerancePx_ * step, loosestPx_));
}

void Pace::tighten()
{
    if (tolerancePx_ <= askedPx_ || times_.size() < kManyFrames ||
        !threeQuartersOf(times_, [](double ms) { return ms < kPlentyMs; }))
        return;
    const double room = std::min(kAimMs / std::max(medianOf(times_), 0.1), kMostStep);
    if (room > 1)
        changeTo(std::max(tolerancePx_ / room, askedPx_));
}

}  // namespace knotspan
