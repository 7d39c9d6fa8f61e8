// How the model is drawn: path, culling, shading, tolerance, sampling and evaluator, filled from the
// renderer's lists.
#pragma once

#include <utility>
#include <vector>

#include <QWidget>

#include "ui/viewport/viewport.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSlider;
class QSpinBox;
class QToolButton;

namespace knotspan {

class RenderingPanel : public QWidget {
    Q_OBJECT

public:
    explicit RenderingPanel(Viewport& viewport, QWidget* parent = nullptr);

private:
    QWidget* makePathPicker();
    QWidget* makeShadingPicker();
    QWidget* makeSamplingPicker();
    QWidget* makeEvaluatorPicker();
    QWidget* makeCulling();
    QWidget* makeTolerance();
    void fillPaths();
    void showFrame();
    void showSampling(const Frame& frame);
    void showWhetherToleranceCounts(PathId path);

    template <class Change>
    void change(Change&& change)
    {
        Frame frame = viewport_.frame();
        change(frame);
        viewport_.setFrame(frame);
    }

    Viewport& viewport_;
    QComboBox* path_ = nullptr;
    QComboBox* shading_ = nullptr;
    QComboBox* sampling_ = nullptr;
    QSpinBox* cells_ = nullptr;  // of the rule `fixed`
    QComboBox* evaluator_ = nullptr;
    std::vector<QCheckBox*> culling_;
    QCheckBox* countWrong_ = nullptr;
    QSlider* slider_ = nullptr;
    QDoubleSpinBox* tolerance_ = nullptr;
    std::vector<QToolButton*> presets_;
    std::vector<std::pair<QWidget*, QString>> toleranceTips_;  // what sets the tolerance, while it counts
};

}  // namespace knotspan
