#include "ui/panels/tool_form.h"

#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QScopedValueRollback>

#include "ui/viewport/described.h"

namespace knotspan {

ToolForm::ToolForm(Document& document, Viewport& viewport, const QString& title, QWidget* parent)
    : QGroupBox(title, parent),
      document_(document),
      viewport_(viewport),
      form_(new QFormLayout(this))
{
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void ToolForm::begin()
{
    takeOver();
    connect(&viewport_, &Viewport::toolSettingsChanged, this, &ToolForm::takeOver);
    connect(&document_, &Document::documentReplaced, this, &ToolForm::takeOver);
}

QComboBox* ToolForm::list(const char* id, const QString& label, const QString& tip, const QStringList& texts)
{
    auto* box = new QComboBox(this);
    describe(box, id, QString(label).remove('&'), tip);
    box->addItems(texts);
    form_->addRow(label, box);
    connect(box, &QComboBox::currentIndexChanged, this, &ToolForm::tell);
    return box;
}

QDoubleSpinBox* ToolForm::number(const char* id, const QString& label, const QString& tip, const Range& range)
{
    auto* box = new QDoubleSpinBox(this);
    describe(box, id, QString(label).remove('&'), tip);
    box->setRange(range.least, range.most);
    box->setDecimals(range.decimals);
    form_->addRow(label, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &ToolForm::tell);
    // Enter goes back to the picture, where keys are the tools'.
    connect(box->findChild<QLineEdit*>(), &QLineEdit::returnPressed, &viewport_,
            qOverload<>(&QWidget::setFocus));
    return box;
}

QCheckBox* ToolForm::check(const char* id, const QString& text, const QString& tip)
{
    auto* box = new QCheckBox(text, this);
    describe(box, id, QString(text).remove('&'), tip);
    form_->addRow(box);
    connect(box, &QCheckBox::toggled, this, &ToolForm::tell);
    return box;
}

QString ToolForm::units() const
{
    return " " + QString::fromStdString(document_.scene().units());
}

double ToolForm::stepLength() const
{
    const double size = document_.scene().bounds().diagonal();
    return size > 0 ? std::pow(10, std::floor(std::log10(size / 10))) : 1;
}

void ToolForm::takeOver()
{
    if (isTelling_)
        return;
    const QScopedValueRollback quiet(isTelling_, true);
    show(viewport_.toolSettings());
}

void ToolForm::tell()
{
    if (isTelling_)
        return;
    ToolSettings settings = viewport_.toolSettings();
    read(settings);
    viewport_.setToolSettings(settings);
}

}  // namespace knotspan
