// What dragged control points jump to.
#pragma once

#include "ui/panels/tool_form.h"

namespace knotspan {

class SnapForm : public ToolForm {
    Q_OBJECT

public:
    SnapForm(Document& document, Viewport& viewport, QWidget* parent = nullptr);

protected:
    void show(const ToolSettings& settings) override;
    void read(ToolSettings& settings) const override;

private:
    QCheckBox* points_ = nullptr;
    QCheckBox* knotLines_ = nullptr;
    QCheckBox* surfaces_ = nullptr;
    QCheckBox* grid_ = nullptr;
    QDoubleSpinBox* step_ = nullptr;
};

}  // namespace knotspan
