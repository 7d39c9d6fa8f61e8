// What is measured of the model: probes and what lies between them, the
// properties of what is selected, curvature combs, a section, deviation.
#pragma once

#include <QScrollArea>

#include "ui/viewport/viewport.h"

namespace knotspan {

class MeasuresPanel : public QScrollArea {
    Q_OBJECT

public:
    // All outlive it.
    MeasuresPanel(Document& document, Selection& selection, Viewport& viewport, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override { return {420, 520}; }
};

}  // namespace knotspan
