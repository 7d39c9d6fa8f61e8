// File > Export mesh.
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>

#include "model/formats/mesh_export.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/export_dialog.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class ExportMesh : public ::testing::Test {
protected:
    ExportMesh() : window_(answering(answers_))
    {
        window_.files().openSample("torus");
        window_.show();
        window_.action("file.export")->trigger();
        dialog_ = window_.findChild<ExportDialog*>("export-dialog");
    }

    [[nodiscard]] bool rests() const
    {
        QElapsedTimer clock;
        clock.start();
        while (dialog_->isBusy() && clock.elapsed() < 30'000)
            QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
        return !dialog_->isBusy();
    }
    template <class Widget>
    [[nodiscard]] Widget& part(const char* id) const
    {
        return *dialog_->findChild<Widget*>(id);
    }
    [[nodiscard]] QString count() const { return part<QLabel>("count").text(); }
    [[nodiscard]] std::string outcome() const { return part<QLabel>("outcome").text().toStdString(); }
    [[nodiscard]] QString counted(const formats::MeshExportOptions& options) const
    {
        const auto counts = formats::meshCounts(window_.document().scene(), options).value();
        return QString("%1, with %2 vertices")
            .arg(QLocale().toString(static_cast<qulonglong>(counts.triangles)),
                 QLocale().toString(static_cast<qulonglong>(counts.vertices)));
    }

    TemporaryFolder folder_;
    Answers answers_;
    mutable MainWindow window_;
    ExportDialog* dialog_ = nullptr;
};

TEST_F(ExportMesh, TellsTheTrianglesBeforeAnythingIsWritten)
{
    ASSERT_NE(dialog_, nullptr);
    ASSERT_TRUE(rests());
    const QString first = count();
    EXPECT_EQ(first, counted(dialog_->options()));
    part<QDoubleSpinBox>("deviation").setValue(part<QDoubleSpinBox>("deviation").value() / 10);
    ASSERT_TRUE(rests());
    EXPECT_NE(count(), first);
    EXPECT_EQ(count(), counted(dialog_->options()));
    const QString finer = count();
    part<QCheckBox>("limits-angle").setChecked(true);
    part<QDoubleSpinBox>("angle").setValue(2);
    ASSERT_TRUE(rests());
    EXPECT_NE(count(), finer);
    EXPECT_TRUE(outcome().empty());
}

TEST_F(ExportMesh, CountsAnewWhenTheModelChanges)
{
    ASSERT_TRUE(rests());
    const QString first = count();
    window_.files().openSample("sphere");
    ASSERT_TRUE(rests());
    EXPECT_NE(count(), first);
    EXPECT_EQ(count(), counted(dialog_->options()));
    window_.selection().setObjects({window_.document().scene().objects().begin()->first});
    window_.action("edit.delete")->trigger();
    ASSERT_TRUE(rests());
    EXPECT_FALSE(count().isEmpty()) << "a sentence";
    EXPECT_EQ(count().indexOf("vertices"), -1);
}

TEST_F(ExportMesh, WritesEveryFormatAndTellsWhatIsProvedAndMeasured)
{
    auto& format = part<QComboBox>("format");
    for (int k = 0; k < format.count(); ++k) {
        format.setCurrentIndex(k);
        const std::string extension = formats::meshFormats()[static_cast<size_t>(k)].extension;
        answers_.fileToSave = QString::fromStdString((folder_ / "it").string());
        part<QPushButton>("export").click();
        ASSERT_TRUE(rests());
        const auto path = folder_ / ("it." + extension);
        EXPECT_NE(outcome().find("it." + extension + " is written."), std::string::npos) << outcome();
        EXPECT_NE(outcome().find("the furthest found is"), std::string::npos) << outcome();
        EXPECT_NE(outcome().find("The mesh is closed."), std::string::npos) << outcome();
        EXPECT_GT(std::filesystem::file_size(path), 1000U);
    }
}

TEST_F(ExportMesh, ThatCannotBeWrittenSaysWhyAndMayBeTriedAgain)
{
    answers_.fileToSave = QString::fromStdString((folder_ / "no/such/folder.stl").string());
    part<QPushButton>("export").click();
    ASSERT_TRUE(rests());
    EXPECT_NE(outcome().find("There is no folder"), std::string::npos) << outcome();
    EXPECT_TRUE(part<QPushButton>("export").isEnabled());
    answers_.fileToSave.clear();  // called off
    part<QPushButton>("export").click();
    ASSERT_TRUE(rests());
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / ""));
}

TEST_F(ExportMesh, GoesWithTheWindowWhileItCounts)
{
    part<QDoubleSpinBox>("deviation").setValue(part<QDoubleSpinBox>("deviation").value() / 1000);
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 400)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    EXPECT_TRUE(dialog_->isBusy() || !count().isEmpty());
}

}  // namespace
}  // namespace knotspan
