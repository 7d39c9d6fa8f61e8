// Draws a row of CommandModel: a check, the text with its menu, the keys, and the tip below.
#pragma once

#include <QStyledItemDelegate>

namespace knotspan {

class CommandDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace knotspan
