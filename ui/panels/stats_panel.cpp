#include "ui/panels/stats_panel.h"

#include <QHeaderView>
#include <QStyledItemDelegate>

namespace knotspan {

namespace {

// Not by a style sheet: it would keep the colours of the palette that it was made under.
class RoomyRows : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        return QStyledItemDelegate::sizeHint(option, index) + QSize(12, 4);
    }
};

}  // namespace

StatsPanel::StatsPanel(QWidget* parent) : QTreeWidget(parent)
{
    setObjectName("stats");
    setAccessibleName(tr("Statistics of the last frame"));
    setColumnCount(2);
    setHeaderHidden(true);
    setRootIsDecorated(false);
    setAlternatingRowColors(true);
    setUniformRowHeights(true);
    setSelectionMode(QAbstractItemView::NoSelection);
    setFocusPolicy(Qt::TabFocus);
    setFrameShape(QFrame::NoFrame);
    setItemDelegate(new RoomyRows(this));
    setStatusTip(tr("What the last frame cost and did"));
    for (const StatField& field : statFields()) {
        auto* row = new QTreeWidgetItem(this, {QString::fromStdString(field.label), QString()});
        row->setToolTip(0, tr("\"%1\" in the output of --stats").arg(QString::fromStdString(field.name)));
    }
    header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    header()->setStretchLastSection(true);
}

void StatsPanel::setStats(const FrameStats& stats)
{
    int row = 0;
    for (const StatField& field : statFields()) {
        QTreeWidgetItem* item = topLevelItem(row++);
        QString value = QString::fromStdString(display(field, stats));
        if (field.name == "culling" && stats.cullingFrozen)
            value = tr("frozen: %1").arg(value);
        if (item->text(1) == value)
            continue;
        item->setText(1, value);
        item->setToolTip(1, value);
    }
}

QString StatsPanel::shown(std::string_view fieldName) const
{
    int row = 0;
    for (const StatField& field : statFields()) {
        if (field.name == fieldName)
            return topLevelItem(row)->text(1);
        ++row;
    }
    return {};
}

}  // namespace knotspan
