// Object > Surface from curves: what curves taken from the selected surfaces sweep, along a vector or round
// an axis, or a smooth surface through them.
#pragma once

#include "model/making/loft.h"
#include "ui/making_dialog.h"

namespace knotspan {

enum class CurveUse { extrude, revolve, loft };  // in the order of the dialog's list

class CurvesDialog : public MakingDialog {
    Q_OBJECT

public:
    CurvesDialog(Document& document, Selection& selection, QWidget* parent = nullptr);

protected:
    [[nodiscard]] Making make() const override;
    void offerNumbers() override;

private:
    [[nodiscard]] CurveUse use() const;
    void showWhatCounts();
    // Of each selected surface one; to loft through a single one, its knot lines.
    [[nodiscard]] Result<std::vector<NurbsCurve>> curves(const Selected& objects) const;
    [[nodiscard]] Result<std::vector<NurbsSurface>> surfaces(const std::vector<NurbsCurve>& curves) const;

    double offered_ = 0;  // the size that the boxes began with
    QComboBox* use_ = nullptr;
    QComboBox* along_ = nullptr;
    QDoubleSpinBox* at_ = nullptr;
    VectorBoxes vector_{};
    VectorBoxes point_{};
    QComboBox* axis_ = nullptr;
    QDoubleSpinBox* degrees_ = nullptr;
    QCheckBox* closed_ = nullptr;
};

}  // namespace knotspan
