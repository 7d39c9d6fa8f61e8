// How the dialog is put together.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/apply_buttons.h"
#include "ui/match_dialog.h"

namespace knotspan {

void MatchDialog::makeLayout()
{
    auto* form = new QFormLayout;
    makeChoices(*form);
    makeTolerances(*form);
    preview_ = new QCheckBox(tr("&Show in the viewport"), this);
    describe(preview_, "preview", tr("Show in the viewport"),
             tr("Show the model as it would be; closing this dialog takes it back"));
    preview_->setChecked(true);
    details_ = new QLabel(this);
    details_->setObjectName("details");
    details_->setAccessibleName(tr("What moves"));
    details_->setTextFormat(Qt::PlainText);
    details_->setWordWrap(true);
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    details_->setMinimumHeight(7 * details_->fontMetrics().lineSpacing());
    details_->setAlignment(Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(preview_);
    column->addWidget(details_, 1);
    column->addWidget(applyAndClose(*this, apply_, [this] { apply(); }));
    connect(preview_, &QCheckBox::toggled, this, [this] {
        mayShow_ = true;
        look();
    });
}

void MatchDialog::makeChoices(QFormLayout& form)
{
    edges_ = new QComboBox(this);
    describe(edges_, "edge", tr("Edge"), tr("An edge of the selected objects, the least smooth first"));
    edges_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    edges_->setMinimumContentsLength(36);
    target_ = new QComboBox(this);
    describe(target_, "target", tr("Make it"), tr("How smoothly the surfaces are to meet"));
    target_->addItem(tr("G0: without a gap"), static_cast<int>(Continuity::g0));
    target_->addItem(tr("G1: with the same tangent planes"), static_cast<int>(Continuity::g1));
    target_->addItem(tr("G2: with the same curvatures"), static_cast<int>(Continuity::g2));
    target_->setCurrentIndex(1);
    move_ = new QComboBox(this);
    describe(move_, "move", tr("What moves"), tr("Which of the two surfaces gives way"));
    move_->addItem({}, static_cast<int>(MatchSides::a));
    move_->addItem({}, static_cast<int>(MatchSides::b));
    move_->addItem(tr("Both, half the way each"), static_cast<int>(MatchSides::both));
    move_->setCurrentIndex(1);
    form.addRow(tr("&Edge"), edges_);
    form.addRow(tr("Ma&ke it"), target_);
    form.addRow(tr("&Move"), move_);
    connect(edges_, &QComboBox::activated, this, &MatchDialog::chooseEdge);
    for (QComboBox* box : {target_, move_})
        connect(box, &QComboBox::currentIndexChanged, this, &MatchDialog::lookSoon);
}

void MatchDialog::makeTolerances(QFormLayout& form)
{
    const auto add = [&](const char* id, const QString& label, const QString& tip, double value,
                         double highest) {
        auto* box = new QDoubleSpinBox(this);
        describe(box, id, QString(label).remove('&'), tip);
        box->setDecimals(6);
        box->setRange(1e-6, highest);
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        box->setValue(value);
        form.addRow(label, box);
        connect(box, &QDoubleSpinBox::valueChanged, this, &MatchDialog::lookSoon);
        return box;
    };
    const FriendTolerances defaults = MatchRequest{}.tolerances;
    gap_ = add("gap", tr("Largest &gap"), tr("How far the edges may stay apart, in the model's units"),
               defaults.gap, 1000);
    angle_ = add("angle", tr("Largest a&ngle"), tr("Between the tangent planes of the two sides, in degrees"),
                 defaults.angleDeg, 10);
    angle_->setSuffix("°");
    curvature_ =
        add("curvature", tr("Largest difference of c&urvatures"),
            tr("As a part of the larger of the two; it counts for G2 only"), 100 * defaults.curvature, 100);
    curvature_->setDecimals(4);
    curvature_->setSuffix(tr(" %"));
}

}  // namespace knotspan
