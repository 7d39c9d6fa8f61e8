#include "ui/viewport/navigation_presets.h"

#include <QCoreApplication>
#include <QStringList>

namespace knotspan {

namespace {

#define TEXT(text) QT_TRANSLATE_NOOP("knotspan::Actions", text)

QString tr(const char* text)
{
    return QCoreApplication::translate("knotspan::NavigationPresets", text);
}

QString gestureOf(const NavigationGrip& grip)
{
    const QString keys = grip.key == Qt::ShiftModifier     ? tr("Shift + ")
                         : grip.key == Qt::ControlModifier ? tr("Ctrl + ")
                         : grip.key == Qt::AltModifier     ? tr("Alt + ")
                                                           : QString();
    const QString drag = grip.button == Qt::LeftButton     ? tr("left drag")
                         : grip.button == Qt::MiddleButton ? tr("middle drag")
                                                           : tr("right drag");
    return keys + drag;
}

}  // namespace

const std::vector<NavigationPreset>& navigationPresets()
{
    constexpr auto kLeft = Qt::LeftButton;
    constexpr auto kMiddle = Qt::MiddleButton;
    constexpr auto kRight = Qt::RightButton;
    static const std::vector<NavigationPreset> kPresets = {
        {"plain",
         TEXT("&Plain"),
         TEXT("Turn the view by dragging beside the model or with the middle button, pan with the right one"),
         {{kRight, Qt::NoModifier, ViewTurn::pan},
          {kMiddle, Qt::ShiftModifier, ViewTurn::pan},
          {kMiddle, Qt::ControlModifier, ViewTurn::zoom},
          {kMiddle, Qt::NoModifier, ViewTurn::orbit},
          {kLeft, Qt::AltModifier, ViewTurn::orbit}},
         true},
        {"rhino",
         TEXT("Like &Rhino"),
         TEXT("Turn the view with the right button, pan with Shift, zoom with Ctrl; left drags draw a box"),
         {{kRight, Qt::ShiftModifier, ViewTurn::pan},
          {kRight, Qt::ControlModifier, ViewTurn::zoom},
          {kRight, Qt::NoModifier, ViewTurn::orbit}},
         false},
        {"blender",
         TEXT("Like &Blender"),
         TEXT("Turn the view with the middle button, pan with Shift, zoom with Ctrl; left drags draw a box"),
         {{kMiddle, Qt::ShiftModifier, ViewTurn::pan},
          {kMiddle, Qt::ControlModifier, ViewTurn::zoom},
          {kMiddle, Qt::NoModifier, ViewTurn::orbit}},
         false},
        {"maya",
         TEXT("Like &Maya"),
         TEXT("With Alt: turn the view with the left button, pan with the middle one, zoom with the right "
              "one"),
         {{kLeft, Qt::AltModifier, ViewTurn::orbit},
          {kMiddle, Qt::AltModifier, ViewTurn::pan},
          {kRight, Qt::AltModifier, ViewTurn::zoom}},
         false},
    };
    return kPresets;
}

#undef TEXT

const NavigationPreset& findNavigation(const QString& name)
{
    for (const NavigationPreset& preset : navigationPresets())
        if (name == preset.name)
            return preset;
    return navigationPresets().front();
}

std::optional<ViewTurn> turnBy(const NavigationPreset& preset, Qt::MouseButton button,
                               Qt::KeyboardModifiers keys)
{
    for (const NavigationGrip& grip : preset.grips)
        if (grip.button == button && (grip.key == Qt::NoModifier || keys.testFlag(grip.key)))
            return grip.turn;
    return std::nullopt;
}

QString gesturesFor(const NavigationPreset& preset, ViewTurn turn)
{
    QStringList gestures;
    for (const NavigationGrip& grip : preset.grips)
        if (grip.turn == turn)
            gestures << gestureOf(grip);
    QString text = gestures.join(", ");
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text;
}

}  // namespace knotspan
