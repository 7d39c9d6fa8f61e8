// What the selected objects are: how large, of how many control points, what area. Figures that take time
// come from another thread; nothing is measured while it is hidden.
#pragma once

#include <memory>

#include <QGroupBox>
#include <QTimer>

#include "model/document/document.h"
#include "ui/panels/object_properties.h"
#include "ui/tools/selection.h"

class QFormLayout;
class QLabel;
class QPushButton;

namespace knotspan {

class PropertiesView : public QGroupBox {
    Q_OBJECT

public:
    // Both outlive it.
    PropertiesView(Document& document, Selection& selection, QWidget* parent = nullptr);
    ~PropertiesView() override;

    // Whether figures are still to come.
    [[nodiscard]] bool isMeasuring() const { return thread_ != nullptr; }

private:
    struct Known {
        MeasuredObject object;
        ObjectProperties properties;
    };
    QLabel* addLine(const char* id, const QString& title, const QString& tip);
    void follow();
    void measure();
    void takeResults();
    void show();
    void showCounts();
    void showMeasured();
    void copy() const;

    Document& document_;
    Selection& selection_;
    MeasuredObjects wanted_;
    std::map<ObjectId, Known> known_;
    std::unique_ptr<PropertiesThread> thread_;  // null: nothing is being measured
    QTimer progress_;
    QFormLayout* lines_ = nullptr;
    QLabel* objects_ = nullptr;
    QLabel* degrees_ = nullptr;
    QLabel* points_ = nullptr;
    QLabel* ksquads_ = nullptr;
    QLabel* low_ = nullptr;
    QLabel* high_ = nullptr;
    QLabel* size_ = nullptr;
    QLabel* area_ = nullptr;
    QPushButton* copy_ = nullptr;
};

}  // namespace knotspan
