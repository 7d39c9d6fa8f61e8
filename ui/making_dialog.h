// What the dialogs of the menu Object share that make or move objects by numbers: rows of boxes, a preview in
// the viewport, a sentence about what happens, and Apply, which makes it one step.
#pragma once

#include <array>

#include <QDialog>
#include <QStringList>
#include <QTimer>

#include "model/core/result.h"
#include "ui/preview.h"
#include "ui/tools/selection.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace knotspan {

// What Apply would do; without an edit `told` says why there is none.
struct Making {
    Edit edit;
    QString step;  // "Add a sphere"
    QString told;
    std::set<ObjectId> selected;  // afterwards
};

class MakingDialog : public QDialog {
    Q_OBJECT

public:
    [[nodiscard]] bool isLooking() const { return wait_.isActive(); }  // the answer is yet to come
    [[nodiscard]] bool isPreviewing() const { return shown_.isShown(); }

protected:
    using VectorBoxes = std::array<QDoubleSpinBox*, 3>;
    using Selected = std::vector<std::pair<ObjectId, SharedObject>>;

    // Document and selection outlive it.
    MakingDialog(Document& document, Selection& selection, const QString& title, QWidget* parent);

    // Of the scene without what is shown.
    [[nodiscard]] virtual Making make() const = 0;
    // As the dialog comes up: the boxes begin with what suits the scene.
    virtual void offerNumbers() {}

    // Rows, from top to bottom; then finishLayout().
    QComboBox* addChoice(const char* id, const QString& label, const QString& tip, const QStringList& items);
    QDoubleSpinBox* addNumber(const char* id, const QString& label, const QString& tip);
    QDoubleSpinBox* addLength(const char* id, const QString& label, const QString& tip);
    // Of three boxes, "ID-x", "ID-y" and "ID-z".
    VectorBoxes addVector(const char* id, const QString& label, const QString& tip, bool isLength = true);
    QCheckBox* addSwitch(const char* id, const QString& label, const QString& tip);
    void showRow(QWidget* box, bool isShown);
    void showRow(const VectorBoxes& boxes, bool isShown);
    void setRowLabel(const VectorBoxes& boxes, const QString& label);
    void finishLayout();

    [[nodiscard]] const Scene& scene() const { return document_.scene(); }
    [[nodiscard]] Selected selectedObjects() const;
    [[nodiscard]] static Vec3 centreOf(const Selected& objects);  // of the box around them
    // Another selection is looked at too.
    void followSelection();
    void lookSoon();
    // About a quarter of what the visible objects take up; 1 where there is none.
    [[nodiscard]] double sceneSize() const;

    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QDoubleSpinBox* makeBox(const QString& id, const QString& name, const QString& tip, bool isLength);
    [[nodiscard]] QWidget* rowOf(const VectorBoxes& boxes) const;
    void fitLengths();
    void look();
    void apply();

    Document& document_;
    Selection& selection_;
    Preview shown_;
    Making made_;
    QString done_;         // what was just done
    bool mayShow_ = true;  // not right after the model changed otherwise
    bool isApplying_ = false;
    std::set<ObjectId> seen_;  // of the selection
    QTimer wait_;
    QFormLayout* form_ = nullptr;
    std::vector<QDoubleSpinBox*> lengths_;
    QCheckBox* preview_ = nullptr;
    QLabel* details_ = nullptr;
    QPushButton* apply_ = nullptr;
};

[[nodiscard]] Vec3 valueOf(const std::array<QDoubleSpinBox*, 3>& boxes);
// Nobody hears of it.
void setValue(const std::array<QDoubleSpinBox*, 3>& boxes, const Vec3& value);
void setQuietly(QDoubleSpinBox& box, double value);

// Nothing to do, and why.
[[nodiscard]] Making refusal(const QString& sentence);
[[nodiscard]] Making refusal(const Error& error);

}  // namespace knotspan
