// A plot in a window. Hovering a marker tells its text, a click chooses it; with the keyboard the arrows go
// from marker to marker and Enter chooses.
#pragma once

#include <optional>

#include <QWidget>

#include "ui/plots/plot.h"
#include "ui/plots/plot_layout.h"

namespace knotspan {

class PlotView : public QWidget {
    Q_OBJECT

public:
    explicit PlotView(QWidget* parent = nullptr);

    // The current marker stays the one of the same number where there is one.
    void setPlot(Plot plot);
    [[nodiscard]] const Plot& plot() const { return plot_; }
    // Where a marker is, in the widget's pixels.
    [[nodiscard]] QPointF markerPosition(size_t marker) const;
    [[nodiscard]] std::optional<size_t> currentMarker() const { return current_; }

    [[nodiscard]] QSize sizeHint() const override { return {900, 500}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {640, 360}; }

Q_SIGNALS:
    void chosen(int marker);
    // What the pointer or the keyboard is on; empty: nothing.
    void pointedAt(const QString& text);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] std::optional<size_t> markerAt(const QPointF& place) const;
    [[nodiscard]] QString textOf(std::optional<size_t> marker) const;
    void layOut();
    void setCurrent(std::optional<size_t> marker);

    Plot plot_;
    PlotLayout layout_;
    std::optional<size_t> current_;
};

}  // namespace knotspan
