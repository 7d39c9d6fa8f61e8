// What the tools are told: how drags go, what they jump to, how brushes are.
#pragma once

#include <QScrollArea>

#include "ui/viewport/viewport.h"

namespace knotspan {

class ToolPanel : public QScrollArea {
    Q_OBJECT

public:
    // Document and viewport outlive it.
    ToolPanel(Document& document, Viewport& viewport, QWidget* parent = nullptr);
};

}  // namespace knotspan
