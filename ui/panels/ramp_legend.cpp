#include "ui/panels/ramp_legend.h"

#include <QLocale>
#include <QPainter>

namespace knotspan {

namespace {

QString shortNumber(double number)
{
    return QLocale().toString(number, 'g', 3);
}

QColor colourAt(double place)
{
    const Vec3 colour = colourOnRamp(place);
    return QColor::fromRgbF(static_cast<float>(colour.x), static_cast<float>(colour.y),
                            static_cast<float>(colour.z));
}

}  // namespace

RampLegend::RampLegend(QWidget* parent) : QWidget(parent)
{
    setObjectName("ramp-legend");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void RampLegend::show(const NumberRange& range, const QString& unit)
{
    range_ = range;
    unit_ = unit;
    const QString text =
        tr("Blue is %1 or less, pale %2, orange %3 or more")
            .arg(shortNumber(range.low) + unit, shortNumber(0.5 * (range.low + range.high)) + unit,
                 shortNumber(range.high) + unit);
    setToolTip(text);
    setAccessibleName(tr("Colours"));
    setAccessibleDescription(text);
    update();
}

QSize RampLegend::sizeHint() const
{
    return {160, 2 * fontMetrics().height() + 6};
}

QSize RampLegend::minimumSizeHint() const
{
    return {100, sizeHint().height()};
}

void RampLegend::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const int high = fontMetrics().height();
    for (int x = 0; x < width(); ++x)
        painter.fillRect(x, 0, 1, high, colourAt((x + 0.5) / width()));
    const QRect below(0, high + 2, width(), high + 2);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(below, Qt::AlignLeft, shortNumber(range_.low));
    painter.drawText(below, Qt::AlignHCenter, shortNumber(0.5 * (range_.low + range_.high)) + unit_);
    painter.drawText(below, Qt::AlignRight, shortNumber(range_.high));
}

}  // namespace knotspan
