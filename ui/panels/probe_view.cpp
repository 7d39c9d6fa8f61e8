#include "ui/panels/probe_view.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/panels/following.h"
#include "ui/panels/probe_distances.h"
#include "ui/tools/probe_texts.h"
#include "ui/viewport/described.h"

namespace knotspan {

namespace {

// As many lines whatever there is to say, so that nothing below moves under the hand.
QString readoutOf(const ProbedPlace& place, const QString& units)
{
    const PlaceMeasures& at = place.measures;
    QStringList lines;
    lines << QObject::tr("%1 at u = %2, v = %3")
                 .arg(place.object.empty() ? QObject::tr("Surface") : QString::fromStdString(place.object),
                      measureFigure(place.u), measureFigure(place.v));
    lines << QObject::tr("Position %1 %2").arg(vectorText(at.position, place.size), units);
    lines << (at.normal ? QObject::tr("Normal %1").arg(vectorText(*at.normal, 1))
                        : QObject::tr("It has no normal there"));
    if (!at.curvature) {
        lines << QObject::tr("It has no curvature there") << QString() << QString();
        return lines.join('\n');
    }
    const double scale = curvatureScale(place);
    const auto k = [&](double value) { return measureFigure(value, scale); };
    const Curvature& bend = *at.curvature;
    lines << QObject::tr("k1 %1, radius %2 %3").arg(k(bend.largest), radiusText(place, bend.largest), units);
    lines
        << QObject::tr("k2 %1, radius %2 %3").arg(k(bend.smallest), radiusText(place, bend.smallest), units);
    lines << QObject::tr("Gauss %1, mean %2").arg(measureFigure(bend.gauss, scale * scale), k(bend.mean));
    return lines.join('\n');
}

}  // namespace

ProbeView::ProbeView(Document& document, Probes& probes, QWidget* parent)
    : QGroupBox(tr("Probes"), parent),
      document_(document),
      probes_(probes),
      table_(new ProbeTable(document, probes, this))
{
    auto* column = new QVBoxLayout(this);
    readout_ = new QLabel(this);
    describe(readout_, "probe-readout", tr("Measures of the place under the cursor"),
             tr("The place under the cursor, while the tool Probe is in use; otherwise the selected probe"));
    readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    readout_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    readout_->setWordWrap(false);
    readout_->setMinimumWidth(0);
    readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    readout_->setMinimumHeight(6 * fontMetrics().lineSpacing() + 2);
    column->addWidget(readout_);
    makeTable();
    column->addWidget(view_, 1);
    distances_ = new QLabel(this);
    describe(distances_, "probe-distances", tr("Distances and angles between probes"),
             tr("Between the selected probes; with fewer than two, between the last two"));
    distances_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    distances_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    distances_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    distances_->setMinimumHeight(3 * fontMetrics().lineSpacing() + 2);
    column->addWidget(distances_);
    column->addWidget(makeButtons());
    auto* following = new Following(*this, [this] { follow(); });
    connect(&probes_, &Probes::changed, following, &Following::soon);
    connect(&document_, &Document::sceneChanged, following, &Following::soon);
}

void ProbeView::makeTable()
{
    view_ = new QTableView(this);
    describe(view_, "probes", tr("Pinned probes"),
             tr("Pinned probes: select two for the distance between them, three for an angle"));
    view_->setModel(table_);
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view_->setAlternatingRowColors(true);
    view_->setShowGrid(false);
    view_->setWordWrap(false);
    view_->setTabKeyNavigation(false);
    view_->setMinimumHeight(7 * fontMetrics().height());
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    view_->horizontalHeader()->setHighlightSections(false);
    view_->horizontalHeader()->setDefaultSectionSize(fontMetrics().horizontalAdvance("-0.0000000") + 12);
    view_->setColumnWidth(ProbeTable::number, fontMetrics().horizontalAdvance(tr("Probe")) + 16);
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ProbeView::showSelection);
    connect(table_, &QAbstractItemModel::modelReset, this, &ProbeView::showSelection);
    const auto key = [this](const QKeySequence& keys, auto act) {
        auto* shortcut = new QShortcut(keys, view_);
        shortcut->setContext(Qt::WidgetShortcut);
        connect(shortcut, &QShortcut::activated, this, act);
    };
    key(QKeySequence::Copy, &ProbeView::copy);
    key(QKeySequence::Delete, &ProbeView::removeSelected);
}

