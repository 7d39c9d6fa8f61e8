// View > Speed and accuracy: what each path costs on this machine for the open model as the viewport shows
// it, and how far its picture is off. A click on a point sets path and tolerance. Help > Benchmark: the same
// on a fixed flight around the model, so that reports of different machines compare.
#pragma once

#include <memory>

#include <QDialog>

#include "model/document/document.h"
#include "renderer/measurement/measurement_json.h"
#include "ui/measuring_thread.h"
#include "ui/questions.h"
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
    enum class Views { viewport, flight };

    // Document and viewport outlive it.
    SpeedDialog(Document& document, Viewport& viewport, Questions questions, QWidget* parent = nullptr);
    ~SpeedDialog() override;

    // Measures anew, every path on what the viewport shows or on the flight; a measurement that runs ends
    // first.
    void measure();
    void measure(Views views);
    void measure(const PathMeasurementRequest& wanted);
    // Ends a running measurement before its next frame; what is measured stays.
    void cancel();
    [[nodiscard]] bool isMeasuring() const { return thread_ != nullptr && !thread_->isFinished(); }
    // Whether there is anything to see of the open model.
    [[nodiscard]] bool hasFindings() const { return !rows_.empty(); }
    [[nodiscard]] const std::vector<PathRow>& rows() const { return rows_; }
    [[nodiscard]] Views views() const;  // as chosen, for the next measurement
    // What there is so far as JSON, with the device's description; what Copy and Save give.
    [[nodiscard]] std::string reportText() const;

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void makeLayout();
    void makeControls();
    void copyReport();
    void saveReport();
    void showReportButtons();
    [[nodiscard]] static QString whatRuns(const MeasuringThread::State& state);
    [[nodiscard]] QString deviceName() const;
    void clear();
    void showProgress();
    void showEnd();
    void showPlot();
    void showDetails(const QString& pointedAt);
    void choose(int marker);
    [[nodiscard]] PathMeasurementRequest request(Views views) const;
    [[nodiscard]] QStringList notMeasured() const;

    Document& document_;
    Viewport& viewport_;
    std::unique_ptr<MeasuringThread> thread_;
    std::vector<PathRow> rows_;
    std::vector<size_t> markerRows_;
    PathReport subject_;  // what was measured; rows and device come from the thread
    Questions questions_;
    QString subtitle_;  // what was measured
    QString title_;
    QComboBox* views_ = nullptr;
    QComboBox* motion_ = nullptr;
    QPushButton* copy_ = nullptr;
    QPushButton* save_ = nullptr;
    QPushButton* measure_ = nullptr;
    QPushButton* cancel_ = nullptr;
    PlotView* plot_ = nullptr;
    QLabel* details_ = nullptr;
    QProgressBar* progress_ = nullptr;
};

}  // namespace knotspan
