#include "ui/panels/tool_panel.h"

#include <QVBoxLayout>

#include "ui/panels/brush_form.h"
#include "ui/panels/drag_form.h"
#include "ui/panels/snap_form.h"

namespace knotspan {

ToolPanel::ToolPanel(Document& document, Viewport& viewport, QWidget* parent) : QScrollArea(parent)
{
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->addWidget(new DragForm(document, viewport, column));
    layout->addWidget(new SnapForm(document, viewport, column));
    layout->addWidget(new BrushForm(document, viewport, column));
    layout->addStretch();
    setWidget(column);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

}  // namespace knotspan
