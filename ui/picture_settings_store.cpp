#include "ui/picture_settings_store.h"

#include <glm/geometric.hpp>

#include "ui/stored_values.h"

namespace knotspan {

namespace {

constexpr double kFinestPx = 0.01;
constexpr double kCoarsestPx = 1000;
constexpr double kLargest = 1e9;

// By its name in a list.
template <class Info, class Id>
void readChoice(const QSettings& stored, const char* key, const std::vector<Info>& list, Id& to)
{
    const std::string name = stored.value(key).toString().toStdString();
    for (const Info& info : list)
        if (info.name == name)
            to = info.id;
}

template <class Info, class Id>
void writeChoice(QSettings& stored, const char* key, const std::vector<Info>& list, Id id)
{
    for (const Info& info : list)
        if (info.id == id)
            stored.setValue(key, QString::fromStdString(info.name));
}

void readRange(const QSettings& stored, const QString& key, std::optional<NumberRange>& to)
{
    const double low = numberIn(stored, (key + "/low").toUtf8(), kLargest, -kLargest, kLargest);
    const double high = numberIn(stored, (key + "/high").toUtf8(), -kLargest, -kLargest, kLargest);
    if (low < high)
        to = NumberRange{low, high};
}

void writeRange(QSettings& stored, const QString& key, const std::optional<NumberRange>& range)
{
    stored.remove(key);
    if (!range)
        return;
    stored.setValue(key + "/low", range->low);
    stored.setValue(key + "/high", range->high);
}

int wholeIn(const QSettings& stored, const char* key, int otherwise, int least, int most)
{
    return static_cast<int>(numberIn(stored, key, otherwise, least, most));
}

void readLook(const QSettings& stored, Look& look)
{
    look.stripes = wholeIn(stored, "look/stripes", look.stripes, 1, kMostStripes);
    look.stripesTurnedDegrees = numberIn(stored, "look/stripesTurned", look.stripesTurnedDegrees, -360, 360);
    readChoice(stored, "look/matcap", matcaps(), look.matcap);
    readChoice(stored, "look/curvature", curvatureKinds(), look.curvature);
    readRange(stored, "look/curvatureRange", look.curvatureRange);
    readRange(stored, "look/deviationRange", look.deviationRange);
    readChoice(stored, "look/checker", checkers(), look.checker);
    look.checkerCells = wholeIn(stored, "look/squares", look.checkerCells, 1, kMostCheckerCells);
    if (const double length = numberIn(stored, "look/squareLength", 0, 0, kLargest); length > 0)
        look.checkerLength = length;
    Vec3 pull(0);
    for (int axis = 0; axis < 3; ++axis)
        pull[axis] = numberIn(stored, QString("look/pull/%1").arg(axis).toUtf8(), 0, -kLargest, kLargest);
    if (glm::length(pull) > 0)
        look.pull = pull;
    look.draftDegrees = numberIn(stored, "look/draft", look.draftDegrees, 0.001, 90);
}

void writeLook(QSettings& stored, const Look& look)
{
    stored.setValue("look/stripes", look.stripes);
    stored.setValue("look/stripesTurned", look.stripesTurnedDegrees);
    writeChoice(stored, "look/matcap", matcaps(), look.matcap);
    writeChoice(stored, "look/curvature", curvatureKinds(), look.curvature);
    writeRange(stored, "look/curvatureRange", look.curvatureRange);
    writeRange(stored, "look/deviationRange", look.deviationRange);
    writeChoice(stored, "look/checker", checkers(), look.checker);
    stored.setValue("look/squares", look.checkerCells);
    stored.setValue("look/squareLength", look.checkerLength.value_or(0));
    for (int axis = 0; axis < 3; ++axis)
        stored.setValue(QString("look/pull/%1").arg(axis), look.pull[axis]);
    stored.setValue("look/draft", look.draftDegrees);
}

QString textOf(CullSet set)
{
    QStringList list;
    for (const std::string& name : names(set))
        list << QString::fromStdString(name);
    return list.join(',');
}

}  // namespace

void restorePicture(Viewport& viewport)
{
    const QSettings stored;
    Frame frame = viewport.frame();
    readLook(stored, frame.look);
    frame.tolerancePx = numberIn(stored, "tolerance", frame.tolerancePx, kFinestPx, kCoarsestPx);
    frame.smoothEdges = stored.value("smoothEdges", frame.smoothEdges).toBool();
    if (const auto culling = parseCullSet(stored.value("culling").toString().toStdString()))
        frame.culling = *culling;
    viewport.setFrame(frame);
    CombSettings combs = viewport.combs().settings();
    combs.curves = wholeIn(stored, "combs/curves", combs.curves, 1, kMostCombCurves);
    combs.longestPercent = numberIn(stored, "combs/longest", combs.longestPercent, 0.1, 200);
    viewport.combs().setSettings(combs);
    SectionSettings section = viewport.section().settings();
    section.axis = wholeIn(stored, "section/axis", section.axis, 0, 2);
    viewport.section().setSettings(section);
}

void storePicture(Viewport& viewport)
{
    QSettings stored;
    const Frame& frame = viewport.frame();
    writeLook(stored, frame.look);
    stored.setValue("tolerance", frame.tolerancePx);
    stored.setValue("culling", textOf(frame.culling));
    stored.setValue("smoothEdges", frame.smoothEdges);
    stored.setValue("combs/curves", viewport.combs().settings().curves);
    stored.setValue("combs/longest", viewport.combs().settings().longestPercent);
    stored.setValue("section/axis", viewport.section().settings().axis);
}

}  // namespace knotspan
