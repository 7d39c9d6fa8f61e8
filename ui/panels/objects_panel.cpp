#include "ui/panels/objects_panel.h"

#include <QItemSelectionModel>
#include <QScopedValueRollback>

namespace knotspan {

ObjectsPanel::ObjectsPanel(Document& document, Selection& selection, QWidget* parent)
    : QListView(parent),
      selection_(selection),
      list_(new ObjectList(document, this))
{
    setObjectName("objects");
    setAccessibleName(tr("Objects of the model"));
    // Not in the status line: under the menu Edit it would replace what a step has to say.
    setToolTip(tr("Click to select, with Ctrl several; tick to show, double-click to rename"));
    setModel(list_);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setUniformItemSizes(true);
    setFrameShape(QFrame::NoFrame);
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &ObjectsPanel::choose);
    connect(&selection_, &Selection::changed, this, &ObjectsPanel::showChosen);
    connect(list_, &QAbstractItemModel::modelReset, this, &ObjectsPanel::showChosen);
}

void ObjectsPanel::choose()
{
    if (following_)
        return;
    std::set<ObjectId> objects;
    std::set<ObjectId> meshes;
    for (const QModelIndex& index : selectionModel()->selectedIndexes())
        (list_->isMesh(index.row()) ? meshes : objects).insert(list_->idAt(index.row()));
    selection_.setObjects(std::move(objects), std::move(meshes));
}

void ObjectsPanel::showChosen()
{
    const QScopedValueRollback<bool> guard(following_, true);
    QItemSelection rows;
    for (const std::set<ObjectId>* ids : {&selection_.objects(), &selection_.meshes()})
        for (const ObjectId id : *ids)
            if (const int row = list_->rowOf(id); row >= 0)
                rows.select(list_->index(row), list_->index(row));
    selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    if (rows.size() == 1 && !hasFocus())
        scrollTo(rows.first().topLeft());
}

}  // namespace knotspan
