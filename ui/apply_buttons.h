// The two buttons of a dialog that shows what it would do: Apply and Close.
#pragma once

#include <QDialog>
#include <QDialogButtonBox>
#include <QPushButton>

#include "ui/viewport/described.h"

namespace knotspan {

// `apply` becomes the button, `onApply` what it does.
template <class OnApply>
QDialogButtonBox* applyAndClose(QDialog& dialog, QPushButton*& apply, const OnApply& onApply)
{
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Apply | QDialogButtonBox::Close, &dialog);
    apply = buttons->button(QDialogButtonBox::Apply);
    describe(apply, "apply", QDialog::tr("Apply"),
             QDialog::tr("Make the change one step that can be undone"));
    QPushButton* const close = buttons->button(QDialogButtonBox::Close);
    describe(close, "close", QDialog::tr("Close"), QDialog::tr("Take back what is shown but not applied"));
    close->setAutoDefault(false);
    apply->setDefault(true);
    QObject::connect(apply, &QPushButton::clicked, &dialog, onApply);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    return buttons;
}

}  // namespace knotspan
