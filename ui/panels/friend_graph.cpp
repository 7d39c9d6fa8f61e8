#include "ui/panels/friend_graph.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QPainterPath>

namespace knotspan {

namespace {

constexpr QRgb kCurve = 0xff56b4e9;
constexpr QRgb kOver = 0xffd55e00;  // the tolerance, and what is over it

}  // namespace

FriendGraph::FriendGraph(QWidget* parent) : QWidget(parent)
{
    setObjectName("friend-graph");
    setAccessibleName(tr("Along the selected edge"));
    setToolTip(
        tr("How the selected edge fares from its start to its end. The dashed line is the tolerance, the "
           "dotted one marks the worst place."));
}

void FriendGraph::setContent(std::optional<Content> content, const QString& instead)
{
    content_ = std::move(content);
    instead_ = instead;
    const QString unit = content_ && content_->quantity == Quantity::angle ? tr("°") : QString();
    setAccessibleDescription(content_ ? tr("%1: sampled, at most %2%3 there; the tolerance is %4%3")
                                            .arg(content_->title)
                                            .arg(largest(), 0, 'g', 4)
                                            .arg(unit)
                                            .arg(content_->tolerance)
                                      : instead_);
    update();
}

std::optional<double> FriendGraph::valueOf(const EdgeSample& sample) const
{
    return content_->quantity == Quantity::angle ? sample.angleDeg : std::optional(sample.gap);
}

double FriendGraph::largest() const
{
    double most = 0;
    if (content_)
        for (const EdgeSample& sample : content_->samples)
            most = std::max(most, valueOf(sample).value_or(0));
    return most;
}

void FriendGraph::paintCurve(QPainter& painter, const QRectF& area, double top) const
{
    const double from = content_->samples.front().parameter;
    const double length = content_->samples.back().parameter - from;
    const auto x = [&](double parameter) { return area.left() + (parameter - from) / length * area.width(); };
    const auto y = [&](double value) { return area.bottom() - value / top * area.height(); };
    QPainterPath path;
    bool drawing = false;
    for (const EdgeSample& sample : content_->samples) {
        const auto value = valueOf(sample);
        if (!value) {
            drawing = false;
            continue;
        }
        const QPointF at(x(sample.parameter), y(*value));
        if (drawing)
            path.lineTo(at);
        else
            path.moveTo(at);
        drawing = true;
    }
    painter.setPen(QPen(palette().mid().color(), 1, Qt::DotLine));
    painter.drawLine(QPointF(x(content_->worst), area.top()), QPointF(x(content_->worst), area.bottom()));
    painter.setPen(QPen(QColor(kOver), 1, Qt::DashLine));
    painter.drawLine(QPointF(area.left(), y(content_->tolerance)),
                     QPointF(area.right(), y(content_->tolerance)));
    painter.setPen(QPen(QColor(largest() > content_->tolerance ? kOver : kCurve), 2));
    painter.drawPath(path);
}

void FriendGraph::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    painter.setPen(palette().text().color());
    if (!content_) {
        painter.drawText(rect().adjusted(8, 4, -8, -4), Qt::AlignCenter | Qt::TextWordWrap, instead_);
        return;
    }
    const int line = painter.fontMetrics().height();
    const bool isAngle = content_->quantity == Quantity::angle;
    const double room = 1.2 * std::max(largest(), content_->tolerance);
    const double top = isAngle ? std::min(room, 180.0) : room;
    const QString unit = isAngle ? tr("°") : QString();
    const QString high = QString::number(top, 'g', std::max(3, 1 + static_cast<int>(std::log10(top)))) + unit;
    const int left = painter.fontMetrics().horizontalAdvance(high) + 12;
    const QRectF area(left, line + 8, width() - left - 8, height() - 2 * line - 14);
    painter.drawText(QRectF(8, 2, width() - 16, line),
                     painter.fontMetrics().elidedText(content_->title, Qt::ElideMiddle, width() - 16));
    painter.drawText(QRectF(0, area.top() - line / 2.0, left - 4, line), Qt::AlignRight, high);
    painter.drawText(QRectF(0, area.bottom() - line / 2.0, left - 4, line), Qt::AlignRight, "0");
    painter.drawText(QRectF(area.left(), area.bottom() + 3, area.width(), line), Qt::AlignLeft, tr("start"));
    painter.drawText(QRectF(area.left(), area.bottom() + 3, area.width(), line), Qt::AlignRight, tr("end"));
    painter.setPen(palette().mid().color());
    painter.drawLine(area.topLeft(), area.bottomLeft());
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    if (area.height() > 0 && content_->samples.size() > 1)
        paintCurve(painter, area, top);
}

}  // namespace knotspan
