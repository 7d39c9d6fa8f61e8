// The brushes' circle: how large, how strong, how it fades out.
#pragma once

#include "ui/panels/tool_form.h"

namespace knotspan {

class BrushForm : public ToolForm {
    Q_OBJECT

public:
    BrushForm(Document& document, Viewport& viewport, QWidget* parent = nullptr);

protected:
    void show(const ToolSettings& settings) override;
    void read(ToolSettings& settings) const override;

private:
    QDoubleSpinBox* radius_ = nullptr;
    QDoubleSpinBox* strength_ = nullptr;
    QComboBox* shape_ = nullptr;
};

}  // namespace knotspan
