// The scene's objects, and behind them its meshes, as an item model for list views: name (editable), colour,
// visibility (a check box).
// What the user changes in the view goes through the document, as steps that can be undone.
#pragma once

#include <QAbstractListModel>

#include "model/document/document.h"

namespace knotspan {

class ObjectList : public QAbstractListModel {
    Q_OBJECT

public:
    // The document outlives the list.
    explicit ObjectList(Document& document, QObject* parent = nullptr);

    [[nodiscard]] ObjectId idAt(int row) const { return rows_[static_cast<size_t>(row)].id; }
    [[nodiscard]] bool isMesh(int row) const { return rows_[static_cast<size_t>(row)].mesh != nullptr; }
    [[nodiscard]] int rowOf(ObjectId id) const;  // -1 where there is none

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    struct Row {
        ObjectId id;
        SharedObject object;  // one of the two
        SharedMesh mesh;
    };
    // `put` sets the changed object in an edit.
    template <class Object, class Put>
    bool changeOne(const Object& object, const QVariant& value, int role, const QString& name,
                   const Put& put);
    void follow();
    // Where only these were exchanged; false: others are in the list now.
    bool followExchanged(const std::vector<ObjectId>& ids);
    void show(int row, const SharedObject& object);
    [[nodiscard]] bool followMeshes();  // false: others are in the list now
    void listAll();
    [[nodiscard]] QString nameAt(int row) const;
    [[nodiscard]] QString tipAt(int row) const;

    Document& document_;
    std::vector<Row> rows_;  // objects by id, then meshes by id
    size_t meshesFrom_ = 0;  // the first mesh's row
    Scene shown_;
};

}  // namespace knotspan
