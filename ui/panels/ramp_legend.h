// The ramp of colours with the numbers that its ends and its middle stand for.
#pragma once

#include <QWidget>

#include "renderer/scene/look.h"

namespace knotspan {

class RampLegend : public QWidget {
    Q_OBJECT

public:
    explicit RampLegend(QWidget* parent = nullptr);

    // `unit` stands behind the numbers; it may be empty.
    void show(const NumberRange& range, const QString& unit);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    NumberRange range_;
    QString unit_;
};

}  // namespace knotspan
