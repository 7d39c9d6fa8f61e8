#include "ui/tools/probe_texts.h"

#include <algorithm>
#include <cmath>

#include <QObject>

namespace knotspan {

namespace {

constexpr double kRounding = 1e-13;
constexpr double kFlat = 1000;  // times the object's size: a radius that may be rounding

}  // namespace

QString measureFigure(double value, double scale)
{
    return QString::number(std::abs(value) <= kRounding * scale ? 0 : value, 'g', 7);
}

QString vectorText(const Vec3& vector, double scale)
{
    return QString("%1, %2, %3")
        .arg(measureFigure(vector.x, scale), measureFigure(vector.y, scale), measureFigure(vector.z, scale));
}

double curvatureScale(const ProbedPlace& place)
{
    const auto& bend = place.measures.curvature;
    return (bend ? std::max(std::abs(bend->largest), std::abs(bend->smallest)) : 0) +
           (place.size > 0 ? kFlat / place.size : 0);
}

QString radiusText(const ProbedPlace& place, double curvature)
{
    if (std::abs(curvature) <= kRounding * curvatureScale(place) || !std::isfinite(1 / curvature))
        return QObject::tr("flat");
    return measureFigure(1 / std::abs(curvature));
}

QString probeSentence(const ProbedPlace& place, const QString& units)
{
    const QString name = place.object.empty() ? QObject::tr("Surface") : QString::fromStdString(place.object);
    QString text = QObject::tr("%1 at u = %2, v = %3: %4 %5")
                       .arg(name, measureFigure(place.u), measureFigure(place.v),
                            vectorText(place.measures.position, place.size), units);
    if (const auto& bend = place.measures.curvature)
        text += QObject::tr("; radii %1 and %2")
                    .arg(radiusText(place, bend->largest), radiusText(place, bend->smallest));
    return text + QObject::tr(". Click to pin.");
}

}  // namespace knotspan
