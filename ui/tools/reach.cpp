#include "ui/tools/reach.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/sculpting/twins.h"

namespace knotspan {

namespace {

constexpr size_t kMostMarks = 5000;
constexpr double kLeastPx = 6;  // as a net's points are, or they would not show
constexpr double kMostPx = 10;

// From blue over teal and yellow to orange: apart for colour-blind eyes, too, and never grey.
std::uint32_t colourOf(double share)
{
    constexpr int kStops[4][3] = {
        {0x3b, 0x6f, 0xd4}, {0x36, 0xb5, 0xa0}, {0xf2, 0xd1, 0x3c}, {0xff, 0x6b, 0x1a}};
    const double place = 3 * std::clamp(share, 0.0, 1.0);
    const int stop = std::min(static_cast<int>(place), 2);
    std::uint32_t colour = 0;
    for (int part = 0; part < 3; ++part) {
        const double from = kStops[stop][part];
        const double to = kStops[stop + 1][part];
        colour = colour << 8U | static_cast<std::uint32_t>(std::lround(from + (place - stop) * (to - from)));
    }
    return colour;
}

}  // namespace

std::set<ObjectId> mayFollow(const Scene& scene, const DragSettings& settings)
{
    const bool inSpace = settings.falloff.radius > 0 && settings.falloff.distance == FalloffDistance::space;
    std::set<ObjectId> others;
    if (inSpace || settings.symmetry.kind == SymmetryKind::plane)
        for (const auto& [id, object] : scene.objects())
            if (object->visible && !object->locked)
                others.insert(id);
    return others;
}

std::vector<ControlPointMark> marksOf(const Followers& followers, const PointSelection& leaders)
{
    size_t count = 0;
    for (const auto& [id, list] : followers)
        count += list.size();
    const size_t stride = count / kMostMarks + 1;
    std::vector<ControlPointMark> marks;
    size_t at = 0;
    for (const auto& [id, list] : followers)
        for (const Follower& follower : list)
            if (at++ % stride == 0 && !leaders.contains({id, follower.index}))
                marks.push_back({id, follower.index, colourOf(follower.share),
                                 static_cast<float>(kLeastPx + follower.share * (kMostPx - kLeastPx))});
    return marks;
}

bool ShownReach::find(const ToolContext& context, const std::optional<ScenePoint>& under)
{
    if (!under || !(context.settings.drag.falloff.radius > 0)) {
        asked_.reset();
        return !std::exchange(marks_, {}).empty();
    }
    const Asked asked{*under, context.settings.drag, watch_.change(context)};
    if (asked_ == asked)
        return false;
    asked_ = asked;
    const Scene& scene = context.document.scene();
    const PointSelection& selected = context.selection.points();
    const PointSelection leaders =
        withTwins(scene, selected.contains(*under) ? selected : pointOf(scene, *under));
    std::vector<ControlPointMark> marks = marksOf(
        followersOf(scene, leaders, asked.settings.falloff, mayFollow(scene, asked.settings)), leaders);
    return std::exchange(marks_, std::move(marks)) != marks_;
}

}  // namespace knotspan
