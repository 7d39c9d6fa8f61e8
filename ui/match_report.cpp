#include "ui/match_report.h"

#include <QCoreApplication>
#include <QStringList>

#include "model/matching/neighbours.h"
#include "ui/panels/friends_table.h"

namespace knotspan {

namespace {

struct Report {
    Q_DECLARE_TR_FUNCTIONS(knotspan::MatchReport)
};

constexpr double kNoLength = 1e-9;
constexpr double kNoAngle = 1e-7;  // degrees
constexpr double kNoPart = 1e-9;

QString length(double value, const Scene& scene)
{
    return friendFigure(value, kNoLength) + " " + QString::fromStdString(scene.units());
}

QString net(const NurbsSurface& surface)
{
    return QString("%1 × %2").arg(surface.countU()).arg(surface.countV());
}

QString rowsOf(const MatchedSurface& matched)
{
    const QString along = matched.across == Direction::U ? "u" : "v";
    return matched.firstRow == matched.lastRow
               ? Report::tr("row %1 of the control points along %2").arg(matched.firstRow + 1).arg(along)
               : Report::tr("rows %1 to %2 of the control points along %3")
                     .arg(matched.firstRow + 1)
                     .arg(matched.lastRow + 1)
                     .arg(along);
}

QString sideReport(const Scene& scene, ObjectId id, const MatchedSurface& matched)
{
    const QString name = QString::fromStdString(nameOf(scene, id));
    const NurbsSurface& before = scene.find(id)->surface;
    QStringList parts;
    if (matched.lastRow < matched.firstRow)
        parts << Report::tr("Nothing of %1 has to move.").arg(name);
    else
        parts << Report::tr("%1 moves by %2 at most (certainly no more than %3): %4.")
                     .arg(name, length(matched.moved, scene), length(matched.movedMost, scene),
                          rowsOf(matched));
    const auto count = [](const NurbsSurface& surface) { return surface.countU() * surface.countV(); };
    if (const int more = count(matched.surface) - count(before); more > 0)
        parts << Report::tr("It gets %1 more control points, %2 in place of %3.")
                     .arg(more)
                     .arg(net(matched.surface), net(before));
    return parts.join(' ');
}

// The first three, and how many more there are.
QString firstOf(const QStringList& list)
{
    constexpr qsizetype kShown = 3;
    QString text = list.mid(0, kShown).join("; ");
    if (const qsizetype more = list.size() - kShown; more > 0)
        text += Report::tr("; and %1 more").arg(more);
    return text;
}

}  // namespace

QString effectsReport(const Scene& scene, const SideEffects& effects)
{
    const auto name = [&](ObjectId id) { return QString::fromStdString(nameOf(scene, id)); };
    const auto side = [&](ObjectId id, const EdgePart& part) {
        return Report::tr("%1 of %2").arg(QString::fromStdString(edgeName(part)), name(id));
    };
    QStringList worse;
    for (const SideEffects::Worse& one : effects.worse)
        worse << Report::tr("%1 with %2: %3 to %4")
                     .arg(side(one.edge.a, one.edge.edge.a), name(one.edge.b),
                          continuityName(one.edge.edge.continuity),
                          one.after ? QString(continuityName(*one.after)) : Report::tr("naked"));
    QStringList naked;
    for (const SideEffects::Naked& one : effects.naked)
        naked << side(one.object, one.part);
    naked.removeDuplicates();
    QStringList lines;
    if (!worse.isEmpty())
        lines << Report::tr("Also changes: %1.").arg(firstOf(worse));
    if (!naked.isEmpty())
        lines << Report::tr("Becomes naked, at least in part: %1.").arg(firstOf(naked));
    return lines.join('\n');
}

QString edgeReport(const Scene& scene, const ObjectEdge& edge)
{
    const QString verdict = continuityName(edge.edge.continuity);
    const QString gap = length(edge.edge.gapMax, scene);
    if (edge.edge.continuity == Continuity::none)
        return Report::tr("Now: apart, gap %1.").arg(gap);
    return Report::tr("Now: %1, largest angle %2°, gap %3.")
        .arg(verdict, friendFigure(edge.edge.angleMaxDeg, kNoAngle), gap);
}

QString matchReport(const Scene& scene, const ObjectEdge& edge, const SceneMatch& match)
{
    const MatchProposal& proposal = match.proposal;
    QStringList lines{
        Report::tr("Then: largest angle %1°, gap %2, curvatures differ by %3 % (%4 per %5) at most.")
            .arg(friendFigure(proposal.angleDeg, kNoAngle), length(proposal.gap, scene),
                 friendFigure(100 * proposal.curvaturePart, kNoPart),
                 friendFigure(proposal.curvature, kNoPart), QString::fromStdString(scene.units()))};
    if (proposal.a)
        lines << sideReport(scene, edge.a, *proposal.a);
    if (proposal.b)
        lines << sideReport(scene, edge.b, *proposal.b);
    return lines.join('\n');
}

}  // namespace knotspan
