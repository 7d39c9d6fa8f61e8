#include "ui/viewport/probe_lines.h"

#include <string>

#include <glm/geometric.hpp>

#include "ui/viewport/stroke_text.h"

namespace knotspan {

namespace {

// In the hand's pixels, where a line lies in the picture's plane.
constexpr double kNormalPx = 56;
constexpr double kDirectionPx = 30;
constexpr double kHeadPx = 11;
constexpr double kDigitPx = 14;
constexpr std::uint32_t kDark = 0x101317;

// Adds the lines of one view.
class Adding {
public:
    Adding(const PictureView& view, std::vector<Stroke>& to) : view_(view), to_(to) {}

    void add(const PlaceMeasures& at, int number)
    {
        const auto middle = pixel(at.position);
        if (!middle)
            return;
        if (at.directions) {
            across(at.position, at.directions->largest, kLargestColour);
            across(at.position, at.directions->smallest, kSmallestColour);
        }
        if (at.normal)
            arrow(at.position, *at.normal);
        const Vec2 reach(view_.pixelRatio * 3, 0);
        line(*middle - reach - reach / 3.0, *middle + reach + reach / 3.0, kDark, 8, 8);
        line(*middle - reach, *middle + reach, kHoverColour, 6, 6);
        if (number > 0)
            addStrokeText(to_, std::to_string(number), {.corner = *middle + Vec2(10, 10) * view_.pixelRatio},
                          {.height = kDigitPx * view_.pixelRatio, .width = 1.5 * view_.pixelRatio});
    }

private:
    [[nodiscard]] std::optional<Vec2> pixel(const Vec3& point) const
    {
        return view_.camera.toPixel(point, view_.width, view_.height);
    }

    void line(const Vec2& from, const Vec2& to, std::uint32_t colour, double widthFrom, double widthTo)
    {
        to_.push_back({from, to, colour, static_cast<float>(widthFrom * view_.pixelRatio),
                       static_cast<float>(widthTo * view_.pixelRatio)});
    }

    [[nodiscard]] std::optional<Vec2> endOf(const Vec3& from, const Vec3& along, double px) const
    {
        return pixel(from + along * (px * view_.pixelRatio * view_.camera.unitsPerPixel(from, view_.height)));
    }

    void across(const Vec3& place, const Vec3& along, std::uint32_t colour)
    {
        const auto from = endOf(place, along, -kDirectionPx);
        const auto to = endOf(place, along, kDirectionPx);
        if (!from || !to)
            return;
        line(*from, *to, kDark, 4.5, 4.5);
        line(*from, *to, colour, 2.5, 2.5);
    }

    void arrow(const Vec3& place, const Vec3& along)
    {
        const auto from = pixel(place);
        const auto to = endOf(place, along, kNormalPx);
        if (!from || !to)
            return;
        const double length = glm::length(*to - *from);
        const double head = std::min(kHeadPx * view_.pixelRatio, 0.5 * length);
        if (!(length > 0))
            return;
        const Vec2 neck = *to - (*to - *from) * (head / length);
        line(*from, neck, kDark, 4.5, 4.5);
        line(*from, neck, kNormalColour, 2.5, 2.5);
        line(neck, *to, kNormalColour, 10, 0);
    }

    const PictureView& view_;
    std::vector<Stroke>& to_;
};

}  // namespace

std::vector<Stroke> probeLines(const Scene& scene, const Probes& probes, const PictureView& view)
{
    std::vector<Stroke> lines;
    Adding adding(view, lines);
    const auto add = [&](const Probe& probe) {
        const SharedObject object = scene.find(probe.object);
        if (object && object->visible)
            adding.add(measuresAt(object->surface, object->transform, probe.u, probe.v), probe.number);
    };
    if (probes.live())
        add(*probes.live());
    for (const Probe& pin : probes.pins())
        add(pin);
    return lines;
}

}  // namespace knotspan
