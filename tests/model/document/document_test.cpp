#include "model/document/document.h"

#include <fstream>
#include <gtest/gtest.h>

#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "tests/support.h"

namespace knotspan {
namespace {

Scene sample(const char* name)
{
    return findSample(name)->make();
}

ObjectId firstId(const Document& document)
{
    return document.scene().objects().begin()->first;
}

// Moves the first object's first control point to x.
Edit moveTo(const Document& document, double x)
{
    const auto& [id, object] = *document.scene().objects().begin();
    Edit edit;
    edit.set(id, withControlPointAt(*object, {0, 0}, Vec3(x, 2, 3)).value());
    return edit;
}

double firstX(const Document& document)
{
    return controlPointInModel(*document.scene().objects().begin()->second, {0, 0}).x;
}

struct Counter {
    int count = 0;
    template <class Signal>
    Counter(Document& document, Signal signal)
    {
        QObject::connect(&document, signal, &document, [this] { ++count; });
    }
};

TEST(Document, UndoReturnsEveryBit)
{
    Document document;
    document.reset(sample("nine-16"), "nine");
    const Scene before = document.scene();
    const SharedObject untouched = before.objects().rbegin()->second;
    document.apply(moveTo(document, 0.1), "move");
    document.apply(moveTo(document, 1.0 / 3.0), "move");
    const Scene after = document.scene();
    EXPECT_FALSE(after == before);
    document.undo();
    document.undo();
    EXPECT_TRUE(document.scene() == before);
    EXPECT_EQ(document.scene().find(firstId(document)), before.find(firstId(document)));
    document.redo();
    document.redo();
    EXPECT_TRUE(document.scene() == after);
    EXPECT_EQ(document.scene().objects().rbegin()->second, untouched);
}

TEST(Document, EditsOfOneGestureAreOneStep)
{
    Document document;
    document.reset(sample("single-100"), "one");
    const Scene before = document.scene();
    const int gesture = document.newGesture();
    for (int step = 1; step <= 20; ++step)
        document.apply(moveTo(document, step), "drag", gesture);
    EXPECT_TRUE(document.isModified());
    EXPECT_TRUE(document.canUndo());
    document.finishGesture(gesture);
    EXPECT_EQ(document.undoStack().count(), 1);
    EXPECT_EQ(firstX(document), 20);
    document.undo();
    EXPECT_TRUE(document.scene() == before);
    document.redo();
    EXPECT_EQ(firstX(document), 20);
}

TEST(Document, TwoGesturesAndZeroNeverJoin)
{
    Document document;
    document.reset(sample("single-100"), "one");
    document.apply(moveTo(document, 1), "a", document.newGesture());
    document.apply(moveTo(document, 2), "b", document.newGesture());
    document.apply(moveTo(document, 3), "c");
    document.apply(moveTo(document, 4), "d");
    EXPECT_EQ(document.undoStack().count(), 4);
    document.undo();
    EXPECT_EQ(firstX(document), 3);
    document.undo();
    EXPECT_EQ(firstX(document), 2);
}

TEST(Document, ACancelledGestureLeavesNoTrace)
{
    Document document;
    document.reset(sample("single-100"), "one");
    document.apply(moveTo(document, 1), "kept");
    document.apply(moveTo(document, 2), "undone");
    document.undo();
    const Scene before = document.scene();
    const int gesture = document.newGesture();
    document.apply(moveTo(document, 7), "drag", gesture);
    document.apply(moveTo(document, 8), "drag", gesture);
    document.cancelGesture(gesture);
    EXPECT_TRUE(document.scene() == before);
    EXPECT_EQ(document.undoStack().count(), 2);
    EXPECT_TRUE(document.canRedo());
    document.redo();
    EXPECT_EQ(firstX(document), 2);
}

TEST(Document, ACancelledGestureInAnUnchangedModelLeavesItUnmodified)
{
    Document document;
    document.reset(sample("single-100"), "one");
    const int gesture = document.newGesture();
    document.apply(moveTo(document, 7), "drag", gesture);
    EXPECT_TRUE(document.isModified());
    document.cancelGesture(gesture);
    EXPECT_FALSE(document.isModified());
    EXPECT_FALSE(document.canUndo());
    EXPECT_FALSE(document.canRedo());
}

TEST(Document, APreviewIsInNoFileAndNoStep)
{
    const testing::TemporaryFolder folder;
    Document document;
    document.reset(sample("nine-16"), "nine");
    document.apply(moveTo(document, 0.1), "move");
    const Scene before = document.scene();
    const int gesture = document.preview(moveTo(document, 0.7), "show");
    const Scene shown = document.scene();
    EXPECT_FALSE(shown == before);
    EXPECT_EQ(document.undoText(), "move");
    ASSERT_TRUE(document.saveAs(folder / "saved.knotspan"));
    EXPECT_TRUE(document.scene() == shown);  // it goes on
    EXPECT_TRUE(document.isPreviewing());
    EXPECT_FALSE(document.isModified());
    Document again;
    ASSERT_TRUE(again.open(folder / "saved.knotspan"));
    EXPECT_TRUE(again.scene() == before);
    document.finishGesture(gesture);
    EXPECT_TRUE(document.isModified());
    EXPECT_TRUE(document.scene() == shown);
    EXPECT_EQ(document.undoStack().count(), 2);
    document.undo();
    EXPECT_TRUE(document.scene() == before);
}

TEST(Document, WhateverElseIsDoneTakesAPreviewBack)
{
    Document document;
    document.reset(sample("nine-16"), "nine");
    const Scene before = document.scene();
    const ObjectId last = before.objects().rbegin()->first;
    Edit removal;
    removal.set(last, nullptr);
    EXPECT_NE(document.preview(moveTo(document, 0.7), "show"), 0);
    document.apply(removal, "remove");
    EXPECT_EQ(document.undoStack().count(), 1);
    EXPECT_EQ(document.scene().find(firstId(document)), before.find(firstId(document)));
    EXPECT_NE(document.preview(moveTo(document, 0.7), "show"), 0);
    document.undo();
    EXPECT_TRUE(document.scene() == before);
    EXPECT_NE(document.preview(moveTo(document, 0.7), "show"), 0);
    EXPECT_TRUE(document.canRedo());
    document.redo();
    EXPECT_EQ(document.scene().find(last), nullptr);
    EXPECT_EQ(document.scene().find(firstId(document)), before.find(firstId(document)));
    EXPECT_NE(document.preview(moveTo(document, 0.7), "show"), 0);
    document.apply(moveTo(document, 0.9), "drag", document.newGesture());
    EXPECT_FALSE(document.isPreviewing());
    EXPECT_EQ(firstX(document), 0.9);
    document.undo();
    EXPECT_EQ(document.scene().find(firstId(document)), before.find(firstId(document)));
    EXPECT_EQ(document.preview(Edit(), "nothing"), 0);
}

TEST(Document, SavingAndOpeningReturnsEveryBit)
{
    const testing::TemporaryFolder folder;
    Document document;
    document.reset(sample("extremes"), "extremes");
    EXPECT_FALSE(document.save().has_value());  // it has no file yet
    document.apply(moveTo(document, 0.1 + 0.2), "move");
    EXPECT_TRUE(document.isModified());
    const auto saved = document.saveAs(folder / "it.knotspan");
    ASSERT_TRUE(saved.has_value()) << saved.error().sentence();
    EXPECT_FALSE(document.isModified());
    EXPECT_EQ(document.title(), "it.knotspan");

    Document other;
    const auto opened = other.open(folder / "it.knotspan");
    ASSERT_TRUE(opened.has_value()) << opened.error().sentence();
    EXPECT_TRUE(other.scene() == document.scene());
    EXPECT_FALSE(other.isModified());
    EXPECT_EQ(other.file(), folder / "it.knotspan");
    other.apply(moveTo(other, 9), "move");
    ASSERT_TRUE(other.save().has_value());
    EXPECT_FALSE(other.isModified());
    other.undo();
    EXPECT_TRUE(other.isModified());
}

TEST(Document, AFailedOpenChangesNothing)
{
    const testing::TemporaryFolder folder;
    testing::writeFile(folder / "broken.knotspan", "{\"format\": \"knotspan\", \"version\": 1, \"obj");
    Document document;
    document.reset(sample("nine-16"), "nine");
    document.apply(moveTo(document, 5), "move");
    const Scene before = document.scene();
    const Counter replaced(document, &Document::documentReplaced);
    const Counter changed(document, &Document::sceneChanged);
    for (const char* name : {"broken.knotspan", "absent.knotspan", "no-extension"}) {
        const auto opened = document.open(folder / name);
        ASSERT_FALSE(opened.has_value());
        EXPECT_NE(opened.error().sentence().find(name), std::string::npos) << opened.error().sentence();
        EXPECT_FALSE(document.add(folder / name).has_value());
    }
    EXPECT_TRUE(document.scene() == before);
    EXPECT_TRUE(document.isModified());
    EXPECT_TRUE(document.canUndo());
    EXPECT_EQ(document.title(), "nine");
    EXPECT_EQ(replaced.count, 0);
    EXPECT_EQ(changed.count, 0);
}

TEST(Document, AFailedSaveKeepsTheModelModified)
{
    const testing::TemporaryFolder folder;
    Document document;
    document.reset(sample("single-100"), "one");
    document.apply(moveTo(document, 5), "move");
    EXPECT_FALSE(document.saveAs(folder / "no/such/folder/it.knotspan").has_value());
    EXPECT_TRUE(document.isModified());
    EXPECT_TRUE(document.file().empty());
}

TEST(Document, AddingAFileIsOneStepAndScalesItsUnits)
{
    const testing::TemporaryFolder folder;
    Scene metres = sample("nine-16");
    metres.setUnits("m");
    metres.addMesh(meshObject("scan", {{{0, 0, 0}, {4, 0, 0}, {0, 0, 2}}, {{0, 1, 2}}}));
    Document writer;
    writer.reset(metres, "metres");
    ASSERT_TRUE(writer.saveAs(folder / "metres.knotspan").has_value());

    Document document;
    Scene millimetres = sample("single-100");
    millimetres.setUnits("mm");
    document.reset(millimetres, "one");
    const auto added = document.add(folder / "metres.knotspan");
    ASSERT_TRUE(added.has_value()) << added.error().sentence();
    ASSERT_EQ(document.scene().objects().size(), 10U);
    const double before = metres.objects().rbegin()->second->bounds().diagonal();
    const double after = document.scene().objects().rbegin()->second->bounds().diagonal();
    EXPECT_NEAR(after / before, 1000, 1e-9);
    ASSERT_EQ(document.scene().meshes().size(), 1U);
    EXPECT_EQ(document.scene().meshes().begin()->second->bounds().high, Vec3(4000, 0, 2000));
    EXPECT_EQ(document.undoStack().count(), 1);
    document.undo();
    EXPECT_EQ(document.scene().objects().size(), 1U);
    EXPECT_TRUE(document.scene().meshes().empty());
}

TEST(Document, TakesNumbersWithoutAUnitAsTheModelsOwn)
{
    const testing::TemporaryFolder folder;
    std::ofstream(folder / "scan.off") << "OFF\n3 1 0\n0 0 0\n4 0 0\n0 0 2\n3 0 1 2\n";
    Document document;
    Scene metres = sample("single-100");
    metres.setUnits("m");
    document.reset(metres, "one");
    const auto added = document.add(folder / "scan.off");
    ASSERT_TRUE(added.has_value()) << added.error().sentence();
    ASSERT_EQ(document.scene().meshes().size(), 1U);
    EXPECT_EQ(document.scene().meshes().begin()->second->bounds().high, Vec3(4, 0, 2));
}

TEST(Document, SignalsTellOfEachChangeOnce)
{
    Document document;
    const Counter changed(document, &Document::sceneChanged);
    const Counter replaced(document, &Document::documentReplaced);
    document.reset(sample("single-100"), "one");
    EXPECT_EQ(replaced.count, 1);
    EXPECT_EQ(changed.count, 1);
    document.apply(moveTo(document, 5), "move");
    EXPECT_EQ(changed.count, 2);
    document.undo();
    EXPECT_EQ(changed.count, 3);
    EXPECT_EQ(replaced.count, 1);
}

}  // namespace
}  // namespace knotspan
