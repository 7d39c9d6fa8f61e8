// What probes say, in words and numbers for people.
#pragma once

#include <QString>

#include "ui/tools/probes.h"

namespace knotspan {

// Seven digits; what is no more than rounding beside `scale` is 0.
[[nodiscard]] QString measureFigure(double value, double scale = 0);
[[nodiscard]] QString vectorText(const Vec3& vector, double scale);
// What curvatures of the place are to be held against.
[[nodiscard]] double curvatureScale(const ProbedPlace& place);
// 1 / |curvature|, or a word where the surface is flat.
[[nodiscard]] QString radiusText(const ProbedPlace& place, double curvature);

// One line: where, which way, how bent.
[[nodiscard]] QString probeSentence(const ProbedPlace& place, const QString& units);

}  // namespace knotspan
