#include "model/document/object_list.h"

#include <algorithm>

#include <QColor>

namespace knotspan {

ObjectList::ObjectList(Document& document, QObject* parent) : QAbstractListModel(parent), document_(document)
{
    connect(&document, &Document::sceneChanged, this, &ObjectList::follow);
    follow();
}

int ObjectList::rowOf(ObjectId id) const
{
    const auto row = std::lower_bound(rows_.begin(), rows_.end(), id,
                                      [](const Row& entry, ObjectId wanted) { return entry.id < wanted; });
    return row != rows_.end() && row->id == id ? static_cast<int>(row - rows_.begin()) : -1;
}

int ObjectList::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QString ObjectList::nameAt(int row) const
{
    const Row& entry = rows_[static_cast<size_t>(row)];
    if (!entry.object->name.empty())
        return QString::fromStdString(entry.object->name);
    return tr("Surface %1").arg(static_cast<std::uint32_t>(entry.id));
}

QVariant ObjectList::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const SceneObject& object = *rows_[static_cast<size_t>(index.row())].object;
    const NurbsSurface& surface = object.surface;
    switch (role) {
    case Qt::DisplayRole:
        return object.locked ? tr("%1 (locked)").arg(nameAt(index.row())) : nameAt(index.row());
    case Qt::EditRole:
        return nameAt(index.row());
    case Qt::DecorationRole:
        return QColor::fromRgbF(static_cast<float>(object.colour.red),
                                static_cast<float>(object.colour.green),
                                static_cast<float>(object.colour.blue));
    case Qt::CheckStateRole:
        return static_cast<int>(object.visible ? Qt::Checked : Qt::Unchecked);
    case Qt::ToolTipRole:
        return (object.locked
                    ? tr("%1 is locked (Object > Unlock all): degree %2 by %3, %4 by %5 control points.")
                    : tr("%1: degree %2 by %3, %4 by %5 control points. The box shows or hides it."))
            .arg(nameAt(index.row()))
            .arg(surface.degreeU())
            .arg(surface.degreeV())
            .arg(surface.countU())
            .arg(surface.countV());
    default:
        return {};
    }
}

bool ObjectList::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return false;
    document_.endPreview();
    const Row row = rows_[static_cast<size_t>(index.row())];
    auto changed = std::make_shared<SceneObject>(*row.object);
    QString step;
    if (role == Qt::CheckStateRole) {
        changed->visible = value.toInt() == Qt::Checked;
        step = changed->visible ? tr("Show %1") : tr("Hide %1");
    } else if (role == Qt::EditRole) {
        changed->name = value.toString().trimmed().toStdString();
        step = tr("Rename %1");
    } else {
        return false;
    }
    if (changed->visible == row.object->visible && changed->name == row.object->name)
        return false;
    Edit edit;
    edit.set(row.id, std::move(changed));
    document_.apply(edit, step.arg(nameAt(index.row())));
    return true;
}

Qt::ItemFlags ObjectList::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    const Qt::ItemFlags always =
        Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsEditable | Qt::ItemNeverHasChildren;
    return rows_[static_cast<size_t>(index.row())].object->locked ? always : always | Qt::ItemIsSelectable;
}

// Only other ids make another list; a drag changes one row many times a second, whatever others there are.
void ObjectList::follow()
{
    const Scene& scene = document_.scene();
    const auto exchanged = scene.changedSince(shown_);
    shown_ = scene;
    if (exchanged && followExchanged(*exchanged))
        return;
    const Scene::Objects& objects = scene.objects();
    const bool sameIds = std::equal(rows_.begin(), rows_.end(), objects.begin(), objects.end(),
                                    [](const Row& row, const auto& entry) { return row.id == entry.first; });
    if (!sameIds) {
        beginResetModel();
        rows_.clear();
        for (const auto& [id, object] : objects)
            rows_.push_back({id, object});
        endResetModel();
        return;
    }
    int row = 0;
    for (const auto& [unused, object] : objects)
        show(row++, object);
}

bool ObjectList::followExchanged(const std::vector<ObjectId>& ids)
{
    for (const ObjectId id : ids)
        if ((rowOf(id) < 0) != (shown_.find(id) == nullptr))
            return false;
    for (const ObjectId id : ids)
        if (const int row = rowOf(id); row >= 0)
            show(row, shown_.find(id));
    return true;
}

void ObjectList::show(int row, const SharedObject& object)
{
    SharedObject& shown = rows_[static_cast<size_t>(row)].object;
    if (shown == object)
        return;
    shown = object;
    Q_EMIT dataChanged(index(row), index(row));
}

}  // namespace knotspan
