// How drags of control points go: along which axis, who follows by falloff, who as a mirror image, and
// whether friends stay smooth.
#pragma once

#include <QWidget>

#include "ui/viewport/viewport.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace knotspan {

class ToolPanel : public QWidget {
    Q_OBJECT

public:
    // Document and viewport outlive it.
    ToolPanel(Document& document, Viewport& viewport, QWidget* parent = nullptr);

private:
    void makeLayout();
    void takeOver();  // from the viewport
    void tell();      // the viewport

    Document& document_;
    Viewport& viewport_;
    bool isTelling_ = false;
    QComboBox* axis_ = nullptr;
    QCheckBox* eachItsOwn_ = nullptr;
    QDoubleSpinBox* radius_ = nullptr;
    QComboBox* shape_ = nullptr;
    QComboBox* distance_ = nullptr;
    QComboBox* symmetry_ = nullptr;
    QDoubleSpinBox* place_ = nullptr;
    QCheckBox* keepFriends_ = nullptr;
};

}  // namespace knotspan
