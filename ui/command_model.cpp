#include "ui/command_model.h"

#include "ui/command_text.h"

namespace knotspan {

void CommandModel::setCommands(const QList<QAction*>& commands)
{
    beginResetModel();
    for (QAction* command : std::as_const(commands_))
        command->disconnect(this);
    commands_ = commands;
    for (QAction* command : commands)
        connect(command, &QAction::changed, this, [this, command] {
            const QModelIndex changed = index(static_cast<int>(commands_.indexOf(command)));
            Q_EMIT dataChanged(changed, changed);
        });
    endResetModel();
}

int CommandModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(commands_.size());
}

QVariant CommandModel::data(const QModelIndex& index, int role) const
{
    const QAction* command = this->command(index.row());
    if (command == nullptr)
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return plainTextOf(*command);
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return command->statusTip();
    case Qt::CheckStateRole:
        return command->isCheckable() ? QVariant(command->isChecked() ? Qt::Checked : Qt::Unchecked)
                                      : QVariant();
    case Qt::AccessibleTextRole: {
        QStringList parts{plainTextOf(*command), menuTitleOf(*command)};
        if (command->isCheckable())
            parts << (command->isChecked() ? tr("on") : tr("off"));
        if (!command->isEnabled())
            parts << tr("not possible now");
        if (const QString keys = keysTextOf(*command); !keys.isEmpty())
            parts << keys;
        return parts.join(", ");
    }
    case kMenu:
        return menuTitleOf(*command);
    case kKeys:
        return keysTextOf(*command);
    case kIsPossible:
        return command->isEnabled();
    default:
        return {};
    }
}

}  // namespace knotspan
