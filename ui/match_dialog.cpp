#include "ui/match_dialog.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHideEvent>
#include <QLabel>
#include <QPushButton>

#include "model/matching/neighbours.h"
#include "ui/match_report.h"

namespace knotspan {

namespace {

constexpr int kWaitMs = 120;  // for the hand that still turns a value

// Both objects selected first, then the least smooth.
bool comesBefore(const ObjectEdge& x, const ObjectEdge& y, const Selection& selection)
{
    const auto inside = [&](const ObjectEdge& edge) {
        return selection.contains(edge.a) && selection.contains(edge.b);
    };
    if (inside(x) != inside(y))
        return inside(x);
    const int rank = smoothnessRank(x.edge.continuity);
    if (const int other = smoothnessRank(y.edge.continuity); rank != other)
        return rank < other;
    return x.edge.angleMaxDeg > y.edge.angleMaxDeg;
}

// Also after the model changed a little.
bool isSame(const ObjectEdge& x, const ObjectEdge& y)
{
    return isSameEdge(x, y) && std::max(x.edge.a.from, y.edge.a.from) < std::min(x.edge.a.to, y.edge.a.to);
}

}  // namespace

MatchDialog::MatchDialog(Document& document, Selection& selection, QWidget* parent)
    : QDialog(parent),
      document_(document),
      selection_(selection),
      shown_(document, tr("Match edge"), this)
{
    setWindowTitle(tr("Match edge"));
    setObjectName("match-dialog");
    makeLayout();
    wait_.setSingleShot(true);
    wait_.setInterval(kWaitMs);
    connect(&wait_, &QTimer::timeout, this, &MatchDialog::look);
    connect(&shown_, &Preview::modelChanged, this, &MatchDialog::onModelChanged);
    connect(&selection_, &Selection::changed, this, &MatchDialog::onSelectionChanged);
    connect(&document_, &Document::documentReplaced, this, [this] {
        edge_.reset();
        offeredFor_.clear();
        offered_.clear();
        fillEdges();
    });
    look();
}

void MatchDialog::hideEvent(QHideEvent* event)
{
    wait_.stop();
    shown_.takeBack();
    if (!event->spontaneous()) {
        edge_.reset();  // the next time it is what is chosen then
        Q_EMIT edgeChanged();
    }
    QDialog::hideEvent(event);
}

FriendTolerances MatchDialog::tolerances() const
{
    return {gap_->value(), angle_->value(), curvature_->value() / 100};
}

void MatchDialog::setEdge(const std::optional<ObjectEdge>& edge)
{
    if (!edge || (edge_ && isSame(*edge, *edge_)))
        return;
    shown_.takeBack();
    const auto known = std::find_if(offered_.begin(), offered_.end(),
                                    [&](const ObjectEdge& other) { return isSame(other, *edge); });
    const auto row = static_cast<int>(known - offered_.begin());
    if (known == offered_.end())
        offered_.push_back(*edge);
    else
        *known = *edge;
    fillEdges();
    chooseEdge(row);
}

void MatchDialog::offerEdges()
{
    shown_.takeBack();
    FriendTolerances found;
    found.gap = std::max(found.gap, gap_->value());
    offeredFor_ = selection_.objects();
    offered_ = edgesOf(document_.scene(), offeredFor_, found);
    std::stable_sort(offered_.begin(), offered_.end(), [this](const ObjectEdge& x, const ObjectEdge& y) {
        return comesBefore(x, y, selection_);
    });
    fillEdges();
    chooseEdge(0);
}

void MatchDialog::onSelectionChanged()
{
    const bool isOfEdge = edge_ && (selection_.contains(edge_->a) || selection_.contains(edge_->b));
    if (!isVisible() || selection_.objects().empty() || selection_.objects() == offeredFor_ || isOfEdge)
        return;
    offerEdges();
}

void MatchDialog::fillEdges()
{
    edges_->clear();
    for (const ObjectEdge& edge : offered_)
        edges_->addItem(lineOf(edge));
    gap_->setSuffix(" " + QString::fromStdString(document_.scene().units()));
}

QString MatchDialog::lineOf(const ObjectEdge& edge) const
{
    return QString("%1: %2").arg(QString(continuityName(edge.edge.continuity)),
                                 QString::fromStdString(knotspan::describe(document_.scene(), edge)));
}

void MatchDialog::chooseEdge(int row)
{
    edge_.reset();
    if (row >= 0 && static_cast<size_t>(row) < offered_.size())
        edge_ = offered_[static_cast<size_t>(row)];
    isStale_ = edge_.has_value();  // it may have been found long ago
    edges_->setCurrentIndex(edge_ ? row : -1);
    nameSides();
    lookSoon();
    Q_EMIT edgeChanged();
}

void MatchDialog::nameSides()
{
    if (!edge_)
        return;
    const auto name = [&](ObjectId id, const EdgePart& edge) {
        return tr("%1, at its %2")
            .arg(QString::fromStdString(nameOf(document_.scene(), id)),
                 QString::fromStdString(edgeName(edge)));
    };
    move_->setItemText(0, name(edge_->a, edge_->edge.a));
    move_->setItemText(1, name(edge_->b, edge_->edge.b));
}

void MatchDialog::lookSoon()
{
    mayShow_ = true;
    done_.clear();
    wait_.start();
}

// The edges in the scene as it is now; as they were found where their sides have parted.
void MatchDialog::findAgain()
{
    FriendTolerances wide;
    wide.gap = std::max({wide.gap, gap_->value(), edge_->edge.gapMax});
    const auto now = foundAgain(document_.scene(), offered_, wide);
    for (size_t row = 0; row < now.size(); ++row) {
        if (!now[row])
            continue;
        offered_[row] = *now[row];
        edges_->setItemText(static_cast<int>(row), lineOf(*now[row]));
    }
    edge_ = offered_[static_cast<size_t>(edges_->currentIndex())];
    isStale_ = false;
}

void MatchDialog::look()
{
    wait_.stop();
    shown_.takeBack();
    match_.reset();
    apply_->setEnabled(false);
    if (!edge_) {
        details_->setText(offered_.empty()
                              ? tr("Select an object: the edges it shares are then offered here.")
                              : tr("Choose an edge."));
        return;
    }
    if (isStale_)
        findAgain();
    const Scene& scene = document_.scene();
    const auto wanted = static_cast<Continuity>(target_->currentData().toInt());
    const auto side = static_cast<MatchSides>(move_->currentData().toInt());
    auto match = matchInScene(scene, *edge_, wanted, side, tolerances());
    QStringList lines{done_};
    lines << edgeReport(scene, *edge_);
    if (match) {
        if (done_.isEmpty())  // else it would only repeat what is so now
            lines << matchReport(scene, *edge_, *match)
                  << effectsReport(scene, sideEffects(scene, *edge_, *match, tolerances()));
        match_ = *std::move(match);
        apply_->setEnabled(!match_->edit.isEmpty());
    } else {
        lines << QString::fromStdString(match.error().sentence());
    }
    lines.removeAll(QString());
    details_->setText(lines.join('\n'));
    showPreview();
}

void MatchDialog::showPreview()
{
    if (!match_ || match_->edit.isEmpty() || !preview_->isChecked() || !mayShow_ || !isVisible())
        return;
    shown_.show(match_->edit);
}

void MatchDialog::apply()
{
    if (wait_.isActive())
        look();
    if (!match_ || match_->edit.isEmpty())
        return;
    shown_.apply(match_->edit);
    isStale_ = true;
    mayShow_ = false;
    done_ = tr("Done.");
    look();
}

void MatchDialog::onModelChanged()
{
    isStale_ = edge_.has_value();
    mayShow_ = false;
    done_.clear();
    if (isVisible())
        wait_.start();
}

}  // namespace knotspan
