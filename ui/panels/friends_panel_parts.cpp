// What the friends panel is made of.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <QTableView>

#include "ui/panels/friends_panel.h"
#include "ui/viewport/friend_lines.h"

namespace knotspan {

namespace {

// Names keep their beginning, the side, and their end, which tells "Face 27" from "Face 28"; numbers keep
// their beginning.
class EdgeDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->textElideMode = index.column() < FriendsTable::verdict ? Qt::ElideMiddle : Qt::ElideRight;
    }
};

}  // namespace

QWidget* FriendsPanel::makeFilter()
{
    auto* row = new QWidget(this);
    which_ = new QComboBox(row);
    which_->setObjectName("friends-show");
    which_->setAccessibleName(tr("Which edges to list"));
    which_->setToolTip(tr("Which edges to list; problems are all that meet, but neither G1 nor G2"));
    const auto add = [&](const QString& text, FriendsFilter::Show what, std::optional<std::uint32_t> colour) {
        QPixmap swatch(12, 12);
        swatch.fill(colour ? QColor(*colour) : QColor(Qt::transparent));
        which_->addItem(colour ? QIcon(swatch) : QIcon(), text, static_cast<int>(what));
    };
    using Show = FriendsFilter::Show;
    add(tr("All"), Show::all, {});
    add(tr("Problems only"), Show::problems, {});
    add(tr("Naked"), Show::naked, nakedColour());
    add(tr("none"), Show::none, verdictColour(Continuity::none));
    add("G0", Show::g0, verdictColour(Continuity::g0));
    add("G1", Show::g1, verdictColour(Continuity::g1));
    add("G2", Show::g2, verdictColour(Continuity::g2));
    add(tr("undetermined"), Show::undetermined, verdictColour(Continuity::undetermined));
    text_ = new QLineEdit(row);
    text_->setObjectName("friends-filter");
    text_->setAccessibleName(tr("Text that listed edges have in their names"));
    text_->setPlaceholderText(tr("Filter"));
    text_->setToolTip(tr("List only edges whose name or verdict has this text"));
    text_->setClearButtonEnabled(true);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(which_);
    layout->addWidget(text_, 1);
    connect(which_, &QComboBox::currentIndexChanged, this, [this] {
        filter_->show(static_cast<FriendsFilter::Show>(which_->currentData().toInt()));
        showSummary();
        showChosen();
    });
    connect(text_, &QLineEdit::textChanged, this, [this](const QString& text) {
        filter_->setText(text);
        showSummary();
        showChosen();
    });
    return row;
}

QWidget* FriendsPanel::makeTolerances()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char* name, const QString& label, const QString& tip) {
        auto* box = new QDoubleSpinBox(row);
        box->setObjectName(name);
        box->setAccessibleName(tip);
        box->setToolTip(tip);
        box->setKeyboardTracking(false);
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        auto* shown = new QLabel(label, row);
        shown->setBuddy(box);
        shown->setToolTip(tip);
        layout->addWidget(shown);
        layout->addWidget(box, 1);
        return box;
    };
    const FriendTolerances now = shown_.friends().tolerances();
    gap_ = add("friends-gap", tr("&Gap"), tr("How far edges may be apart that meet, in the model's unit"));
    gap_->setDecimals(6);
    gap_->setRange(1e-6, 1e3);
    angle_ =
        add("friends-angle", tr("&Angle"), tr("How far tangent planes may differ where edges are smooth"));
    angle_->setDecimals(4);
    angle_->setRange(1e-4, 45);
    angle_->setSuffix(tr("°"));
    gap_->setValue(now.gap);
    angle_->setValue(now.angleDeg);
    for (const QDoubleSpinBox* box : {gap_, angle_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &FriendsPanel::changeTolerances);
    return row;
}

QWidget* FriendsPanel::makeTable()
{
    view_ = new QTableView(this);
    view_->setObjectName("friends");
    view_->setAccessibleName(tr("Edges where surfaces meet"));
    view_->setStatusTip(tr("Click to go to the worst point; arrows choose, Enter goes there"));
    view_->setModel(filter_);
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view_->setAlternatingRowColors(true);
    view_->setShowGrid(false);
    view_->setWordWrap(false);
    view_->setTabKeyNavigation(false);
    view_->setSortingEnabled(true);
    view_->sortByColumn(FriendsTable::verdict, Qt::AscendingOrder);
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    QHeaderView& header = *view_->horizontalHeader();
    header.setAccessibleName(tr("Columns; a click sorts"));
    header.setHighlightSections(false);
    const int digit = fontMetrics().horizontalAdvance('0');
    for (const auto& [column, digits] :
         {std::pair(FriendsTable::verdict, 9), std::pair(FriendsTable::gap, 8),
          std::pair(FriendsTable::angle, 7), std::pair(FriendsTable::curvature, 8)})
        header.resizeSection(column, digits * digit);
    header.setSectionResizeMode(FriendsTable::edgeA, QHeaderView::Stretch);
    header.setSectionResizeMode(FriendsTable::edgeB, QHeaderView::Stretch);
    view_->setItemDelegate(new EdgeDelegate(view_));
    connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &FriendsPanel::choose);
    const auto go = [this](const QModelIndex& index) { goTo(numberOf(index)); };
    connect(view_, &QTableView::clicked, this, go);
    connect(view_, &QTableView::activated, this, go);
    empty_ = new QLabel(this);
    empty_->setObjectName("friends-empty");
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setMargin(16);
    pages_ = new QStackedWidget(this);
    pages_->addWidget(view_);
    pages_->addWidget(empty_);
    return pages_;
}

QWidget* FriendsPanel::makeLegend()
{
    QStringList entries;
    const auto add = [&](const QString& text, std::uint32_t colour) {
        entries << QString("<span style='color:%1'>&#9632;</span>&nbsp;%2").arg(QColor(colour).name(), text);
    };
    add(tr("naked"), nakedColour());
    add(tr("none"), verdictColour(Continuity::none));
    add("G0", verdictColour(Continuity::g0));
    add("G1", verdictColour(Continuity::g1));
    add("G2", verdictColour(Continuity::g2));
    add(tr("undetermined"), verdictColour(Continuity::undetermined));
    auto* legend = new QLabel(entries.join("&nbsp;&nbsp; "), this);
    legend->setObjectName("friends-legend");
    legend->setTextFormat(Qt::RichText);
    legend->setWordWrap(true);
    legend->setAccessibleName(tr("Colours of the edges over the model"));
    legend->setToolTip(tr("Colours of the edges over the model: View > Friend edges"));
    return legend;
}

}  // namespace knotspan
