// Whether curvature combs show, how many, how long.
#pragma once

#include <QGroupBox>

#include "ui/viewport/viewport.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace knotspan {

class CombsForm : public QGroupBox {
    Q_OBJECT

public:
    // Both outlive it.
    CombsForm(const Document& document, Viewport& viewport, QWidget* parent = nullptr);

private:
    void takeOver();
    void tell();
    void showStrongest();

    const Document& document_;
    Viewport& viewport_;
    QCheckBox* shown_ = nullptr;
    QSpinBox* curves_ = nullptr;
    QDoubleSpinBox* longest_ = nullptr;
    QLabel* strongest_ = nullptr;
};

}  // namespace knotspan
