#include "ui/panels/friends_panel.h"

#include <algorithm>
#include <array>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>

#include <glm/geometric.hpp>

#include "ui/panels/following.h"
#include "ui/panels/friend_graph.h"

namespace knotspan {

namespace {

constexpr int kGraphSamples = 97;

double lengthOf(const SceneObject& object, const EdgePart& part)
{
    constexpr int kSteps = 16;
    double length = 0;
    Vec3 last = pointOn(object, part, part.from);
    for (int k = 1; k <= kSteps; ++k) {
        const Vec3 next = pointOn(object, part, part.from + (part.to - part.from) * k / kSteps);
        length += glm::length(next - last);
        last = next;
    }
    return length;
}

}  // namespace

FriendsPanel::FriendsPanel(Document& document, ShownFriends& shown, Viewport& viewport, QWidget* parent)
    : QWidget(parent),
      document_(document),
      shown_(shown),
      viewport_(viewport),
      table_(new FriendsTable(shown.friends(), this)),
      filter_(new FriendsFilter(*table_, this))
{
    setObjectName("friends-panel");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    summary_ = new QLabel(this);
    summary_->setObjectName("friends-summary");
    summary_->setAccessibleName(tr("Summary of the edges"));
    summary_->setWordWrap(true);
    quantity_ = new QComboBox(this);
    quantity_->setObjectName("friends-quantity");
    quantity_->addItems({tr("Angle along the selected edge"), tr("Gap along the selected edge")});
    quantity_->setAccessibleName(tr("What the graph shows"));
    quantity_->setToolTip(tr("What the graph below shows of the selected edge"));
    graph_ = new FriendGraph(this);
    column->addWidget(makeFilter());
    column->addWidget(makeTable(), 3);
    column->addWidget(summary_);
    column->addWidget(makeLegend());
    column->addWidget(makeTolerances());
    column->addWidget(quantity_);
    column->addWidget(graph_, 1);
    connect(quantity_, &QComboBox::currentIndexChanged, this, &FriendsPanel::showGraph);
    auto* following = new Following(*this, [this] { follow(); });
    connect(&shown_, &ShownFriends::changed, following, &Following::soon);
}

void FriendsPanel::follow()
{
    {
        const QScopedValueRollback<bool> guard(following_, true);
        table_->takeOver();
        const FriendTolerances& now = shown_.friends().tolerances();
        const QSignalBlocker quietGap(gap_);
        const QSignalBlocker quietAngle(angle_);
        gap_->setValue(now.gap);
        angle_->setValue(now.angleDeg);
        gap_->setSuffix(" " + QString::fromStdString(document_.scene().units()));
    }
    showSummary();
    showChosen();
    showGraph();
}

size_t FriendsPanel::numberOf(const QModelIndex& shown) const
{
    return static_cast<size_t>(filter_->mapToSource(shown).row());
}

void FriendsPanel::choose(const QModelIndex& shown)
{
    if (following_ || !shown.isValid())
        return;
    table_->takeOver();
    shown_.choose(numberOf(shown));
}

void FriendsPanel::showChosen()
{
    const QScopedValueRollback<bool> guard(following_, true);
    const auto number = shown_.chosen();
    const QModelIndex row =
        number ? filter_->mapFromSource(table_->index(static_cast<int>(*number), 0)) : QModelIndex();
    if (!row.isValid()) {
        view_->clearSelection();
        view_->setCurrentIndex({});
    } else if (row.row() != view_->currentIndex().row()) {
        view_->setCurrentIndex(row);
    }
}

void FriendsPanel::goTo(size_t number)
{
    const SceneFriends& now = shown_.friends().friends();
    const size_t edges = now.edges().size();
    if (number >= edges + now.nakedEdges().size())
        return;
    shown_.choose(number);
    const EdgePart& part = number < edges ? now.edges()[number].a : now.nakedEdges()[number - edges];
    const double worst = number < edges ? now.edges()[number].worst : (part.from + part.to) / 2;
    const SceneObject& object = *now.object(part.surface);
    const Vec3 point = pointOn(object, part, worst);
    Vec3 outward = normalOn(object, part, worst);
    if (glm::dot(outward, point - document_.scene().bounds().centre()) < 0)
        outward = -outward;
    viewport_.zoomTo(point, std::max(0.3 * lengthOf(object, part), 1e-6), outward);
}

QString FriendsPanel::instead() const
{
    if (document_.scene().bounds().isEmpty())
        return tr("There is nothing to look at. Open a model, or show one of its objects.");
    if (table_->rowCount() == 0)
        return tr("No surface here has an edge that meets another one or lies bare.");
    return tr("No edge passes the filter. Choose All and clear the text to see %1.")
        .arg(table_->rowCount() == 1 ? tr("the one there is") : tr("all %L1").arg(table_->rowCount()));
}

void FriendsPanel::showSummary()
{
    const bool any = filter_->rowCount() > 0;
    pages_->setCurrentIndex(any ? 0 : 1);
    if (!any)
        empty_->setText(instead());
    std::array<int, 5> counts{};
    int naked = 0;
    for (int k = 0; k < table_->rowCount(); ++k) {
        if (const auto& meeting = table_->row(k).meeting)
            ++counts[static_cast<size_t>(meeting->continuity)];
        else
            ++naked;
    }
    QStringList parts;
    for (const Continuity continuity :
         {Continuity::g2, Continuity::g1, Continuity::g0, Continuity::none, Continuity::undetermined})
        if (const int count = counts[static_cast<size_t>(continuity)]; count > 0)
            parts << tr("%L1 %2").arg(count).arg(QString::fromLatin1(continuityName(continuity)));
    const int all = table_->rowCount() - naked;
    QString text = all == 1 ? tr("1 edge meets another") : tr("%L1 edges meet").arg(all);
    if (all > 0)
        text = tr("%1: %2").arg(text, parts.join(", "));
    if (naked > 0)
        text = tr("%1; %L2 naked").arg(text).arg(naked);
    summary_->setText(text);
}

void FriendsPanel::showGraph()
{
    const auto number = shown_.chosen();
    const SceneFriends& now = shown_.friends().friends();
    if (!number || *number >= now.edges().size()) {
        graph_->setContent({}, number ? tr("This edge is naked: no other edge runs along it.")
                                      : tr("Select an edge in the table to see how it fares along its way."));
        return;
    }
    const FriendEdge& edge = now.edges()[*number];
    FriendGraph::Content content;
    content.quantity =
        quantity_->currentIndex() == 0 ? FriendGraph::Quantity::angle : FriendGraph::Quantity::gap;
    content.samples =
        edgeProfile(*now.object(edge.a.surface), *now.object(edge.b.surface), edge, kGraphSamples);
    content.tolerance = quantity_->currentIndex() == 0 ? now.tolerances().angleDeg : now.tolerances().gap;
    content.worst = edge.worst;
    const FriendsTable::Row& row = table_->row(static_cast<int>(*number));
    content.title = tr("%1 and %2").arg(row.nameA, row.nameB);
    graph_->setContent(std::move(content), {});
}

void FriendsPanel::changeTolerances()
{
    FriendTolerances wanted = shown_.friends().tolerances();
    wanted.gap = gap_->value();
    wanted.angleDeg = angle_->value();
    shown_.friends().setTolerances(wanted);
}

}  // namespace knotspan