QWidget* ProbeView::makeButtons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char* id, const QString& text, const QString& tip) {
        auto* button = new QPushButton(text, row);
        describe(button, id, tip, tip);
        layout->addWidget(button);
        return button;
    };
    copy_ = add("copy-probes", tr("&Copy"),
                tr("Copy the selected probes, or all, as a table that spreadsheets take"));
    remove_ = add("remove-probes", tr("&Remove"), tr("Remove the selected probes"));
    clear_ = add("clear-probes", tr("C&lear"), tr("Remove all probes"));
    layout->addStretch();
    connect(copy_, &QPushButton::clicked, this, &ProbeView::copy);
    connect(remove_, &QPushButton::clicked, this, &ProbeView::removeSelected);
    connect(clear_, &QPushButton::clicked, &probes_, &Probes::clear);
    return row;
}

void ProbeView::follow()
{
    const std::vector<int> before = selectedRows();
    std::set<int> chosen;
    for (const int row : before)
        chosen.insert(table_->row(row).number);
    table_->takeOver();
    if (selectedRows().empty() && !chosen.empty()) {
        QItemSelection again;
        for (int row = 0; row < table_->rowCount(); ++row)
            if (chosen.count(table_->row(row).number) != 0)
                again.select(table_->index(row, 0), table_->index(row, ProbeTable::columns - 1));
        view_->selectionModel()->select(again, QItemSelectionModel::ClearAndSelect);
    }
    showSelection();
}

std::vector<int> ProbeView::selectedRows() const
{
    std::vector<int> rows;
    for (const QModelIndex& index : view_->selectionModel()->selectedRows())
        rows.push_back(index.row());
    std::sort(rows.begin(), rows.end());
    return rows;
}

void ProbeView::showSelection()
{
    const std::vector<int> rows = selectedRows();
    copy_->setEnabled(table_->rowCount() > 0);
    remove_->setEnabled(!rows.empty());
    clear_->setEnabled(table_->rowCount() > 0);
    const QString units = QString::fromStdString(document_.scene().units());
    std::optional<ProbedPlace> place;
    if (probes_.live())
        place = probed(document_.scene(), *probes_.live());
    else if (table_->rowCount() > 0)
        place = table_->row(rows.empty() ? table_->rowCount() - 1 : rows.back()).place;
    showDistances(rows);
    readout_->setText(place ? readoutOf(*place, units)
                            : tr("Take the tool Probe (O), point at a surface,\nand click to pin a probe."));
}

void ProbeView::showDistances(const std::vector<int>& selected)
{
    std::vector<ProbeTable::Row> rows;
    if (selected.size() >= 2)
        for (const int row : selected)
            rows.push_back(table_->row(row));
    else
        for (int row = std::max(0, table_->rowCount() - 2); row < table_->rowCount(); ++row)
            rows.push_back(table_->row(row));
    const QString text = distancesText(rows, QString::fromStdString(document_.scene().units()));
    distances_->setText(text.isEmpty() ? tr("Two pinned probes have a distance, three an angle.") : text);
}

void ProbeView::copy() const
{
    std::vector<int> rows = selectedRows();
    if (rows.empty())
        for (int row = 0; row < table_->rowCount(); ++row)
            rows.push_back(row);
    if (!rows.empty())
        QApplication::clipboard()->setText(table_->tabSeparated(rows));
}

void ProbeView::removeSelected()
{
    std::set<int> numbers;
    for (const int row : selectedRows())
        numbers.insert(table_->row(row).number);
    probes_.unpin(numbers);
}

}  // namespace knotspan
