// Commands in rows, as they are at the moment: greyed, checked, with the keys that count.
#pragma once

#include <QAbstractListModel>
#include <QAction>

namespace knotspan {

class CommandModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role { kMenu = Qt::UserRole, kKeys, kIsPossible };

    using QAbstractListModel::QAbstractListModel;

    void setCommands(const QList<QAction*>& commands);
    // Null: there is no such row.
    [[nodiscard]] QAction* command(int row) const { return commands_.value(row, nullptr); }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    QList<QAction*> commands_;
};

}  // namespace knotspan
