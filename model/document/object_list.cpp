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
    const auto meshes = rows_.begin() + static_cast<std::ptrdiff_t>(meshesFrom_);
    for (const auto& [from, to] : {std::pair(rows_.begin(), meshes), std::pair(meshes, rows_.end())}) {
        const auto row = std::lower_bound(
            from, to, id, [](const Row& entry, ObjectId wanted) { return entry.id < wanted; });
        if (row != to && row->id == id)
            return static_cast<int>(row - rows_.begin());
    }
    return -1;
}

int ObjectList::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QString ObjectList::nameAt(int row) const
{
    const Row& entry = rows_[static_cast<size_t>(row)];
    const std::string& name = entry.mesh ? entry.mesh->name : entry.object->name;
    if (!name.empty())
        return QString::fromStdString(name);
    return (entry.mesh ? tr("Mesh %1") : tr("Surface %1")).arg(static_cast<std::uint32_t>(entry.id));
}

QString ObjectList::tipAt(int row) const
{
    const Row& entry = rows_[static_cast<size_t>(row)];
    if (entry.mesh)
        return tr("%1: a mesh of %2 triangles, to be looked at and compared with. The box shows or hides it.")
            .arg(nameAt(row))
            .arg(entry.mesh->mesh->triangles.size());
    const NurbsSurface& surface = entry.object->surface;
    return (entry.object->locked
                ? tr("%1 is locked (Object > Unlock all): degree %2 by %3, %4 by %5 control points.")
                : tr("%1: degree %2 by %3, %4 by %5 control points. The box shows or hides it."))
        .arg(nameAt(row))
        .arg(surface.degreeU())
        .arg(surface.degreeV())
        .arg(surface.countU())
        .arg(surface.countV());
}

QVariant ObjectList::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row& row = rows_[static_cast<size_t>(index.row())];
    const Colour& colour = row.mesh ? row.mesh->colour : row.object->colour;
    switch (role) {
    case Qt::DisplayRole:
        if (row.mesh)
            return tr("%1 (mesh)").arg(nameAt(index.row()));
        return row.object->locked ? tr("%1 (locked)").arg(nameAt(index.row())) : nameAt(index.row());
    case Qt::EditRole:
        return nameAt(index.row());
    case Qt::DecorationRole:
        return QColor::fromRgbF(static_cast<float>(colour.red), static_cast<float>(colour.green),
                                static_cast<float>(colour.blue));
    case Qt::CheckStateRole:
        return static_cast<int>((row.mesh ? row.mesh->visible : row.object->visible) ? Qt::Checked
                                                                                     : Qt::Unchecked);
    case Qt::ToolTipRole:
        return tipAt(index.row());
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
    const QString name = nameAt(index.row());
    return row.mesh ? changeOne(*row.mesh, value, role, name,
                                [&](Edit& edit, auto changed) { edit.setMesh(row.id, std::move(changed)); })
                    : changeOne(*row.object, value, role, name,
                                [&](Edit& edit, auto changed) { edit.set(row.id, std::move(changed)); });
}

template <class Object, class Put>
bool ObjectList::changeOne(const Object& object, const QVariant& value, int role, const QString& name,
                           const Put& put)
{
    auto changed = std::make_shared<Object>(object);
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
    if (changed->visible == object.visible && changed->name == object.name)
        return false;
    Edit edit;
    put(edit, std::move(changed));
    document_.apply(edit, step.arg(name));
    return true;
}

Qt::ItemFlags ObjectList::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    const Qt::ItemFlags always =
        Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsEditable | Qt::ItemNeverHasChildren;
    const SharedObject& object = rows_[static_cast<size_t>(index.row())].object;
    return object && object->locked ? always : always | Qt::ItemIsSelectable;
}

// Only other ids make another list; a drag changes one row many times a second, whatever others there are.
void ObjectList::follow()
{
    const Scene& scene = document_.scene();
    const auto exchanged = scene.changedSince(shown_);
    shown_ = scene;
    if (!followMeshes())
        return listAll();
    if (exchanged && followExchanged(*exchanged))
        return;
    const Scene::Objects& objects = scene.objects();
    const bool sameIds =
        std::equal(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(meshesFrom_), objects.begin(),
                   objects.end(), [](const Row& row, const auto& entry) { return row.id == entry.first; });
    if (!sameIds)
        return listAll();
    int row = 0;
    for (const auto& [unused, object] : objects)
        show(row++, object);
}

void ObjectList::listAll()
{
    beginResetModel();
    rows_.clear();
    for (const auto& [id, object] : shown_.objects())
        rows_.push_back({id, object, nullptr});
    meshesFrom_ = rows_.size();
    for (const auto& [id, mesh] : shown_.meshes())
        rows_.push_back({id, nullptr, mesh});
    endResetModel();
}

bool ObjectList::followMeshes()
{
    const Scene::Meshes& meshes = shown_.meshes();
    const auto first = rows_.begin() + static_cast<std::ptrdiff_t>(meshesFrom_);
    if (!std::equal(first, rows_.end(), meshes.begin(), meshes.end(),
                    [](const Row& row, const auto& entry) { return row.id == entry.first; }))
        return false;
    auto row = static_cast<int>(meshesFrom_);
    for (const auto& [unused, mesh] : meshes) {
        SharedMesh& shown = rows_[static_cast<size_t>(row)].mesh;
        if (std::exchange(shown, mesh) != mesh)
            Q_EMIT dataChanged(index(row), index(row));
        ++row;
    }
    return true;
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
