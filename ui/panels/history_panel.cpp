#include "ui/panels/history_panel.h"

#include <QScopedValueRollback>

namespace knotspan {

HistoryPanel::HistoryPanel(Document& document, QWidget* parent) : QListWidget(parent), document_(document)
{
    setObjectName("history");
    setAccessibleName(tr("History of the model"));
    setToolTip(tr("Click a step to see the model as it was after it"));
    const QUndoStack* const stack = &document_.history();
    connect(stack, &QUndoStack::indexChanged, this, &HistoryPanel::takeOver);
    connect(&document_, &Document::documentReplaced, this, &HistoryPanel::takeOver);
    connect(this, &QListWidget::currentRowChanged, this, &HistoryPanel::go);
    takeOver();
}

void HistoryPanel::takeOver()
{
    const QScopedValueRollback quiet(isTaking_, true);
    const QUndoStack& stack = document_.history();
    const int rows = stack.count() + 1;
    while (count() > rows)
        delete takeItem(count() - 1);
    while (count() < rows)
        addItem(QString());
    item(0)->setText(tr("%1 as it was opened").arg(document_.title()));
    for (int step = 0; step < stack.count(); ++step) {
        QListWidgetItem* const line = item(step + 1);
        line->setText(stack.text(step));
        QFont font = line->font();
        font.setItalic(step >= stack.index());  // taken back, and can be done again
        line->setFont(font);
    }
    setCurrentRow(stack.index());
    scrollToItem(item(stack.index()));
}

void HistoryPanel::go(int row)
{
    if (isTaking_ || row < 0)
        return;
    document_.undoStack().setIndex(std::min(row, document_.history().count()));
}

}  // namespace knotspan
