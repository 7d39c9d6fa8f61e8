#include "ui/viewport/ramp_reading.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/analysis/place_measures.h"
#include "model/geometry/ksquad.h"
#include "model/sculpting/surface_snapping.h"
#include "ui/tools/probe_texts.h"

namespace knotspan {

namespace {

// Which of the spans has the parameter, and where in it.
std::pair<size_t, double> spanAt(const KnotVector& knots, double parameter)
{
    const std::vector<int> spans = knots.spans();
    size_t k = 0;
    while (k + 1 < spans.size() && parameter >= knots[spans[k + 1]])
        ++k;
    const int span = spans[k];
    return {k, (parameter - knots[span]) / (knots[span + 1] - knots[span])};
}

std::optional<double> deviationAt(const SharedSurfaceNumbers& numbers, const NurbsSurface& surface,
                                  const SurfacePlace& place)
{
    if (!numbers)
        return std::nullopt;
    const auto found = numbers->find(place.object);
    if (found == numbers->end() || found->second.cells.size() != ksQuadCount(surface))
        return std::nullopt;
    const auto [u, atU] = spanAt(surface.knotsU(), place.u);
    const auto [v, atV] = spanAt(surface.knotsV(), place.v);
    return found->second.at(u * surface.knotsV().spans().size() + v, {atU, atV});
}

}  // namespace

bool showsNumbers(Shading shading)
{
    return shading == Shading::curvature || shading == Shading::draft || shading == Shading::deviation;
}

std::optional<double> rampNumber(const Scene& scene, const Frame& frame, const PickedPlace& picked)
{
    const SharedObject object = scene.find(picked.object);
    if (!object || !showsNumbers(frame.shading))
        return std::nullopt;
    const SurfacePlace place =
        nearestFrom(picked.object, *object, {picked.spanU, picked.spanV}, picked.position);
    if (frame.shading == Shading::deviation)
        return deviationAt(frame.deviations, object->surface, place);
    const PlaceMeasures measures = measuresAt(object->surface, object->transform, place.u, place.v);
    if (frame.shading == Shading::curvature)
        return measures.curvature ? std::optional(figure(*measures.curvature, frame.look.curvature))
                                  : std::nullopt;
    if (!measures.normal)
        return std::nullopt;
    const double rising = glm::dot(*measures.normal, glm::normalize(frame.look.pull));
    return glm::degrees(std::asin(std::clamp(rising, -1.0, 1.0)));
}

QString rampText(const Frame& frame, double number, const std::string& units)
{
    const QString unit = QString::fromStdString(units);
    const QString figure = measureFigure(number);
    if (frame.shading == Shading::draft)
        return QCoreApplication::translate("knotspan::Viewport", "Draft %1°").arg(figure);
    if (frame.shading == Shading::deviation)
        return QCoreApplication::translate("knotspan::Viewport", "Deviation %1 %2").arg(figure, unit);
    const bool isSquare = frame.look.curvature == CurvatureKind::gauss;
    return QCoreApplication::translate("knotspan::Viewport", "Curvature %1 /%2")
        .arg(figure, isSquare ? unit + QStringLiteral("²") : unit);
}

}  // namespace knotspan
