#include "ui/panels/properties_view.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QClipboard>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "model/geometry/ksquad.h"
#include "ui/panels/following.h"
#include "ui/tools/probe_texts.h"
#include "ui/viewport/described.h"

namespace knotspan {

namespace {

constexpr int kProgressMs = 200;

QString figures(const Vec3& vector, const QString& units)
{
    return QString("%1 %2").arg(
        vectorText(vector, std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)})), units);
}

QString exact(double value)
{
    return QString::number(value, 'g', 15);
}

}  // namespace

PropertiesView::PropertiesView(Document& document, Selection& selection, QWidget* parent)
    : QGroupBox(tr("Selected objects"), parent),
      document_(document),
      selection_(selection),
      lines_(new QFormLayout(this))
{
    lines_->setRowWrapPolicy(QFormLayout::DontWrapRows);
    objects_ = addLine("properties-objects", tr("Objects"), tr("How many objects are selected"));
    degrees_ = addLine("properties-degrees", tr("Degrees"), tr("The degrees along u and v"));
    points_ = addLine("properties-points", tr("Control points"), tr("The control points along u and v"));
    ksquads_ = addLine("properties-ksquads", tr("KSQuads"), tr("The pieces between neighbouring knots"));
    low_ = addLine("properties-low", tr("Lowest corner"), tr("Of the box around the surfaces themselves"));
    high_ = addLine("properties-high", tr("Highest corner"), tr("Of the box around the surfaces themselves"));
    size_ = addLine("properties-size", tr("Size"), tr("The sides of that box"));
    area_ = addLine("properties-area", tr("Area"),
                    tr("The area of what trim loops leave of the surfaces, and how far off it may be"));
    copy_ = new QPushButton(tr("Cop&y"), this);
    describe(copy_, "copy-properties", tr("Copy the properties"),
             tr("Copy a line for each selected object, as a table that spreadsheets take"));
    lines_->addRow(copy_);
    connect(copy_, &QPushButton::clicked, this, &PropertiesView::copy);
    auto* following = new Following(*this, [this] { follow(); });
    connect(&selection_, &Selection::changed, following, &Following::soon);
    connect(&document_, &Document::sceneChanged, following, &Following::soon);
    progress_.setInterval(kProgressMs);
    connect(&progress_, &QTimer::timeout, this, &PropertiesView::show);
}

PropertiesView::~PropertiesView() = default;

QLabel* PropertiesView::addLine(const char* id, const QString& title, const QString& tip)
{
    auto* label = new QLabel(this);
    describe(label, id, title, tip);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    lines_->addRow(title, label);
    return label;
}

void PropertiesView::follow()
{
    MeasuredObjects wanted;
    for (const ObjectId id : selection_.objects())
        if (SharedObject object = document_.scene().find(id))
            wanted[id].surface = std::move(object);
    const Scene::Meshes& meshes = document_.scene().meshes();
    for (const ObjectId id : selection_.meshes())
        if (const auto mesh = meshes.find(id); mesh != meshes.end())
            wanted[id].mesh = mesh->second;
    if (wanted == wanted_ && !known_.empty())
        return;  // only what is hovered, perhaps
    const auto isSame = [](const auto& a, const auto& b) { return a.first == b.first; };
    const bool sameObjects = std::equal(wanted.begin(), wanted.end(), wanted_.begin(), wanted_.end(), isSame);
    wanted_ = std::move(wanted);
    std::erase_if(known_, [this](const auto& known) {
        const auto now = wanted_.find(known.first);
        return now == wanted_.end() || now->second != known.second.object;
    });
    measure();
    showCounts();
    if (!sameObjects || !thread_)
        showMeasured();  // otherwise the figures of a moment ago stay, for a moment
}

void PropertiesView::measure()
{
    if (thread_) {
        // What it has done is taken over where it is still wanted, and the rest begun anew.
        if (thread_->objects() != wanted_)
            thread_->requestInterruption();
        return;
    }
    MeasuredObjects missing;
    for (const auto& [id, object] : wanted_)
        if (known_.count(id) == 0)
            missing.emplace(id, object);
    if (missing.empty())
        return;
    thread_ = std::make_unique<PropertiesThread>(std::move(missing));
    connect(thread_.get(), &QThread::finished, this, &PropertiesView::takeResults);
    thread_->start(QThread::LowPriority);
    progress_.start();
}

void PropertiesView::takeResults()
{
    for (const auto& [id, properties] : thread_->done()) {
        const MeasuredObject& object = thread_->objects().at(id);
        if (const auto now = wanted_.find(id); now != wanted_.end() && now->second == object)
            known_[id] = {object, properties};
    }
    thread_.reset();
    progress_.stop();
    measure();
    show();
}

