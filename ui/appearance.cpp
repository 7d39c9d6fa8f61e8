#include "ui/appearance.h"

#include <QApplication>
#include <QPainter>
#include <QProxyStyle>
#include <QSettings>
#include <QStyleOption>

namespace knotspan {

namespace {

constexpr auto kKey = "appearance";
constexpr const char* kNames[] = {"system", "light", "dark"};

// The other roles follow from these.
struct Inks {
    QColor window;
    QColor base;
    QColor alternate;
    QColor button;
    QColor text;
    QColor faint;  // what is not possible
    QColor highlight;
    QColor highlighted;
    QColor link;
    QColor visited;
    QColor tip;
};

QPalette paletteOf(const Inks& inks)
{
    QPalette palette(inks.button, inks.window);  // light, dark and shadow, too
    palette.setColor(QPalette::Base, inks.base);
    palette.setColor(QPalette::AlternateBase, inks.alternate);
    palette.setColor(QPalette::ToolTipBase, inks.tip);
    palette.setColor(QPalette::Highlight, inks.highlight);
    palette.setColor(QPalette::HighlightedText, inks.highlighted);
    palette.setColor(QPalette::Link, inks.link);
    palette.setColor(QPalette::LinkVisited, inks.visited);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, inks.text);
        palette.setColor(QPalette::Disabled, role, inks.faint);
    }
    palette.setColor(QPalette::PlaceholderText, inks.faint);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, inks.alternate);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, inks.faint);
    return palette;
}

// Fusion outlines boxes in something darker than the window, which nobody sees on dark.
class DarkStyle : public QProxyStyle {
public:
    DarkStyle() : QProxyStyle("fusion") {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override
    {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element != PE_IndicatorCheckBox)
            return;
        QColor outline = option->palette.color(QPalette::WindowText);
        outline.setAlphaF(kOutline);
        painter->save();
        painter->setBrush(Qt::NoBrush);
        painter->setPen(outline);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
    }

private:
    static constexpr float kOutline = 0.45F;
};

struct Current {
    Appearance appearance = Appearance::system;
    // How the system has it: empty until it is first given up.
    QString systemStyle;
};

Current& current()
{
    static Current current;
    return current;
}

void apply(Appearance wanted)
{
    Current& now = current();
    if (wanted == now.appearance)
        return;
    if (now.systemStyle.isEmpty())
        now.systemStyle = QApplication::style()->name();
    now.appearance = wanted;
    // Other styles may draw in colours of their own.
    if (wanted == Appearance::dark)
        QApplication::setStyle(new DarkStyle);
    else
        QApplication::setStyle(wanted == Appearance::system ? now.systemStyle : QString("fusion"));
    QApplication::setPalette(wanted == Appearance::light  ? lightPalette()
                             : wanted == Appearance::dark ? darkPalette()
                                                          : QPalette());
}

}  // namespace

QPalette lightPalette()
{
    return paletteOf({.window = "#efefef",
                      .base = "#ffffff",
                      .alternate = "#f5f5f6",
                      .button = "#f2f2f2",
                      .text = "#18191c",
                      .faint = "#86888d",
                      .highlight = "#2f6fb5",
                      .highlighted = "#ffffff",
                      .link = "#1d5fa8",
                      .visited = "#6a4a9c",
                      .tip = "#fffde8"});
}

QPalette darkPalette()
{
    return paletteOf({.window = "#30333b",
                      .base = "#1e2025",
                      .alternate = "#25282e",
                      .button = "#3a3e47",
                      .text = "#e6e7ea",
                      .faint = "#82868f",
                      .highlight = "#2d6cb0",
                      .highlighted = "#ffffff",
                      .link = "#7db4f0",
                      .visited = "#b79ae6",
                      .tip = "#3a3e47"});
}

Appearance appearance()
{
    return current().appearance;
}

void setAppearance(Appearance wanted)
{
    apply(wanted);
    QSettings().setValue(kKey, kNames[static_cast<int>(wanted)]);
}

void restoreAppearance()
{
    const QString name = QSettings().value(kKey).toString();
    for (const Appearance known : {Appearance::light, Appearance::dark})
        if (name == kNames[static_cast<int>(known)])
            apply(known);
}

}  // namespace knotspan
