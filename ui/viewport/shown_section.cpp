#include "ui/viewport/shown_section.h"

#include <QElapsedTimer>

namespace knotspan {

namespace {

constexpr std::uint32_t kColour = 0xf5793a;
constexpr float kWidthPx = 2.5F;
constexpr std::uint32_t kOutlineColour = 0xa0a4ac;
constexpr double kMargin = 0.03;     // of the model's size, around it
constexpr qint64 kMostMs = 150;      // in one picture
constexpr double kDeviation = 1e-3;  // of an object's size: what the plane must not just touch
constexpr double kTolerance = 1e-5;  // of an object's size: between the curves' points

}  // namespace

ShownSection::ShownSection(const Document& document, QObject* parent) : QObject(parent), document_(document)
{
}

void ShownSection::setSettings(const SectionSettings& settings)
{
    if (settings == settings_)
        return;
    const bool isNew = settings.shown && (!settings_.shown || settings.axis != settings_.axis);
    settings_ = settings;
    const Box box = document_.scene().bounds();
    const int axis = settings_.axis;
    const bool misses = settings_.offset <= box.low[axis] || settings_.offset >= box.high[axis];
    if (isNew && misses && !box.isEmpty())
        settings_.offset = box.centre()[axis];
    Q_EMIT changed();
}

bool ShownSection::meets(const SceneObject& object) const
{
    const Box box = object.bounds();
    return object.visible && box.low[settings_.axis] <= settings_.offset &&
           settings_.offset <= box.high[settings_.axis];
}

void ShownSection::follow(Cut& cut, const SharedObject& object) const
{
    const double size = object->bounds().diagonal();
    if (cut.object != object) {
        cut.object = object;
        cut.at.reset();
        cut.surface.reset();
        if (size > 0)
            if (auto made = SectionSurface::create(object, kDeviation * size))
                cut.surface = *std::move(made);
    }
    if (cut.at == settings_)
        return;
    cut.at = settings_;
    auto lines = std::make_shared<SpaceLines>();
    lines->colour = kColour;
    lines->widthPx = kWidthPx;
    cut.length = 0;
    cut.curves = 0;
    if (cut.surface) {
        SectionPlane plane{Vec3(0), settings_.offset};
        plane.normal[settings_.axis] = 1;
        for (const SectionCurve& curve : cut.surface->cut(plane, kTolerance * size)) {
            for (size_t k = 1; k < curve.points.size(); ++k)
                lines->lines.push_back({curve.points[k - 1], curve.points[k]});
            cut.length += curve.length();
            ++cut.curves;
        }
    }
    cut.lines = std::move(lines);
}

// A rectangle around the model shows where the plane is.
void ShownSection::outline()
{
    const Box box = document_.scene().bounds();
    if (outlinedAt_ == settings_ && outlined_.low == box.low && outlined_.high == box.high)
        return;
    outlined_ = box;
    outlinedAt_ = settings_;
    auto lines = std::make_shared<SpaceLines>();
    lines->colour = kOutlineColour;
    lines->widthPx = 1;
    const int first = (settings_.axis + 1) % 3;
    const int second = (settings_.axis + 2) % 3;
    const Vec3 margin(kMargin * box.diagonal());
    const auto corner = [&](bool far, bool up) {
        Vec3 at = box.low - margin;
        const Vec3 high = box.high + margin;
        at[settings_.axis] = settings_.offset;
        if (far)
            at[first] = high[first];
        if (up)
            at[second] = high[second];
        return at;
    };
    if (!box.isEmpty())
        lines->lines = {{corner(false, false), corner(true, false)},
                        {corner(true, false), corner(true, true)},
                        {corner(true, true), corner(false, true)},
                        {corner(false, true), corner(false, false)}};
    outline_ = std::move(lines);
}

const std::vector<SharedSpaceLines>& ShownSection::lines()
{
    lines_.clear();
    length_ = 0;
    curves_ = 0;
    complete_ = true;
    const Scene::Objects& objects = document_.scene().objects();
    std::erase_if(cuts_, [&](const auto& cut) { return objects.count(cut.first) == 0; });
    if (!settings_.shown) {
        cuts_.clear();
        return lines_;
    }
    outline();
    lines_.push_back(outline_);
    QElapsedTimer clock;
    clock.start();
    for (const auto& [id, object] : objects) {
        if (!meets(*object))
            continue;
        Cut& cut = cuts_[id];
        if (cut.object != object || cut.at != settings_) {
            complete_ = complete_ && clock.elapsed() < kMostMs;
            if (!complete_)
                continue;
            follow(cut, object);
        }
        length_ += cut.length;
        curves_ += cut.curves;
        if (!cut.lines->lines.empty())
            lines_.push_back(cut.lines);
    }
    return lines_;
}

}  // namespace knotspan
