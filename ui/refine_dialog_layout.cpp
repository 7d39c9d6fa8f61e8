// How the dialog is put together.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/apply_buttons.h"
#include "ui/refine_dialog.h"

namespace knotspan {

void RefineDialog::makeLayout()
{
    form_ = new QFormLayout;
    kind_ = new QComboBox(this);
    describe(kind_, "kind", tr("What to do"), tr("What is done to the selected surface"));
    const std::pair<RefinementKind, QString> kinds[] = {
        {RefinementKind::insertKnot, tr("Insert a knot")},
        {RefinementKind::removeKnot, tr("Remove a knot")},
        {RefinementKind::raiseDegree, tr("Raise the degree")},
        {RefinementKind::lowerDegree, tr("Lower the degree")},
        {RefinementKind::rebuild, tr("Rebuild with even knots")},
        {RefinementKind::split, tr("Split into two surfaces")},
        {RefinementKind::reverse, tr("Reverse a direction")},
        {RefinementKind::swap, tr("Exchange U and V")},
    };
    for (const auto& [kind, text] : kinds)
        kind_->addItem(text, static_cast<int>(kind));
    direction_ = new QComboBox(this);
    describe(direction_, "direction", tr("Direction"), tr("Which of the surface's two directions"));
    direction_->addItem(tr("U"), static_cast<int>(Direction::U));
    direction_->addItem(tr("V"), static_cast<int>(Direction::V));
    form_->addRow(tr("&What to do"), kind_);
    form_->addRow(tr("&Direction"), direction_);
    makeNumbers(*form_);
    preview_ = new QCheckBox(tr("&Show in the viewport"), this);
    describe(preview_, "preview", tr("Show in the viewport"),
             tr("Show the surface as it would be; closing this dialog takes it back"));
    preview_->setChecked(true);
    details_ = new QLabel(this);
    describe(details_, "details", tr("What happens"), {});
    details_->setTextFormat(Qt::PlainText);
    details_->setWordWrap(true);
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    details_->setMinimumHeight(5 * details_->fontMetrics().lineSpacing());
    details_->setMinimumWidth(48 * details_->fontMetrics().averageCharWidth());
    details_->setAlignment(Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form_);
    column->addWidget(preview_);
    column->addWidget(details_, 1);
    column->addWidget(applyAndClose(*this, apply_, [this] { apply(); }));
    for (QComboBox* box : {kind_, direction_})
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            shown_.takeBack();
            showWhatCounts();
            offerParameter();
            lookSoon();
        });
    connect(preview_, &QCheckBox::toggled, this, &RefineDialog::lookSoon);
}

void RefineDialog::makeNumbers(QFormLayout& form)
{
    const auto number = [&](const char* id, const QString& label, const QString& tip) {
        auto* box = new QDoubleSpinBox(this);
        describe(box, id, QString(label).remove('&'), tip);
        box->setDecimals(6);
        form.addRow(label, box);
        connect(box, &QDoubleSpinBox::valueChanged, this, &RefineDialog::lookSoon);
        return box;
    };
    parameter_ = number("parameter", tr("&At"), tr("Where along the direction, as the surface counts"));
    tolerance_ =
        number("tolerance", tr("&Largest move"), tr("What would move the surface by more is refused"));
    tolerance_->setRange(0, 1e9);
    tolerance_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    tolerance_->setValue(RefinementRequest{}.tolerance);
    const auto whole = [&](const char* id, const QString& label, const QString& tip, int least, int most) {
        auto* box = new QSpinBox(this);
        describe(box, id, QString(label).remove('&'), tip);
        box->setRange(least, most);
        form.addRow(label, box);
        connect(box, &QSpinBox::valueChanged, this, &RefineDialog::lookSoon);
        return box;
    };
    const QString points = tr("Control points in this direction");
    const QString degree = tr("The degree in this direction");
    countU_ = whole("count-u", tr("Control points along &U"), points, 2, 1000);
    countV_ = whole("count-v", tr("Control points along &V"), points, 2, 1000);
    degreeU_ = whole("degree-u", tr("Degree along U"), degree, kMinDegree, kMaxDegree);
    degreeV_ = whole("degree-v", tr("Degree along V"), degree, kMinDegree, kMaxDegree);
}

// Of the boxes, those that count for what is chosen.
void RefineDialog::showWhatCounts()
{
    const RefinementKind what = kind();
    const auto is = [what](std::initializer_list<RefinementKind> kinds) {
        return std::find(kinds.begin(), kinds.end(), what) != kinds.end();
    };
    const auto show = [this](QWidget* box, bool shown) {
        box->setVisible(shown);
        form_->labelForField(box)->setVisible(shown);
    };
    using Kind = RefinementKind;
    show(direction_, !is({Kind::rebuild, Kind::swap}));
    show(parameter_, is({Kind::insertKnot, Kind::removeKnot, Kind::split}));
    show(tolerance_, is({Kind::removeKnot, Kind::lowerDegree}));
    for (QSpinBox* box : {countU_, countV_, degreeU_, degreeV_})
        show(box, is({Kind::rebuild}));
}

}  // namespace knotspan
