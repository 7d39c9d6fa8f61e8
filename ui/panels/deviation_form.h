// How far what is measured is from its reference: what they are, the largest and the mean distance, the
// colours.
#pragma once

#include <QGroupBox>

#include "ui/tools/selection.h"
#include "ui/viewport/viewport.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace knotspan {

class NumberBox;
class RampLegend;

class DeviationForm : public QGroupBox {
    Q_OBJECT

public:
    // All outlive it.
    DeviationForm(const Document& document, const Selection& selection, Viewport& viewport,
                  QWidget* parent = nullptr);

private:
    QWidget* addSide(const char* id, const QString& title, const QString& tip, QLabel*& label,
                     std::set<ObjectId> DeviationSettings::*side);
    void makeRange();
    QLabel* addFigure(const char* id, const QString& name, const QString& tip);
    void takeOver();
    void showSides();
    void showFigures();
    void showRamp(const FrameStats& stats);
    void show(bool on);
    void tellRange();
    [[nodiscard]] std::set<ObjectId> selected() const;

    const Document& document_;
    const Selection& selection_;
    Viewport& viewport_;
    QCheckBox* shown_ = nullptr;
    QLabel* measured_ = nullptr;
    QLabel* reference_ = nullptr;
    QLabel* largest_ = nullptr;
    QLabel* mean_ = nullptr;
    QLabel* place_ = nullptr;
    QLabel* colours_ = nullptr;
    QCheckBox* automatic_ = nullptr;
    NumberBox* low_ = nullptr;
    NumberBox* high_ = nullptr;
    RampLegend* legend_ = nullptr;
    bool isShowing_ = false;
};

}  // namespace knotspan
