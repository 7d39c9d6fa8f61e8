// Points > By numbers: the selected control points moved by or to coordinates, or given a weight. Falloff,
// symmetry and friends follow as when they are dragged.
#pragma once

#include <functional>

#include "ui/making_dialog.h"
#include "ui/tools/tool.h"

namespace knotspan {

class PointsDialog : public MakingDialog {
    Q_OBJECT

public:
    // `settings`: what a drag would follow at the moment.
    PointsDialog(Document& document, Selection& selection, std::function<ToolSettings()> settings,
                 QWidget* parent = nullptr);

protected:
    [[nodiscard]] Making make() const override;
    void offerNumbers() override;

private:
    [[nodiscard]] Making moving(const PointSelection& chosen) const;
    [[nodiscard]] Making weighing(const PointSelection& chosen) const;
    void showWhatCounts();

    Selection& chosen_;
    std::function<ToolSettings()> settings_;
    PointSelection seen_;
    QComboBox* what_ = nullptr;
    VectorBoxes place_{};
    Vec3 offered_{0};  // as the boxes have it
    QDoubleSpinBox* weight_ = nullptr;
};

}  // namespace knotspan
