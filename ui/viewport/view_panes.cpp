#include "ui/viewport/view_panes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotspan {

namespace {

constexpr int kGapPx = 2;

size_t paneCount(PaneLayout layout)
{
    return layout == PaneLayout::one ? 1 : layout == PaneLayout::two ? 2 : 4;
}

}  // namespace

void ViewPanes::setLayout(PaneLayout layout, const Camera& camera)
{
    if (layout == layout_)
        return;
    before_[layout_] = {cameras_, current_};
    layout_ = layout;
    if (const auto known = before_.find(layout); known != before_.end()) {
        cameras_ = known->second.cameras;
        current_ = known->second.current;
    } else {
        cameras_.assign(paneCount(layout), Eye{});
        // Of four the free view stands where people look for it: at the upper right.
        current_ = layout == PaneLayout::four ? 1 : 0;
    }
    cameras_[current_] = {camera, true};
}

void ViewPanes::forgetCameras()
{
    before_.clear();
    for (Eye& eye : cameras_)
        eye.isSet = false;
}

Camera ViewPanes::makeCurrent(size_t pane, const Camera& camera)
{
    cameras_[current_] = {camera, true};
    current_ = pane;
    return cameras_[pane].camera;
}

std::vector<PaneRect> ViewPanes::rects(int width, int height) const
{
    const int columns = layout_ == PaneLayout::one ? 1 : 2;
    const int rows = layout_ == PaneLayout::four ? 2 : 1;
    const int paneWidth = std::max((width - kGapPx * (columns - 1)) / columns, 1);
    const int paneHeight = std::max((height - kGapPx * (rows - 1)) / rows, 1);
    std::vector<PaneRect> rects;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            rects.push_back(
                {column * (paneWidth + kGapPx), row * (paneHeight + kGapPx), paneWidth, paneHeight});
    return rects;
}

std::optional<size_t> ViewPanes::at(const Vec2& pixel, int width, int height) const
{
    const std::vector<PaneRect> all = rects(width, height);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const PaneRect& rect) { return rect.holds(pixel); });
    if (found == all.end())
        return std::nullopt;
    return static_cast<size_t>(found - all.begin());
}

ViewPanes::StartView ViewPanes::startView(size_t pane) const
{
    static constexpr std::array<StartView, 4> kFour{
        {{"top", true}, {"iso", false}, {"front", true}, {"right", true}}};
    static constexpr std::array<StartView, 2> kTwo{{{"iso", false}, {"top", true}}};
    if (layout_ == PaneLayout::four)
        return kFour[pane];
    return layout_ == PaneLayout::two ? kTwo[pane] : StartView{"iso", false};
}

std::string_view viewTitle(const Camera& camera)
{
    struct Axis {
        std::string_view title;
        Vec3 direction;
    };
    static const std::array<Axis, 6> kAxes{{{"FRONT", {0, 1, 0}},
                                            {"BACK", {0, -1, 0}},
                                            {"LEFT", {1, 0, 0}},
                                            {"RIGHT", {-1, 0, 0}},
                                            {"TOP", {0, 0, -1}},
                                            {"BOTTOM", {0, 0, 1}}}};
    constexpr double kAlong = 1 - 1e-9;  // cosine
    const Vec3 forward = camera.forward();
    for (const Axis& axis : kAxes)
        if (glm::dot(forward, axis.direction) > kAlong)
            return axis.title;
    return camera.orthographic ? "PARALLEL" : "PERSPECTIVE";
}

}  // namespace knotspan
