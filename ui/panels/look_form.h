// What the chosen shading may be told: stripes, material, range of curvature, draft. Nothing where it is told
// nothing.
#pragma once

#include "ui/viewport/viewport.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;
class QStackedWidget;

namespace knotspan {

class NumberBox;
class RampLegend;

class LookForm : public QWidget {
    Q_OBJECT

public:
    explicit LookForm(Viewport& viewport, QWidget* parent = nullptr);

private:
    QFormLayout* addPage();
    void makeStripes();
    void makeMatcap();
    void makeCurvature();
    void makeDraft();
    void makeChecker();
    void showFrame();
    void showRamp(const FrameStats& stats);
    void tell();

    Viewport& viewport_;
    QStackedWidget* pages_ = nullptr;
    QSpinBox* stripes_ = nullptr;
    QSpinBox* angle_ = nullptr;
    QComboBox* matcap_ = nullptr;
    QComboBox* curvature_ = nullptr;
    QCheckBox* automatic_ = nullptr;
    NumberBox* low_ = nullptr;
    NumberBox* high_ = nullptr;
    QComboBox* pull_ = nullptr;
    QDoubleSpinBox* draft_ = nullptr;
    QComboBox* checker_ = nullptr;
    QSpinBox* squares_ = nullptr;
    NumberBox* squareLength_ = nullptr;
    RampLegend* legend_ = nullptr;
    bool isShowing_ = false;
};

}  // namespace knotspan
