// Object > Move, turn, scale: the selected objects, by numbers.
#pragma once

#include "model/making/object_making.h"
#include "ui/making_dialog.h"

namespace knotspan {

class TransformDialog : public MakingDialog {
    Q_OBJECT

public:
    TransformDialog(Document& document, Selection& selection, QWidget* parent = nullptr);

protected:
    [[nodiscard]] Making make() const override;

private:
    [[nodiscard]] QString step(const TransformNumbers& numbers, int count) const;

    VectorBoxes move_{};
    VectorBoxes turn_{};
    VectorBoxes scale_{};
    QComboBox* about_ = nullptr;
};

}  // namespace knotspan
