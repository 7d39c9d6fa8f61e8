// Object > Add: a plane, cylinder, cone, sphere or torus, from numbers, shown before Apply makes it one step.
#pragma once

#include "model/making/shapes.h"
#include "ui/making_dialog.h"

namespace knotspan {

enum class ShapeKind { plane, cylinder, cone, sphere, torus };  // in the order of the dialog's list

class ShapeDialog : public MakingDialog {
    Q_OBJECT

public:
    ShapeDialog(Document& document, Selection& selection, QWidget* parent = nullptr);

protected:
    [[nodiscard]] Making make() const override;
    void offerNumbers() override;

private:
    [[nodiscard]] ShapeKind kind() const;
    [[nodiscard]] Placement placement() const;
    [[nodiscard]] Result<NurbsSurface> surface() const;
    void showWhatCounts();

    double offered_ = 0;  // the size that the boxes began with
    QComboBox* shape_ = nullptr;
    QDoubleSpinBox* sizeU_ = nullptr;
    QDoubleSpinBox* sizeV_ = nullptr;
    QDoubleSpinBox* radius_ = nullptr;
    QDoubleSpinBox* radiusAbove_ = nullptr;
    QDoubleSpinBox* tube_ = nullptr;
    QDoubleSpinBox* height_ = nullptr;
    VectorBoxes centre_{};
    QComboBox* axis_ = nullptr;
};

}  // namespace knotspan
