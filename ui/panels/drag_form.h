// How drags of control points go: along which axis, who follows by falloff, who as a mirror image, and
// whether friends stay smooth.
#pragma once

#include "ui/panels/tool_form.h"

namespace knotspan {

class DragForm : public ToolForm {
    Q_OBJECT

public:
    DragForm(Document& document, Viewport& viewport, QWidget* parent = nullptr);

protected:
    void show(const ToolSettings& settings) override;
    void read(ToolSettings& settings) const override;

private:
    QComboBox* axis_ = nullptr;
    QCheckBox* eachItsOwn_ = nullptr;
    QComboBox* gizmo_ = nullptr;
    QDoubleSpinBox* radius_ = nullptr;
    QComboBox* shape_ = nullptr;
    QComboBox* distance_ = nullptr;
    QComboBox* symmetry_ = nullptr;
    QDoubleSpinBox* place_ = nullptr;
    QCheckBox* keepFriends_ = nullptr;
};

}  // namespace knotspan
