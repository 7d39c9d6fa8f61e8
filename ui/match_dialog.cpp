#include "ui/match_dialog.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHideEvent>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>

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
    if (x.edge.continuity != y.edge.continuity)
        return x.edge.continuity < y.edge.continuity;
    return x.edge.angleMaxDeg > y.edge.angleMaxDeg;
}

// Also after the model changed a little.
bool isSame(const ObjectEdge& x, const ObjectEdge& y)
{
    const bool sides =
        x.a == y.a && x.b == y.b && x.edge.a.side == y.edge.a.side && x.edge.b.side == y.edge.b.side;
    return sides && std::max(x.edge.a.from, y.edge.a.from) < std::min(x.edge.a.to, y.edge.a.to);
}

}  // namespace

MatchDialog::MatchDialog(Document& document, Selection& selection, QWidget* parent)
    : QDialog(parent),
      document_(document),
      selection_(selection)
{
    setWindowTitle(tr("Match edge"));
    setObjectName("match-dialog");
    makeLayout();
    wait_.setSingleShot(true);
    wait_.setInterval(kWaitMs);
    connect(&wait_, &QTimer::timeout, this, &MatchDialog::look);
    connect(&document_, &Document::sceneChanged, this, &MatchDialog::onSceneChanged);
    connect(&selection_, &Selection::changed, this, &MatchDialog::onSelectionChanged);
    connect(&document_, &Document::documentReplaced, this, [this] {
        gesture_ = 0;
        edge_.reset();
        chosenElsewhere_.reset();
        offeredFor_.clear();
        offered_.clear();
        fillEdges();
    });
    look();
}

MatchDialog::~MatchDialog()
{
    takePreviewBack();
}

void MatchDialog::hideEvent(QHideEvent* event)
{
    wait_.stop();
    takePreviewBack();
    if (!event->spontaneous())
        edge_.reset();  // the next time it is what is chosen then
    QDialog::hideEvent(event);
}

FriendTolerances MatchDialog::tolerances() const
{
    return {gap_->value(), angle_->value(), curvature_->value()};
}

void MatchDialog::setEdge(const std::optional<ObjectEdge>& edge)
{
    const bool isKnown = edge && chosenElsewhere_ && isSame(*edge, *chosenElsewhere_);
    chosenElsewhere_ = edge;
    if (!edge || (isKnown && edge_))
        return;
    takePreviewBack();
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
    takePreviewBack();
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
        edges_->addItem(
            QString("%1: %2").arg(QString::fromStdString(knotspan::describe(document_.scene(), edge)),
                                  QString(continuityName(edge.edge.continuity))));
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
}

void MatchDialog::nameSides()
{
    if (!edge_)
        return;
    const auto name = [&](ObjectId id, Side side) {
        return tr("%1, at its %2").arg(QString::fromStdString(nameOf(document_.scene(), id)), sideName(side));
    };
    move_->setItemText(0, name(edge_->a, edge_->edge.a.side));
    move_->setItemText(1, name(edge_->b, edge_->edge.b.side));
}

void MatchDialog::lookSoon()
{
    mayShow_ = true;
    done_.clear();
    wait_.start();
}

// The edge in the scene as it is now; as it was found where its sides have parted.
void MatchDialog::findAgain()
{
    FriendTolerances wide;
    wide.gap = std::max({wide.gap, gap_->value(), edge_->edge.gapMax});
    const bool isThere = document_.scene().find(edge_->a) && document_.scene().find(edge_->b);
    if (const auto now = foundAgain(document_.scene(), *edge_, wide); now && isThere)
        edge_ = now;
    isStale_ = false;
}

void MatchDialog::look()
{
    wait_.stop();
    takePreviewBack();
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
        lines << matchReport(scene, *edge_, *match);
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
    const QScopedValueRollback ours(isOurs_, true);
    gesture_ = document_.newGesture();
    document_.apply(match_->edit, tr("Match edge"), gesture_);
}

void MatchDialog::takePreviewBack()
{
    if (gesture_ == 0)
        return;
    const QScopedValueRollback ours(isOurs_, true);
    document_.cancelGesture(gesture_);
    gesture_ = 0;
}

void MatchDialog::apply()
{
    if (wait_.isActive())
        look();
    if (!match_ || match_->edit.isEmpty())
        return;
    {
        const QScopedValueRollback ours(isOurs_, true);
        if (gesture_ != 0)
            document_.finishGesture(gesture_);
        else
            document_.apply(match_->edit, tr("Match edge"));
    }
    gesture_ = 0;
    isStale_ = true;
    mayShow_ = false;
    done_ = tr("Done.");
    look();
}

void MatchDialog::onSceneChanged()
{
    if (isOurs_)
        return;
    gesture_ = 0;  // the document has made it a step, or undone it
    isStale_ = edge_.has_value();
    mayShow_ = false;
    done_.clear();
    if (isVisible())
        wait_.start();
}

}  // namespace knotspan
