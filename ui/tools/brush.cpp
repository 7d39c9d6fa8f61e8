#include "ui/tools/brush.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "ui/tools/edit_checks.h"
#include "ui/tools/steadiness.h"

namespace knotspan {

namespace {

// A dab every so much of the radius, so that a stroke is even however fast the hand is.
constexpr double kSpacing = 0.2;
// Of a whole strength: what one of many dabs does.
constexpr double kInflatePerDab = 0.1;
constexpr double kSmoothPerDab = 0.5;

QString stepOf(BrushKind kind)
{
    switch (kind) {
    case BrushKind::grab:
        return QObject::tr("Grab");
    case BrushKind::smooth:
        return QObject::tr("Smooth");
    case BrushKind::inflate:
        return QObject::tr("Inflate");
    case BrushKind::flatten:
        break;
    }
    return QObject::tr("Flatten");
}

std::set<ObjectId> touchable(const ToolContext& context)
{
    std::set<ObjectId> objects;
    for (const auto& [id, object] : context.document.scene().objects())
        if (object->visible && !object->locked &&
            (context.selection.objects().empty() || context.selection.contains(id)))
            objects.insert(id);
    return objects;
}

Dab dabOf(const ToolContext& context, const Vec3& centre, double radius)
{
    const ToolSettings& settings = context.settings;
    Dab dab{.centre = centre, .radius = radius, .shape = settings.brush.shape, .mirror = {}};
    if (settings.drag.symmetry.kind == SymmetryKind::plane)
        dab.mirror = settings.drag.symmetry.plane;
    return dab;
}

}  // namespace

void Brush::hover(const ToolContext& context, const ToolPointer& pointer)
{
    if (over_ == pointer.position)
        return;
    context.selection.setHovered({});
    over_ = pointer.position;
    context.redraw();
}

void Brush::leave(const ToolContext& context)
{
    over_.reset();
    context.redraw();
}

ToolAnswer Brush::press(const ToolContext& context, const ToolPointer& pointer)
{
    context.document.endPreview();  // before anything is looked at: it may be what is under the pointer
    const Pick pick = context.pick(pointer.position);
    const std::set<ObjectId> objects = touchable(context);
    if (!pick.place || objects.count(pick.place->object) == 0) {
        if (pick.place)
            context.hint(QObject::tr("This object is not selected: brushes change the selected ones"));
        return ToolAnswer::pass;
    }
    stroke_.emplace();
    BrushStroke& stroke = *stroke_;
    const bool smooths = pointer.modifiers.testFlag(Qt::ShiftModifier);
    stroke.kind = smooths ? BrushKind::smooth : kind_;
    stroke.sign = pointer.modifiers.testFlag(Qt::ControlModifier) ? -1 : 1;
    stroke.start = context.document.scene();
    stroke.objects = objects;
    stroke.centre = pick.place->position;
    stroke.radius = context.settings.brush.radiusPx * context.pixelRatio *
                    context.camera.unitsPerPixel(stroke.centre, context.height);
    stroke.pressed = stroke.last = pointer.position;
    over_ = pointer.position;
    if (stroke.kind != BrushKind::grab) {
        apply(context, dabbedAt(context, stroke.centre));
        if (context.settings.keepFriends)
            context.hint(QObject::tr("Friends are kept while grabbing only: this brush may part them"));
    } else if (context.settings.keepFriends) {
        stroke.friends.emplace(stroke.start, context.settings.friends);
    }
    return ToolAnswer::keep;
}

ToolAnswer Brush::move(const ToolContext& context, const ToolPointer& pointer)
{
    over_ = pointer.position;
    context.redraw();
    BrushStroke& stroke = *stroke_;
    if (stroke.kind == BrushKind::grab) {
        if (!stroke.hasMoved &&
            glm::distance(pointer.position, stroke.pressed) < kStillPx * context.pixelRatio)
            return ToolAnswer::keep;
        stroke.hasMoved = true;
        apply(context, grabbed(context, pointer.position));
        return ToolAnswer::keep;
    }
    const double spacing = kSpacing * context.settings.brush.radiusPx * context.pixelRatio;
    if (glm::distance(pointer.position, stroke.last) < spacing)
        return ToolAnswer::keep;
    stroke.last = pointer.position;
    const Pick pick = context.pick(pointer.position);
    if (pick.place && stroke.objects.count(pick.place->object) != 0)
        apply(context, dabbedAt(context, pick.place->position));
    return ToolAnswer::keep;
}

ToolAnswer Brush::release(const ToolContext& context, const ToolPointer&)
{
    const QString refusal = stroke_->hasChanged ? QString() : stroke_->refusal;
    stroke_.reset();
    context.hint({});
    if (!refusal.isEmpty())
        context.trouble(refusal);
    context.redraw();
    return ToolAnswer::commit;
}

// From where all stood at the press, so that coming back is coming back to the bit.
Result<Edit> Brush::grabbed(const ToolContext& context, const Vec2& to)
{
    const BrushStroke& stroke = *stroke_;
    const Vec2 way = to - stroke.pressed;
    const double unit = context.camera.unitsPerPixel(stroke.centre, context.height);
    Dab dab = dabOf(context, stroke.centre, stroke.radius);
    dab.strength = 1;
    dab.by = (context.camera.right() * way.x - context.camera.upward() * way.y) * unit;
    Edit edit;
    std::vector<ObjectPull> pulls;
    for (const ObjectId id : stroke.objects) {
        const SharedObject before = stroke.start.find(id);
        if (!before)
            continue;
        const auto after = dabbed(before, BrushKind::grab, dab);
        if (!after)
            return tl::unexpected(after.error());
        if (*after != before || context.document.scene().find(id) != before)
            edit.set(id, *after);
        if (!stroke.friends || *after == before)
            continue;
        const NurbsSurface& surface = (*after)->surface;
        for (int i = 0; i < surface.countU(); ++i)
            for (int j = 0; j < surface.countV(); ++j)
                if (!(surface.controlPoint(i, j) == before->surface.controlPoint(i, j)))
                    pulls.push_back({id, {i, j}, controlPointInModel(**after, {i, j})});
    }
    if (!stroke.friends)
        return edit;
    auto followed = stroke_->friends->pull(pulls);
    if (followed)
        if (const auto free = leavesLockedAlone(context.document.scene(), *followed); !free)
            return tl::unexpected(free.error());
    return followed;
}

Result<Edit> Brush::dabbedAt(const ToolContext& context, const Vec3& centre) const
{
    const BrushStroke& stroke = *stroke_;
    Dab dab = dabOf(context, centre, stroke.radius);
    const double perDab = stroke.kind == BrushKind::inflate ? stroke.sign * kInflatePerDab : kSmoothPerDab;
    dab.strength = perDab * context.settings.brush.strength;
    return dabbed(context.document.scene(), stroke.objects, stroke.kind, dab);
}

void Brush::apply(const ToolContext& context, const Result<Edit>& edit)
{
    QString said;
    if (!edit)
        said = QString::fromStdString(edit.error().sentence());
    else if (edit->isEmpty() && !stroke_->hasChanged)
        said = QObject::tr("No control point lies under the brush: make it larger with ], or insert knots");
    if (said != stroke_->refusal)
        context.hint(said);
    stroke_->refusal = edit ? QString() : said;
    if (!edit || edit->isEmpty())
        return;
    stroke_->hasChanged = true;
    context.document.apply(*edit, stepOf(stroke_->kind), context.gesture);
}

void Brush::show(const ToolContext& context, Overlays& overlays) const
{
    if (!over_)
        return;
    constexpr int kSides = 48;
    const auto width = static_cast<float>(2 * context.pixelRatio);
    const double radius = context.settings.brush.radiusPx * context.pixelRatio;
    const auto corner = [&](int k) {
        const double angle = 2 * std::numbers::pi * k / kSides;
        return *over_ + radius * Vec2(std::cos(angle), std::sin(angle));
    };
    for (int k = 0; k < kSides; ++k)
        overlays.strokes.push_back({.from = corner(k),
                                    .to = corner(k + 1),
                                    .widthFromPx = width,
                                    .widthToPx = width,
                                    .opacity = 0.8F});
}

}  // namespace knotspan
