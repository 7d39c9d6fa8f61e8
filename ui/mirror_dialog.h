// Object > Mirror: the selected objects, or copies of them, in a plane across an axis of the model.
#pragma once

#include "ui/making_dialog.h"

namespace knotspan {

class MirrorDialog : public MakingDialog {
    Q_OBJECT

public:
    MirrorDialog(Document& document, Selection& selection, QWidget* parent = nullptr);

protected:
    [[nodiscard]] Making make() const override;

private:
    QComboBox* plane_ = nullptr;
    QComboBox* through_ = nullptr;
    QCheckBox* copy_ = nullptr;
};

}  // namespace knotspan
