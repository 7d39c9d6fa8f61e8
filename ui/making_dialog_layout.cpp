// How the dialogs that make objects are put together.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/apply_buttons.h"
#include "ui/making_dialog.h"

namespace knotspan {

namespace {

constexpr double kLargestNumber = 1e9;

QFormLayout* formOf(QFormLayout*& form)
{
    if (form == nullptr)
        form = new QFormLayout;
    return form;
}

QString withoutMnemonic(QString label)
{
    return label.remove('&');
}

}  // namespace

QComboBox* MakingDialog::addChoice(const char* id, const QString& label, const QString& tip,
                                   const QStringList& items)
{
    auto* box = new QComboBox(this);
    describe(box, id, withoutMnemonic(label), tip);
    box->addItems(items);
    formOf(form_)->addRow(label, box);
    connect(box, &QComboBox::currentIndexChanged, this, &MakingDialog::lookSoon);
    return box;
}

// Without bounds that count: what a number must not be, the model says in words.
QDoubleSpinBox* MakingDialog::makeBox(const QString& id, const QString& name, const QString& tip,
                                      bool isLength)
{
    auto* box = new QDoubleSpinBox(this);
    describe(box, id.toUtf8().constData(), name, tip);
    box->setDecimals(6);
    box->setRange(-kLargestNumber, kLargestNumber);
    if (isLength)
        lengths_.push_back(box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &MakingDialog::lookSoon);
    return box;
}

QDoubleSpinBox* MakingDialog::addNumber(const char* id, const QString& label, const QString& tip)
{
    QDoubleSpinBox* box = makeBox(id, withoutMnemonic(label), tip, false);
    formOf(form_)->addRow(label, box);
    return box;
}

QDoubleSpinBox* MakingDialog::addLength(const char* id, const QString& label, const QString& tip)
{
    QDoubleSpinBox* box = makeBox(id, withoutMnemonic(label), tip, true);
    formOf(form_)->addRow(label, box);
    return box;
}

MakingDialog::VectorBoxes MakingDialog::addVector(const char* id, const QString& label, const QString& tip,
                                                  bool isLength)
{
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    VectorBoxes boxes{};
    for (size_t k = 0; k < 3; ++k) {
        const QChar axis = QString("xyz")[static_cast<qsizetype>(k)];
        boxes[k] = makeBox(QString("%1-%2").arg(id, axis), QString("%1 %2").arg(withoutMnemonic(label), axis),
                           tip, isLength);
        line->addWidget(boxes[k], 1);
    }
    formOf(form_)->addRow(label, row);
    if (auto* shown = qobject_cast<QLabel*>(form_->labelForField(row)))
        shown->setBuddy(boxes[0]);  // where its mnemonic leads
    return boxes;
}

QCheckBox* MakingDialog::addSwitch(const char* id, const QString& label, const QString& tip)
{
    auto* box = new QCheckBox(label, this);
    describe(box, id, withoutMnemonic(label), tip);
    formOf(form_)->addRow(QString(), box);
    connect(box, &QCheckBox::toggled, this, &MakingDialog::lookSoon);
    return box;
}

QWidget* MakingDialog::rowOf(const VectorBoxes& boxes) const
{
    return boxes[0]->parentWidget();
}

void MakingDialog::showRow(QWidget* box, bool isShown)
{
    form_->setRowVisible(box, isShown);
}

void MakingDialog::showRow(const VectorBoxes& boxes, bool isShown)
{
    form_->setRowVisible(rowOf(boxes), isShown);
}

void MakingDialog::setRowLabel(const VectorBoxes& boxes, const QString& label)
{
    if (auto* shown = qobject_cast<QLabel*>(form_->labelForField(rowOf(boxes))))
        shown->setText(label);
    for (size_t k = 0; k < 3; ++k)
        boxes[k]->setAccessibleName(
            QString("%1 %2").arg(withoutMnemonic(label), QString("xyz")[static_cast<qsizetype>(k)]));
}

void MakingDialog::finishLayout()
{
    preview_ = new QCheckBox(tr("Show &in the viewport"), this);
    describe(preview_, "preview", tr("Show in the viewport"),
             tr("Show the model as it would be; closing this dialog takes it back"));
    preview_->setChecked(true);
    connect(preview_, &QCheckBox::toggled, this, &MakingDialog::lookSoon);
    details_ = new QLabel(this);
    describe(details_, "details", tr("What happens"), {});
    details_->setTextFormat(Qt::PlainText);
    details_->setWordWrap(true);
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    details_->setMinimumHeight(3 * details_->fontMetrics().lineSpacing());
    details_->setMinimumWidth(56 * details_->fontMetrics().averageCharWidth());
    details_->setAlignment(Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->addLayout(formOf(form_));
    column->addWidget(preview_);
    column->addWidget(details_, 1);
    column->addWidget(applyAndClose(*this, apply_, [this] { apply(); }));
}

}  // namespace knotspan
