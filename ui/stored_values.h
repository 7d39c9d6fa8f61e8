// Reading settings of sessions before: files of settings are written by hand, too, so what makes no sense is
// passed over.
#pragma once

#include <QSettings>

namespace knotspan {

inline double numberIn(const QSettings& settings, const char* key, double otherwise, double least,
                       double most)
{
    bool isNumber = false;
    const double value = settings.value(key).toDouble(&isNumber);
    return isNumber && value >= least && value <= most ? value : otherwise;
}

template <class Enum>
Enum choiceIn(const QSettings& settings, const char* key, Enum otherwise, Enum last)
{
    return static_cast<Enum>(static_cast<int>(
        numberIn(settings, key, static_cast<double>(otherwise), 0, static_cast<double>(last))));
}

}  // namespace knotspan
