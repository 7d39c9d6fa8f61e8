#include "ui/command_keys.h"

#include <algorithm>
#include <utility>

#include <QSettings>

namespace knotspan {

namespace {

constexpr auto kGroup = "keys";

// Whether pressing one leaves it open, or unclear, which is meant.
bool standInTheWay(const QKeySequence& a, const QKeySequence& b)
{
    return a.matches(b) != QKeySequence::NoMatch || b.matches(a) != QKeySequence::NoMatch;
}

bool areInTheWay(const KeyList& keys, const QKeySequence& key)
{
    return std::any_of(keys.begin(), keys.end(),
                       [&](const QKeySequence& other) { return standInTheWay(key, other); });
}

KeyList without(const KeyList& keys, const KeyList& taken)
{
    KeyList left;
    for (const QKeySequence& key : keys)
        if (!areInTheWay(taken, key))
            left << key;
    return left;
}

QStringList written(const KeyList& keys)
{
    QStringList texts;
    for (const QKeySequence& key : keys)
        texts << key.toString(QKeySequence::PortableText);
    return texts;
}

KeyList read(const QStringList& texts)
{
    KeyList keys;
    for (const QString& text : texts)
        if (const QKeySequence key(text, QKeySequence::PortableText); !key.isEmpty())
            keys << key;
    return keys;
}

}  // namespace

CommandKeys::CommandKeys(QList<QAction*> commands, QList<QAction*> menus, QObject* parent)
    : QObject(parent),
      commands_(std::move(commands)),
      menus_(std::move(menus))
{
    for (QAction* command : std::as_const(commands_)) {
        defaults_[command] = command->shortcuts();
        take(*command, command->shortcuts());
    }
    applyStored();
}

bool CommandKeys::isChanged(const QAction& command) const
{
    return command.shortcuts() != defaultKeys(command);
}

bool CommandKeys::isAnyChanged() const
{
    return std::any_of(commands_.begin(), commands_.end(),
                       [this](const QAction* command) { return isChanged(*command); });
}

std::vector<KeyConflict> CommandKeys::conflicts(const QAction& command, const KeyList& keys) const
{
    std::vector<KeyConflict> found;
    for (const QKeySequence& key : keys) {
        for (QAction* menu : menus_)
            if (const QKeySequence its = QKeySequence::mnemonic(menu->text());
                !its.isEmpty() && standInTheWay(key, its))
                found.push_back({key, its, menu});
        for (QAction* other : commands_)
            for (const QKeySequence& its : other->shortcuts())
                if (other != &command && standInTheWay(key, its))
                    found.push_back({key, its, other});
    }
    return found;
}

void CommandKeys::assign(QAction& command, const KeyList& keys)
{
    KeyList wanted = keys;
    for (const KeyConflict& conflict : conflicts(command, keys)) {
        if (menus_.contains(conflict.by))
            wanted.removeAll(conflict.wanted);
        else
            take(*conflict.by, without(conflict.by->shortcuts(), {conflict.had}));
    }
    take(command, wanted);
    store();
    Q_EMIT changed();
}

void CommandKeys::resetAll()
{
    for (QAction* command : std::as_const(commands_))
        take(*command, defaultKeys(*command));
    store();
    Q_EMIT changed();
}

void CommandKeys::take(QAction& command, const KeyList& keys)
{
    command.setShortcuts(keys);
    command.setToolTip(
        keys.isEmpty()
            ? command.statusTip()
            : QString("%1 (%2)").arg(command.statusTip(), keys.first().toString(QKeySequence::NativeText)));
}

// Where a later version comes with a key that the user gave to another command, the user is right.
void CommandKeys::applyStored()
{
    QSettings settings;
    settings.beginGroup(kGroup);
    KeyList given;
    for (const QAction* command : std::as_const(commands_))
        given += read(settings.value(command->objectName()).toStringList());
    for (QAction* command : std::as_const(commands_)) {
        if (settings.contains(command->objectName()))
            take(*command, read(settings.value(command->objectName()).toStringList()));
        else if (!given.isEmpty())
            take(*command, without(command->shortcuts(), given));
    }
}

void CommandKeys::store() const
{
    QSettings settings;
    settings.remove(kGroup);
    settings.beginGroup(kGroup);
    for (const QAction* command : commands_)
        if (isChanged(*command))
            settings.setValue(command->objectName(), written(command->shortcuts()));
}

}  // namespace knotspan
