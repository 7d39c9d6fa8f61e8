#include "ui/making_dialog.h"

#include <algorithm>
#include <cmath>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHideEvent>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSignalBlocker>

namespace knotspan {

namespace {

constexpr int kWaitMs = 120;  // for the hand that still turns a value

// 1, 2 or 5 times a power of ten, at most `value`.
double rounded(double value)
{
    const double power = std::pow(10, std::floor(std::log10(value)));
    const double digit = value / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

}  // namespace

MakingDialog::MakingDialog(Document& document, Selection& selection, const QString& title, QWidget* parent)
    : QDialog(parent),
      document_(document),
      selection_(selection),
      shown_(document, title, this)
{
    setWindowTitle(title);
    wait_.setSingleShot(true);
    wait_.setInterval(kWaitMs);
    connect(&wait_, &QTimer::timeout, this, &MakingDialog::look);
    connect(&shown_, &Preview::modelChanged, this, [this] {
        done_.clear();
        mayShow_ = false;
        if (isVisible())
            wait_.start();
    });
}

void MakingDialog::followSelection()
{
    connect(&selection_, &Selection::changed, this, [this] {
        if (isApplying_ || selection_.objects() == seen_)
            return;
        seen_ = selection_.objects();
        shown_.takeBack();
        if (isVisible())
            lookSoon();
    });
}

void MakingDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    seen_ = selection_.objects();
    fitLengths();
    offerNumbers();
    lookSoon();
}

void MakingDialog::hideEvent(QHideEvent* event)
{
    wait_.stop();
    shown_.takeBack();
    QDialog::hideEvent(event);
}

MakingDialog::Selected MakingDialog::selectedObjects() const
{
    Selected list;
    for (const ObjectId id : selection_.objects())
        if (SharedObject object = scene().find(id))
            list.emplace_back(id, std::move(object));
    return list;
}

Vec3 MakingDialog::centreOf(const Selected& objects)
{
    Box box;
    for (const auto& [id, object] : objects)
        box.add(object->bounds());
    return box.centre();
}

double MakingDialog::sceneSize() const
{
    const double size = scene().bounds().diagonal() / 4;
    return size > 0 && std::isfinite(size) ? rounded(size) : 1;
}

// Enough decimals for small models, steps that are seen in large ones.
void MakingDialog::fitLengths()
{
    const double size = sceneSize();
    const int digits = static_cast<int>(std::floor(std::log10(size)));
    for (QDoubleSpinBox* box : lengths_) {
        const QSignalBlocker quiet(box);
        box->setDecimals(std::clamp(5 - digits, 3, 12));
        box->setSingleStep(size / 10);
    }
}

void MakingDialog::lookSoon()
{
    mayShow_ = true;
    done_.clear();
    wait_.start();
}

void MakingDialog::look()
{
    wait_.stop();
    shown_.takeBack();
    const QString units = " " + QString::fromStdString(scene().units());
    for (QDoubleSpinBox* box : lengths_)
        if (box->suffix() != units)
            box->setSuffix(units);  // which rewrites a number that is half typed
    made_ = make();
    const bool can = !made_.edit.isEmpty();
    details_->setText(can && !done_.isEmpty() ? done_ : made_.told);
    apply_->setEnabled(can);
    shown_.setText(made_.step);
    if (can && preview_->isChecked() && mayShow_ && isVisible())
        shown_.show(made_.edit);
}

void MakingDialog::apply()
{
    if (wait_.isActive())
        look();
    if (made_.edit.isEmpty())
        return;
    const QScopedValueRollback applying(isApplying_, true);
    shown_.apply(made_.edit);
    selection_.setObjects(made_.selected);
    seen_ = selection_.objects();
    mayShow_ = false;
    done_ = tr("Done: %1. Apply does it once more; other numbers are shown first.").arg(made_.step);
    look();
}

Vec3 valueOf(const std::array<QDoubleSpinBox*, 3>& boxes)
{
    return {boxes[0]->value(), boxes[1]->value(), boxes[2]->value()};
}

void setQuietly(QDoubleSpinBox& box, double value)
{
    const QSignalBlocker quiet(box);
    box.setValue(value);
}

void setValue(const std::array<QDoubleSpinBox*, 3>& boxes, const Vec3& value)
{
    for (int k = 0; k < 3; ++k)
        setQuietly(*boxes[static_cast<size_t>(k)], value[k]);
}

Making refusal(const QString& sentence)
{
    Making none;
    none.told = sentence;
    return none;
}

Making refusal(const Error& error)
{
    return refusal(QString::fromStdString(error.sentence()));
}

}  // namespace knotspan
