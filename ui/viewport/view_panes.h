// One, two or four views of the model in one picture: where each stands, from where it looks, and which of
// them tools and commands work in.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "renderer/frame.h"

namespace knotspan {

enum class PaneLayout { one, two, four };

struct PaneRect {
    int x = 0;  // pixels of the whole picture
    int y = 0;
    int width = 1;
    int height = 1;

    [[nodiscard]] bool holds(const Vec2& at) const
    {
        return at.x >= x && at.y >= y && at.x < x + width && at.y < y + height;
    }
};

class ViewPanes {
public:
    [[nodiscard]] PaneLayout layout() const { return layout_; }
    [[nodiscard]] size_t count() const { return cameras_.size(); }
    // `camera` is that of the current pane, before and after. The others look from where they did when the layout
    // was last this one, or are fresh.
    void setLayout(PaneLayout layout, const Camera& camera);

    [[nodiscard]] size_t current() const { return current_; }
    // Of all but the current one, whose camera is the frame's own.
    [[nodiscard]] const Camera& camera(size_t pane) const { return cameras_[pane].camera; }
    void setCamera(size_t pane, const Camera& camera) { cameras_[pane] = {camera, true}; }
    // Its camera was never set: it is to look as startView() says.
    [[nodiscard]] bool isFresh(size_t pane) const { return !cameras_[pane].isSet; }
    void forgetCameras();
    // Gives back the camera to look from now, and keeps the one that the current pane had.
    [[nodiscard]] Camera makeCurrent(size_t pane, const Camera& camera);

    // All of one size, with a narrow line between them. What an odd number of pixels leaves over shows
    // nothing.
    [[nodiscard]] std::vector<PaneRect> rects(int width, int height) const;
    [[nodiscard]] std::optional<size_t> at(const Vec2& pixel, int width, int height) const;

    // A named view (renderer/scene/camera.h), and whether it is without perspective.
    struct StartView {
        std::string_view name;
        bool orthographic = false;
    };
    [[nodiscard]] StartView startView(size_t pane) const;

private:
    struct Eye {
        Camera camera;
        bool isSet = false;
    };
    PaneLayout layout_ = PaneLayout::one;
    size_t current_ = 0;
    std::vector<Eye> cameras_ = std::vector<Eye>(1);
    struct Arrangement {
        std::vector<Eye> cameras;
        size_t current = 0;
    };
    std::map<PaneLayout, Arrangement> before_;  // of the layouts that are not shown
};

// What a view that looks along an axis is called, such as "TOP"; "PERSPECTIVE" or "PARALLEL" for others.
[[nodiscard]] std::string_view viewTitle(const Camera& camera);

}  // namespace knotspan
