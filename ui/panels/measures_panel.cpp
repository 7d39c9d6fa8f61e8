#include "ui/panels/measures_panel.h"

#include <QVBoxLayout>

#include "ui/panels/combs_form.h"
#include "ui/panels/deviation_form.h"
#include "ui/panels/probe_view.h"
#include "ui/panels/properties_view.h"
#include "ui/panels/section_form.h"

namespace knotspan {

MeasuresPanel::MeasuresPanel(Document& document, Selection& selection, Viewport& viewport, QWidget* parent)
    : QScrollArea(parent)
{
    setObjectName("measures-panel");
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->addWidget(new ProbeView(document, viewport.probes(), column), 1);
    layout->addWidget(new PropertiesView(document, selection, column));
    layout->addWidget(new CombsForm(document, viewport, column));
    layout->addWidget(new SectionForm(document, viewport, column));
    layout->addWidget(new DeviationForm(document, selection, viewport, column));
    setWidget(column);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

}  // namespace knotspan
