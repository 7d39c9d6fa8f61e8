// The names that a dialog's widget has: for tests, for screen readers, for people.
#pragma once

#include <QWidget>

namespace knotspan {

inline void describe(QWidget* widget, const char* id, const QString& name, const QString& tip)
{
    widget->setObjectName(id);
    widget->setAccessibleName(name);
    widget->setToolTip(tip);
}

}  // namespace knotspan
