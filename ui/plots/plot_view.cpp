#include "ui/plots/plot_view.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

namespace knotspan {

namespace {

QPointF at(const PlotPoint& point)
{
    return {point.x, point.y};
}

QColor colourOf(const std::string& name)
{
    return {QString::fromStdString(name)};
}

void paintText(QPainter& painter, const PlotText& written)
{
    QFont font = painter.font();
    font.setPixelSize(written.size);
    font.setBold(written.bold);
    painter.save();
    painter.setFont(font);
    painter.setPen("#222222");
    painter.translate(at(written.at));
    if (written.upwards)
        painter.rotate(-90);
    const QString text = QString::fromStdString(written.text);
    const double width = painter.fontMetrics().horizontalAdvance(text);
    const double part = written.anchor == PlotAnchor::start    ? 0
                        : written.anchor == PlotAnchor::middle ? 0.5
                                                               : 1;
    painter.drawText(QPointF(-part * width, 0), text);
    painter.restore();
}

void paintSymbol(QPainter& painter, const PlotSymbol& symbol)
{
    const QColor colour = colourOf(symbol.look.colour);
    if (symbol.look.ringed) {
        painter.setPen("#444444");
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at(symbol.at), kRingRadius, kRingRadius);
    }
    painter.setPen(QPen(colour, 2));
    QColor inside = symbol.look.filled ? colour : QColor("#ffffff");
    inside.setAlphaF(symbol.look.filled ? 0.85F : 0.4F);
    painter.setBrush(inside);
    if (symbol.look.shape == MarkerShape::circle)
        painter.drawEllipse(at(symbol.at), kMarkerRadius, kMarkerRadius);
    else
        painter.drawRect(QRectF(symbol.at.x - kMarkerRadius, symbol.at.y - kMarkerRadius, 2 * kMarkerRadius,
                                2 * kMarkerRadius));
}

void paintCurve(QPainter& painter, const Curve& look, const std::vector<PlotPoint>& points)
{
    QPainterPath path(at(points.front()));
    for (const PlotPoint& point : points)
        path.lineTo(at(point));
    painter.setPen(
        QPen(colourOf(look.colour), look.strong ? 4 : 2, look.dashed ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

}  // namespace

PlotView::PlotView(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    layOut();
}

void PlotView::setPlot(Plot plot)
{
    plot_ = std::move(plot);
    if (current_ && *current_ >= plot_.markers.size())
        current_.reset();
    layOut();
}

void PlotView::layOut()
{
    layout_ = layoutOf(plot_, width(), height());
    update();
}

QPointF PlotView::markerPosition(size_t marker) const
{
    return at(layout_.markers.at(marker));
}

std::optional<size_t> PlotView::markerAt(const QPointF& place) const
{
    std::optional<size_t> nearest;
    double least = kRingRadius + 2;
    for (size_t k = 0; k < layout_.markers.size(); ++k) {
        const QPointF apart = place - at(layout_.markers[k]);
        const double distance = std::hypot(apart.x(), apart.y());
        if (distance <= least) {
            least = distance;
            nearest = k;
        }
    }
    return nearest;
}

QString PlotView::textOf(std::optional<size_t> marker) const
{
    return marker ? QString::fromStdString(plot_.markers[*marker].text) : QString();
}

void PlotView::setCurrent(std::optional<size_t> marker)
{
    if (current_ == marker)
        return;
    current_ = marker;
    setAccessibleDescription(textOf(current_));
    Q_EMIT pointedAt(textOf(current_));
    update();
}

bool PlotView::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const auto marker = markerAt(help->pos()))
        QToolTip::showText(help->globalPos(), textOf(marker), this);
    else
        QToolTip::hideText();
    return true;
}

void PlotView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), Qt::white);
    for (const PlotLine& line : layout_.lines) {
        painter.setPen(colourOf(line.colour));
        painter.drawLine(at(line.from), at(line.to));
    }
    for (const PlotText& text : layout_.texts)
        paintText(painter, text);
    for (size_t k = 0; k < layout_.curves.size(); ++k)
        paintCurve(painter, plot_.curves[k], layout_.curves[k]);
    for (size_t k = 0; k < layout_.markers.size(); ++k)
        paintSymbol(painter, {layout_.markers[k], plot_.markers[k].look});
    for (const PlotSymbol& entry : layout_.legend)
        paintSymbol(painter, entry);
    if (!current_)
        return;
    painter.setPen(QPen(palette().highlight().color(), 3));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at(layout_.markers[*current_]), kRingRadius + 3, kRingRadius + 3);
}

void PlotView::resizeEvent(QResizeEvent*)
{
    layOut();
}

void PlotView::mouseMoveEvent(QMouseEvent* event)
{
    setCurrent(markerAt(event->position()));
    setCursor(current_ ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void PlotView::leaveEvent(QEvent*)
{
    if (!hasFocus())
        setCurrent({});
}

void PlotView::mousePressEvent(QMouseEvent* event)
{
    setCurrent(markerAt(event->position()));
    if (current_ && event->button() == Qt::LeftButton)
        Q_EMIT chosen(static_cast<int>(*current_));
}

void PlotView::keyPressEvent(QKeyEvent* event)
{
    const size_t count = plot_.markers.size();
    if (count == 0)
        return QWidget::keyPressEvent(event);
    switch (event->key()) {
    case Qt::Key_Right:
    case Qt::Key_Down:
        return setCurrent(current_ ? (*current_ + 1) % count : 0);
    case Qt::Key_Left:
    case Qt::Key_Up:
        return setCurrent(current_ ? (*current_ + count - 1) % count : count - 1);
    case Qt::Key_Home:
        return setCurrent(0);
    case Qt::Key_End:
        return setCurrent(count - 1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
        if (current_)
            Q_EMIT chosen(static_cast<int>(*current_));
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

}  // namespace knotspan
