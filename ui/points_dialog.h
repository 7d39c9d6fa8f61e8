// Points > By numbers: the selected control points moved by or to coordinates, or given a weight. Falloff and
// symmetry follow as when they are dragged.
#pragma once

#include <functional>

#include "model/sculpting/point_drag.h"
#include "ui/making_dialog.h"

namespace knotspan {

class PointsDialog : public MakingDialog {
    Q_OBJECT

public:
    // `drag`: how drags go at the moment.
    PointsDialog(Document& document, Selection& selection, std::function<DragSettings()> drag,
                 QWidget* parent = nullptr);

protected:
    [[nodiscard]] Making make() const override;
    void offerNumbers() override;

private:
    [[nodiscard]] Making moving(const PointSelection& chosen) const;
    [[nodiscard]] Making weighing(const PointSelection& chosen) const;
    void showWhatCounts();

    Selection& chosen_;
    std::function<DragSettings()> drag_;
    PointSelection seen_;
    QComboBox* what_ = nullptr;
    VectorBoxes place_{};
    Vec3 offered_{0};  // as the boxes have it
    QDoubleSpinBox* weight_ = nullptr;
};

}  // namespace knotspan
