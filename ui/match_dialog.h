// Edit > Match edge: makes two surfaces meet smoothly along an edge. What would move is told, and shown in
// the viewport as a preview: closing the dialog takes it back without a trace, and so does whatever else is
// done to the model; Apply makes it one step.
#pragma once

#include <QDialog>
#include <QTimer>

#include "model/document/document.h"
#include "model/matching/scene_match.h"
#include "ui/preview.h"
#include "ui/tools/selection.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace knotspan {

class MatchDialog : public QDialog {
    Q_OBJECT

public:
    // Document and selection outlive it.
    MatchDialog(Document& document, Selection& selection, QWidget* parent = nullptr);

    // The edge that is chosen elsewhere in the window; nothing: none is chosen there, so the dialog keeps its
    // own.
    void setEdge(const std::optional<ObjectEdge>& edge);
    // The edges of the selected objects, the least smooth first.
    void offerEdges();

    [[nodiscard]] const std::optional<ObjectEdge>& edge() const { return edge_; }
    [[nodiscard]] bool isLooking() const { return wait_.isActive(); }  // the answer is yet to come
    [[nodiscard]] bool isPreviewing() const { return shown_.isShown(); }

Q_SIGNALS:
    void edgeChanged();  // edge() is another one

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void makeLayout();
    void makeChoices(QFormLayout& form);
    void makeTolerances(QFormLayout& form);
    void fillEdges();
    [[nodiscard]] QString lineOf(const ObjectEdge& edge) const;
    void chooseEdge(int row);
    void onSelectionChanged();
    void nameSides();
    void lookSoon();
    void look();
    void findAgain();
    void showPreview();
    void apply();
    void onModelChanged();
    [[nodiscard]] FriendTolerances tolerances() const;

    Document& document_;
    Selection& selection_;
    std::vector<ObjectEdge> offered_;
    std::optional<ObjectEdge> edge_;
    std::set<ObjectId> offeredFor_;
    std::optional<SceneMatch> match_;  // of the scene without the preview
    Preview shown_;
    bool isStale_ = false;  // the scene changed since the edge was found
    bool mayShow_ = true;   // not right after the model changed otherwise
    QString done_;          // what was just done
    QTimer wait_;
    QComboBox* edges_ = nullptr;
    QComboBox* target_ = nullptr;
    QComboBox* move_ = nullptr;
    QDoubleSpinBox* gap_ = nullptr;
    QDoubleSpinBox* angle_ = nullptr;
    QDoubleSpinBox* curvature_ = nullptr;
    QCheckBox* preview_ = nullptr;
    QLabel* details_ = nullptr;
    QPushButton* apply_ = nullptr;
};

}  // namespace knotspan
