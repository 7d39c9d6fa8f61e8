// File > Export mesh: the visible surfaces as triangles, within a deviation that the user chooses while
// seeing how many triangles that takes.
#pragma once

#include <memory>

#include <QDialog>
#include <QTimer>

#include "model/document/document.h"
#include "ui/export_thread.h"
#include "ui/questions.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace knotspan {

class ExportDialog : public QDialog {
    Q_OBJECT

public:
    // The document outlives it; `questions` ask for the file.
    ExportDialog(Document& document, Questions questions, QWidget* parent = nullptr);
    ~ExportDialog() override;

    [[nodiscard]] formats::MeshExportOptions options() const;
    // Counting or writing, or about to.
    [[nodiscard]] bool isBusy() const { return thread_ != nullptr || soon_.isActive(); }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void makeLayout();
    void proposeDeviation();
    void countSoon();
    void count();
    void askAndWrite();
    void start(const std::filesystem::path& path);
    void takeFromThread();
    void showWritten(const std::filesystem::path& path, const Result<formats::MeshExportReport>& written);
    void enable();
    void makeRoom();

    Document& document_;
    Questions questions_;
    std::unique_ptr<ExportThread> thread_;
    QTimer soon_;
    bool isStale_ = false;  // what is being counted is not what is wanted any more
    QComboBox* format_ = nullptr;
    QDoubleSpinBox* deviation_ = nullptr;
    QCheckBox* limitsAngle_ = nullptr;
    QDoubleSpinBox* angle_ = nullptr;
    QLabel* count_ = nullptr;
    QLabel* outcome_ = nullptr;
    QPushButton* export_ = nullptr;
};

}  // namespace knotspan
