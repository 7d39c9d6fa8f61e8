// Gap or angle along one friend edge, with the tolerance as a line and the worst place marked.
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "model/friends/edge_profile.h"

namespace knotspan {

class FriendGraph : public QWidget {
    Q_OBJECT

public:
    enum class Quantity { angle, gap };

    explicit FriendGraph(QWidget* parent = nullptr);

    struct Content {
        Quantity quantity = Quantity::angle;
        std::vector<EdgeSample> samples;
        double tolerance = 0;
        double worst = 0;  // a's parameter
        QString title;
    };
    // None: a sentence in its place.
    void setContent(std::optional<Content> content, const QString& instead);
    [[nodiscard]] const std::optional<Content>& content() const { return content_; }
    // The largest value of the curve; 0 where there is none.
    [[nodiscard]] double largest() const;

    [[nodiscard]] QSize sizeHint() const override { return {320, 150}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 90}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] std::optional<double> valueOf(const EdgeSample& sample) const;
    void paintCurve(QPainter& painter, const QRectF& area, double top) const;

    std::optional<Content> content_;
    QString instead_;
};

}  // namespace knotspan
