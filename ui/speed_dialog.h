// View > Speed and accuracy: what each path costs on this machine for the open model as the viewport shows
// it, and how far its picture is off. A click on a point sets path and tolerance.
#pragma once

#include <memory>

#include <QDialog>

#include "model/document/document.h"
#include "ui/measuring_thread.h"
#include "ui/viewport/viewport.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace knotspan {

class PlotView;

class SpeedDialog : public QDialog {
    Q_OBJECT

public:
    // Document and viewport outlive it.
    SpeedDialog(Document& document, Viewport& viewport, QWidget* parent = nullptr);
    ~SpeedDialog() override;

    // Measures anew, every path on what the viewport shows; a measurement that runs ends first.
    void measure();
    void measure(const PathMeasurementRequest& wanted);
    // Ends a running measurement before its next frame; what is measured stays.
    void cancel();
    [[nodiscard]] bool isMeasuring() const { return thread_ != nullptr && !thread_->isFinished(); }
    // Whether there is anything to see of the open model.
    [[nodiscard]] bool hasFindings() const { return !rows_.empty(); }
    [[nodiscard]] const std::vector<PathRow>& rows() const { return rows_; }

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void makeLayout();
    void clear();
    void showProgress();
    void showEnd();
    void showPlot();
    void showDetails(const QString& pointedAt);
    void choose(int marker);
    [[nodiscard]] PathMeasurementRequest request() const;
    [[nodiscard]] QStringList notMeasured() const;

    Document& document_;
    Viewport& viewport_;
    std::unique_ptr<MeasuringThread> thread_;
    std::vector<PathRow> rows_;
    std::vector<size_t> markerRows_;
    QString subtitle_;  // what was measured
    QString title_;
    QComboBox* motion_ = nullptr;
    QPushButton* measure_ = nullptr;
    QPushButton* cancel_ = nullptr;
    PlotView* plot_ = nullptr;
    QLabel* details_ = nullptr;
    QProgressBar* progress_ = nullptr;
};

}  // namespace knotspan
