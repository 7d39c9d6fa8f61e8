#include "ui/panels/probe_distances.h"

#include <QCoreApplication>

#include "ui/tools/probe_texts.h"

namespace knotspan {

namespace {

QString say(const char* text)
{
    return QCoreApplication::translate("knotspan::ProbeView", text);
}

QString apart(const ProbeTable::Row& from, const ProbeTable::Row& to, const QString& units)
{
    const Separation between = separation(from.place.measures, to.place.measures);
    return say("%1 to %2: %3 %4").arg(from.number).arg(to.number).arg(measureFigure(between.distance), units);
}

QString parts(const ProbeTable::Row& from, const ProbeTable::Row& to, const QString& units)
{
    const Separation between = separation(from.place.measures, to.place.measures);
    const double scale = std::max(from.place.size, to.place.size);
    QString text =
        say("dx %1, dy %2, dz %3 %4")
            .arg(measureFigure(between.difference.x, scale), measureFigure(between.difference.y, scale),
                 measureFigure(between.difference.z, scale), units);
    if (between.normalsDeg)
        text += '\n' + say("Angle between the normals %1°").arg(measureFigure(*between.normalsDeg, 1e5));
    return text;
}

}  // namespace

QString distancesText(const std::vector<ProbeTable::Row>& rows, const QString& units)
{
    if (rows.size() < 2)
        return {};
    if (rows.size() == 2)
        return apart(rows[0], rows[1], units) + '\n' + parts(rows[0], rows[1], units);
    if (rows.size() == 3) {
        const auto angle = angleAtDeg(rows[1].place.measures.position, rows[0].place.measures.position,
                                      rows[2].place.measures.position);
        return apart(rows[0], rows[1], units) + '\n' + apart(rows[1], rows[2], units) + '\n' +
               say("Angle at %1: %2")
                   .arg(rows[1].number)
                   .arg(angle ? measureFigure(*angle, 1e5) + QString::fromUtf8("°") : say("none"));
    }
    double length = 0;
    for (size_t k = 1; k < rows.size(); ++k)
        length += separation(rows[k - 1].place.measures, rows[k].place.measures).distance;
    return say("Through these %1 probes: %2 %3").arg(rows.size()).arg(measureFigure(length), units);
}

}  // namespace knotspan
