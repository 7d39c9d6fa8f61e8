#include "model/document/object_list.h"

#include <gtest/gtest.h>

#include "model/samples/sample_list.h"

namespace knotspan {
namespace {

TEST(ObjectList, FollowsTheScene)
{
    Document document;
    const ObjectList list(document);
    EXPECT_EQ(list.rowCount(), 0);
    document.reset(findSample("nine-16")->make(), "nine");
    EXPECT_EQ(list.rowCount(), 9);
    const ObjectId last = document.scene().objects().rbegin()->first;
    EXPECT_EQ(list.idAt(8), last);
    EXPECT_EQ(list.rowOf(last), 8);
    Edit edit;
    edit.set(document.scene().objects().begin()->first, nullptr);
    document.apply(edit, "delete");
    EXPECT_EQ(list.rowCount(), 8);
    EXPECT_EQ(list.rowOf(last), 7);
    document.undo();
    EXPECT_EQ(list.rowCount(), 9);
}

MeshObject triangle(const std::string& name)
{
    return meshObject(name, {{{0, 0, 0}, {4, 0, 0}, {0, 0, 2}}, {{0, 1, 2}}});
}

TEST(ObjectList, ShowsMeshesBehindTheObjects)
{
    Document document;
    ObjectList list(document);
    Scene scene = findSample("nine-16")->make();
    const ObjectId mesh = scene.addMesh(triangle("scan"));
    const ObjectId later = scene.add(*scene.objects().begin()->second);
    document.reset(scene, "nine");
    ASSERT_EQ(list.rowCount(), 11);
    EXPECT_EQ(list.rowOf(mesh), 10);
    EXPECT_EQ(list.rowOf(later), 9);
    EXPECT_TRUE(list.isMesh(10));
    EXPECT_FALSE(list.isMesh(9));
    const QModelIndex row = list.index(10);
    EXPECT_EQ(list.data(row, Qt::DisplayRole).toString(), "scan (mesh)");
    EXPECT_TRUE(list.data(row, Qt::ToolTipRole).toString().contains("1 triangles"));
    EXPECT_TRUE(list.setData(row, Qt::Unchecked, Qt::CheckStateRole));
    EXPECT_FALSE(document.scene().meshes().at(mesh)->visible);
    EXPECT_TRUE(list.setData(row, "older", Qt::EditRole));
    EXPECT_EQ(list.data(row, Qt::EditRole).toString(), "older");
    document.undo();
    document.undo();
    EXPECT_EQ(list.data(row, Qt::EditRole).toString(), "scan");
    EXPECT_EQ(list.data(row, Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Checked));

    Edit edit;
    edit.setMesh(mesh, nullptr);
    document.apply(edit, "delete");
    EXPECT_EQ(list.rowCount(), 10);
    EXPECT_EQ(list.rowOf(mesh), -1);
    document.undo();
    EXPECT_EQ(list.rowOf(mesh), 10);
}

TEST(ObjectList, HidingAndRenamingAreStepsThatCanBeUndone)
{
    Document document;
    document.reset(findSample("nine-16")->make(), "nine");
    ObjectList list(document);
    const QModelIndex row = list.index(2);
    const QString name = list.data(row, Qt::DisplayRole).toString();
    EXPECT_TRUE(list.setData(row, Qt::Unchecked, Qt::CheckStateRole));
    EXPECT_FALSE(document.scene().find(list.idAt(2))->visible);
    EXPECT_FALSE(list.setData(row, Qt::Unchecked, Qt::CheckStateRole));  // already hidden: no step
    EXPECT_TRUE(list.setData(row, "keel", Qt::EditRole));
    EXPECT_EQ(list.data(row, Qt::DisplayRole).toString(), "keel");
    EXPECT_EQ(document.undoStack().count(), 2);
    document.undo();
    document.undo();
    EXPECT_EQ(list.data(row, Qt::DisplayRole).toString(), name);
    EXPECT_EQ(list.data(row, Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Checked));
}

TEST(ObjectList, RenamingDuringAPreviewKeepsNothingOfIt)
{
    Document document;
    document.reset(findSample("nine-16")->make(), "nine");
    ObjectList list(document);
    const ObjectId id = list.idAt(2);
    const SharedObject before = document.scene().find(id);
    auto shown = std::make_shared<SceneObject>(*before);
    shown->surface = document.scene().find(list.idAt(3))->surface;
    Edit edit;
    edit.set(id, shown);
    EXPECT_NE(document.preview(edit, "show"), 0);
    EXPECT_TRUE(list.setData(list.index(2), "keel", Qt::EditRole));
    EXPECT_EQ(document.scene().find(id)->name, "keel");
    EXPECT_EQ(document.scene().find(id)->surface, before->surface);
    EXPECT_EQ(document.undoStack().count(), 1);
}

TEST(ObjectList, AChangedObjectChangesItsRowAlone)
{
    Document document;
    document.reset(findSample("nine-16")->make(), "nine");
    ObjectList list(document);
    std::vector<int> rows;
    int resets = 0;
    QObject::connect(&list, &ObjectList::dataChanged, &list,
                     [&](const QModelIndex& from, const QModelIndex& to) {
                         rows.push_back(from.row());
                         EXPECT_EQ(from, to);
                     });
    QObject::connect(&list, &ObjectList::modelReset, &list, [&] { ++resets; });
    list.setData(list.index(4), Qt::Unchecked, Qt::CheckStateRole);
    EXPECT_EQ(rows, std::vector<int>{4});
    EXPECT_EQ(resets, 0);
}

}  // namespace
}  // namespace knotspan
