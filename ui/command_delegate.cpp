#include "ui/command_delegate.h"

#include <QApplication>
#include <QPainter>

#include "ui/command_model.h"

namespace knotspan {

namespace {

constexpr int kGap = 6;
constexpr double kTipSize = 0.88;

QFont tipFont(const QFont& font)
{
    QFont smaller = font;
    smaller.setPointSizeF(font.pointSizeF() * kTipSize);
    return smaller;
}

QColor mixed(const QColor& a, const QColor& b)
{
    return QColor::fromRgbF((a.redF() + b.redF()) / 2, (a.greenF() + b.greenF()) / 2,
                            (a.blueF() + b.blueF()) / 2);
}

// What a row is drawn with.
struct Inks {
    QColor text;
    QColor faint;
};

Inks inksOf(const QStyleOptionViewItem& option, bool isPossible)
{
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const QColor ink = option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
    const QColor ground = option.palette.color(selected ? QPalette::Highlight : QPalette::Base);
    const QColor faint = mixed(ink, ground);
    // A third of the way back to the text: the tip of what can be done stays easy to read.
    return isPossible ? Inks{ink, mixed(ink, faint)} : Inks{faint, faint};
}

void drawCheck(QPainter& painter, const QStyleOptionViewItem& option, const QRect& place, bool isOn)
{
    QStyleOptionViewItem box = option;
    box.rect = place;
    box.state.setFlag(QStyle::State_On, isOn);
    box.state.setFlag(QStyle::State_Off, !isOn);
    box.state.setFlag(QStyle::State_Selected, false);
    const QStyle* style = option.widget != nullptr ? option.widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_IndicatorItemViewItemCheck, &box, &painter, option.widget);
}

}  // namespace

void CommandDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const
{
    QStyleOptionViewItem row = option;
    initStyleOption(&row, index);
    const Inks inks = inksOf(row, index.data(CommandModel::kIsPossible).toBool());
    painter->save();
    painter->fillRect(
        row.rect,
        row.palette.color(row.state.testFlag(QStyle::State_Selected) ? QPalette::Highlight : QPalette::Base));
    const QFontMetrics letters(row.font);
    const int check = letters.height();
    QRect line = row.rect.adjusted(2 * kGap + check, kGap / 2, -kGap, 0);
    line.setHeight(letters.height());
    if (const QVariant state = index.data(Qt::CheckStateRole); state.isValid())
        drawCheck(*painter, row, {row.rect.left() + kGap, line.top(), check, check},
                  state.toInt() == Qt::Checked);

    painter->setFont(row.font);
    painter->setPen(inks.text);
    const QString keys = index.data(CommandModel::kKeys).toString();
    painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, keys);
    QRect left = line.adjusted(0, 0, -letters.horizontalAdvance(keys) - 2 * kGap, 0);
    const QString text = letters.elidedText(index.data().toString(), Qt::ElideRight, left.width());
    painter->drawText(left, Qt::AlignLeft | Qt::AlignVCenter, text);
    painter->setPen(inks.faint);
    left.setLeft(left.left() + letters.horizontalAdvance(text) + 2 * kGap);
    painter->drawText(left, Qt::AlignLeft | Qt::AlignVCenter, index.data(CommandModel::kMenu).toString());

    const QFont small = tipFont(row.font);
    const QFontMetrics smallLetters(small);
    painter->setFont(small);
    line.moveTop(line.bottom() + 1);
    painter->drawText(
        line, Qt::AlignLeft | Qt::AlignVCenter,
        smallLetters.elidedText(index.data(Qt::ToolTipRole).toString(), Qt::ElideRight, line.width()));
    painter->restore();
}

QSize CommandDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    return {200, 2 * QFontMetrics(option.font).height() + kGap};
}

}  // namespace knotspan