void PropertiesView::show()
{
    showCounts();
    showMeasured();
}

void PropertiesView::showCounts()
{
    size_t surfaces = 0;
    size_t points = 0;
    size_t ksquads = 0;
    size_t triangles = 0;
    std::set<std::pair<int, int>> degrees;
    std::string name;
    const NurbsSurface* only = nullptr;
    for (const auto& [id, object] : wanted_) {
        if (object.mesh) {
            triangles += object.mesh->mesh->triangles.size();
            name = object.mesh->name;
            continue;
        }
        only = &object.surface->surface;
        name = object.surface->name;
        ++surfaces;
        points += only->controlPoints().size();
        ksquads += ksQuadCount(*only);
        degrees.emplace(only->degreeU(), only->degreeV());
    }
    const auto pair = [](int u, int v) { return QString("%1 x %2").arg(u).arg(v); };
    objects_->setText(wanted_.empty()                        ? tr("none")
                      : wanted_.size() == 1 && !name.empty() ? QString::fromStdString(name)
                                                             : QString("%L1").arg(wanted_.size()));
    degrees_->setText(degrees.empty()      ? tr("-")
                      : degrees.size() > 1 ? tr("several")
                                           : pair(degrees.begin()->first, degrees.begin()->second));
    points_->setText(surfaces == 1  ? tr("%1 = %L2").arg(pair(only->countU(), only->countV())).arg(points)
                     : surfaces > 1 ? QString("%L1").arg(points)
                                    : tr("-"));
    QString pieces = surfaces > 0 ? QString("%L1").arg(ksquads) : tr("-");
    if (triangles > 0)
        pieces = surfaces > 0 ? tr("%1, and %L2 triangles").arg(pieces).arg(triangles)
                              : tr("none; %L1 triangles").arg(triangles);
    ksquads_->setText(pieces);
}

void PropertiesView::showMeasured()
{
    copy_->setEnabled(!wanted_.empty() && known_.size() == wanted_.size());
    if (wanted_.empty() || known_.size() < wanted_.size()) {
        const size_t done = known_.size() + (thread_ ? thread_->done().size() : 0);
        const QString text =
            wanted_.empty()
                ? tr("-")
                : tr("measuring: %L1 of %L2").arg(std::min(done, wanted_.size())).arg(wanted_.size());
        for (QLabel* label : {low_, high_, size_})
            label->setText(tr("-"));
        area_->setText(text);
        return;
    }
    Box box;
    Area area;
    for (const auto& [id, known] : known_) {
        box.add(known.properties.bounds);
        area.value += known.properties.area.value;
        area.error += known.properties.area.error;
    }
    const QString units = QString::fromStdString(document_.scene().units());
    low_->setText(box.isEmpty() ? tr("-") : figures(box.low, units));
    high_->setText(box.isEmpty() ? tr("-") : figures(box.high, units));
    size_->setText(box.isEmpty() ? tr("-") : figures(box.size(), units));
    area_->setText(tr("%1 %2² (± %3)")
                       .arg(QString::number(area.value, 'g', 9), units, QString::number(area.error, 'g', 1)));
}

void PropertiesView::copy() const
{
    const QString unit = QString::fromStdString(document_.scene().units());
    QStringList titles{tr("Object"),           tr("Degree u"),         tr("Degree v"),
                       tr("Control points u"), tr("Control points v"), tr("KSQuads")};
    for (const char* name : {"low x", "low y", "low z", "high x", "high y", "high z"})
        titles << QString("%1 (%2)").arg(name, unit);
    titles << QString("%1 (%2²)").arg(tr("Area"), unit) << QString("%1 (%2²)").arg(tr("Error"), unit);
    QStringList lines{titles.join('\t')};
    for (const auto& [id, known] : known_) {
        QStringList cells;
        if (const SharedObject& object = known.object.surface) {
            const NurbsSurface& surface = object->surface;
            cells << QString::fromStdString(object->name).simplified();
            for (const int count : {surface.degreeU(), surface.degreeV(), surface.countU(), surface.countV()})
                cells << QString::number(count);
            cells << QString::number(ksQuadCount(surface));
        } else {
            cells << QString::fromStdString(known.object.mesh->name).simplified();
            cells << QStringList(5, QString());
        }
        for (const Vec3& corner : {known.properties.bounds.low, known.properties.bounds.high})
            for (int axis = 0; axis < 3; ++axis)
                cells << exact(corner[axis]);
        cells << exact(known.properties.area.value) << QString::number(known.properties.area.error, 'g', 2);
        lines << cells.join('\t');
    }
    QApplication::clipboard()->setText(lines.join('\n') + '\n');
}

}  // namespace knotspan
