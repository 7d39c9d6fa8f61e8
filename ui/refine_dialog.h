// Edit > Refine surface: knots, degrees, a rebuilt net, a cut, of the selected surface. How far it would move
// is told, and shown in the viewport as a preview, before Apply makes it one step.
#pragma once

#include <QDialog>
#include <QTimer>

#include "model/refining/object_refinement.h"
#include "ui/preview.h"
#include "ui/tools/selection.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace knotspan {

class RefineDialog : public QDialog {
    Q_OBJECT

public:
    // Document and selection outlive it.
    RefineDialog(Document& document, Selection& selection, QWidget* parent = nullptr);

    [[nodiscard]] bool isLooking() const { return wait_.isActive(); }  // the answer is yet to come
    [[nodiscard]] bool isPreviewing() const { return shown_.isShown(); }

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeLayout();
    void makeNumbers(QFormLayout& form);
    // The surface that is refined: the only selected one.
    [[nodiscard]] std::optional<ObjectId> target() const;
    void takeTarget();
    void showWhatCounts();
    void offerParameter();
    [[nodiscard]] RefinementKind kind() const;
    [[nodiscard]] Direction direction() const;
    [[nodiscard]] RefinementRequest request() const;
    void lookSoon();
    void look();
    [[nodiscard]] QString report(const SceneObject& before, const RefinedObject& after) const;
    void apply();

    Document& document_;
    Selection& selection_;
    Preview shown_;
    std::optional<ObjectId> taken_;  // whose numbers the boxes have
    Edit edit_;                      // of the scene without the preview; empty where nothing is to be done
    QString done_;                   // what was just done
    bool mayShow_ = true;            // not right after the model changed otherwise
    QTimer wait_;
    QFormLayout* form_ = nullptr;
    QComboBox* kind_ = nullptr;
    QComboBox* direction_ = nullptr;
    QDoubleSpinBox* parameter_ = nullptr;
    QDoubleSpinBox* tolerance_ = nullptr;
    QSpinBox* countU_ = nullptr;
    QSpinBox* countV_ = nullptr;
    QSpinBox* degreeU_ = nullptr;
    QSpinBox* degreeV_ = nullptr;
    QCheckBox* preview_ = nullptr;
    QLabel* details_ = nullptr;
    QPushButton* apply_ = nullptr;
};

}  // namespace knotspan
