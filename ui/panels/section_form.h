// A plane through the model: whether its curves show, where it is, how long they are.
#pragma once

#include <QGroupBox>

#include "ui/viewport/viewport.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace knotspan {

class SectionForm : public QGroupBox {
    Q_OBJECT

public:
    // Both outlive it.
    SectionForm(const Document& document, Viewport& viewport, QWidget* parent = nullptr);

private:
    void takeOver();
    void tell();
    void slide(int position);
    void showLength();
    // The model's extent along the plane's axis.
    [[nodiscard]] std::pair<double, double> extent() const;

    const Document& document_;
    Viewport& viewport_;
    QCheckBox* shown_ = nullptr;
    QComboBox* axis_ = nullptr;
    QDoubleSpinBox* offset_ = nullptr;
    QSlider* slider_ = nullptr;
    QLabel* length_ = nullptr;
};

}  // namespace knotspan
