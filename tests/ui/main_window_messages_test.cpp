// What the window says, in its message bar and its status line, and the room it leaves the picture.
#include <array>

#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QRegularExpression>

#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "tests/support.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

// A model with one surface, trimmed by a triangle.
std::filesystem::path trimmedFile(const TemporaryFolder& folder)
{
    TrimLoop triangle;
    const std::array<Vec2, 3> corners = {Vec2(0.2, 0.2), Vec2(0.8, 0.2), Vec2(0.5, 0.8)};
    for (size_t k = 0; k < corners.size(); ++k)
        triangle.curves.push_back(
            *TrimCurve::create(KnotVector::clampedUniform(1, 1), {{corners[k]}, {corners[(k + 1) % 3]}}));
    Scene scene = findSample("single-100")->make();
    const auto [id, object] = *scene.objects().begin();
    auto trimmed = std::make_shared<SceneObject>(*object);
    trimmed->trimLoops = {triangle};
    scene.exchange(id, trimmed);
    std::filesystem::path path = folder / "trimmed.knotspan";
    EXPECT_TRUE(formats::write(scene, path).has_value());
    return path;
}

TEST(MainWindow, WhatWentWrongIsPastOnceTheDocumentChangesOrIsSaved)
{
    const TemporaryFolder folder;
    Answers answers;
    MainWindow window(answering(answers));
    window.files().open({sampleFile(folder, "nine-16")});
    const auto fail = [&] {
        answers.filesToOpen = {QString::fromStdString((folder / "absent.knotspan").string())};
        window.files().askAndAdd();
        EXPECT_TRUE(window.message().contains("absent.knotspan"));
    };
    fail();
    window.action("edit.selectAll")->trigger();
    EXPECT_FALSE(window.message().isEmpty());  // the document is as it was
    window.action("edit.delete")->trigger();
    EXPECT_EQ(window.message(), QString());
    fail();
    window.action("edit.undo")->trigger();
    EXPECT_EQ(window.message(), QString());
    fail();
    EXPECT_TRUE(window.files().save());
    EXPECT_EQ(window.message(), QString());
    fail();
    answers.filesToOpen = {QString::fromStdString(sampleFile(folder, "single-100").string())};
    window.files().askAndAdd();
    EXPECT_EQ(window.message(), QString());
}

TEST(MainWindow, ShowsTrimmedFacesWithoutAWord)
{
    const TemporaryFolder folder;
    const std::filesystem::path trimmed = trimmedFile(folder);
    Answers answers;
    MainWindow window(answering(answers));
    window.files().open({trimmed});
    EXPECT_EQ(window.message(), QString());
    window.files().open({trimmed, folder / "absent.knotspan"});
    EXPECT_TRUE(window.message().contains("absent.knotspan"));
}

TEST(MainWindow, SaysThatMeshesAreNotInAFileOfSurfaces)
{
    const TemporaryFolder folder;
    Answers answers;
    MainWindow window(answering(answers));
    Scene scene = findSample("nine-16")->make();
    scene.addMesh(meshObject("scan", {{{0, 0, 0}, {4, 0, 0}, {0, 0, 2}}, {{0, 1, 2}}}));
    window.document().reset(scene, "nine");
    Edit edit;
    edit.set(scene.objects().begin()->first, nullptr);
    window.document().apply(edit, "delete");
    answers.fileToSave = QString::fromStdString((folder / "it.obj").string());
    ASSERT_TRUE(window.files().saveAs());
    EXPECT_TRUE(window.message().contains("the meshes are not in it.obj")) << window.message().toStdString();
    EXPECT_TRUE(window.document().isModified()) << "the meshes are in no file";
    answers.fileToSave = QString::fromStdString((folder / "it.knotspan").string());
    ASSERT_TRUE(window.files().saveAs());
    EXPECT_TRUE(window.message().isEmpty());
    EXPECT_FALSE(window.document().isModified());
    EXPECT_EQ(formats::read(folder / "it.knotspan").value().meshes().size(), 1U);
}

TEST(MainWindow, ASmallWindowKeepsAPicture)
{
    Answers answers;
    MainWindow window(answering(answers));
    window.files().openSample("single-100");
    window.show();
    window.resize(1, 1);
    settle(window);
    EXPECT_GE(window.viewport().width(), 360);
    EXPECT_GE(window.viewport().height(), 300);
    EXPECT_LE(window.width(), 800);
    EXPECT_LE(window.height(), 600);
}

TEST(MainWindow, TheStatusLineSaysHowToPullASurface)
{
    Answers answers;
    MainWindow window(answering(answers));
    const auto* hint = window.findChild<QLabel*>("hint");
    ASSERT_NE(hint, nullptr);
    EXPECT_TRUE(hint->text().contains("control points"));
    for (const char* id : {"view.nets", "help.keys"}) {
        const QString key = window.action(id)->shortcut().toString(QKeySequence::NativeText);
        EXPECT_TRUE(hint->text().contains(QRegularExpression("\\b" + key + "\\b"))) << id;
    }
}

}  // namespace
}  // namespace knotspan
