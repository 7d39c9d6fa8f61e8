// The edges where surfaces meet, and naked ones, as a table: what is equal to before stays as it is, so that
// a selection and a scroll position outlast an edit.
#pragma once

#include <QAbstractTableModel>
#include <QCollator>
#include <QSortFilterProxyModel>

#include "model/document/document_friends.h"

namespace knotspan {

// For people: three digits, and 0 for what is nothing but rounding.
[[nodiscard]] QString friendFigure(double value, double noise);

class FriendsTable : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { edgeA, edgeB, verdict, gap, angle, curvature, columns };

    // The friends outlive the table. It is empty until it takes over what they say.
    explicit FriendsTable(DocumentFriends& friends, QObject* parent = nullptr);
    void takeOver();

    // Rows are numbered as in ShownFriends: edges, then naked ones.
    struct Row {
        std::optional<FriendEdge> meeting;  // none: naked
        EdgePart a;
        QString nameA;  // "u start, Face 28": the side first
        QString nameB;
        QString orderA;  // the same, the object first: what is sorted by
        QString orderB;
        [[nodiscard]] bool operator==(const Row&) const = default;
        [[nodiscard]] bool isProblem() const { return meeting && !meeting->areFriends(); }
    };
    [[nodiscard]] const Row& row(int number) const { return rows_[static_cast<size_t>(number)]; }
    [[nodiscard]] QString verdictText(int number) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString text(const Row& row, int column) const;
    [[nodiscard]] QString toolTip(const Row& row) const;

    DocumentFriends& friends_;
    std::vector<Row> rows_;
    int revision_ = -1;
};

// Which of them are shown, in which order.
class FriendsFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    enum class Show { all, problems, naked, none, g0, g1, g2, undetermined };

    explicit FriendsFilter(FriendsTable& table, QObject* parent = nullptr);
    void show(Show what);
    void setText(const QString& text);  // in the names of the edges or the verdict

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    FriendsTable& table_;
    Show what_ = Show::all;
    QString text_;
    QCollator order_;  // of names: "Tube 2" before "Tube 10"
};

}  // namespace knotspan
