// The keys of the window's commands: those that they come with, those that the user gave them instead, and
// who stands in the way of whom. Kept beyond the session.
#pragma once

#include <vector>

#include <QAction>
#include <QHash>
#include <QObject>

namespace knotspan {

using KeyList = QList<QKeySequence>;

// A key that would not reach its command, because another has it, or one that begins alike.
struct KeyConflict {
    QKeySequence wanted;
    QKeySequence had;
    QAction* by = nullptr;  // a command, or a menu of the menu bar, which keeps its key
};

class CommandKeys : public QObject {
    Q_OBJECT

public:
    // The commands have the keys that they come with; they get the stored ones, and tool tips that name them.
    // `menus`: of the menu bar. All of them outlive it.
    CommandKeys(QList<QAction*> commands, QList<QAction*> menus, QObject* parent);

    [[nodiscard]] const QList<QAction*>& commands() const { return commands_; }
    [[nodiscard]] KeyList defaultKeys(const QAction& command) const { return defaults_.value(&command); }
    [[nodiscard]] bool isChanged(const QAction& command) const;
    [[nodiscard]] bool isAnyChanged() const;

    [[nodiscard]] std::vector<KeyConflict> conflicts(const QAction& command, const KeyList& keys) const;
    // From now on. Other commands lose what stands in the way; keys of menus are left out.
    void assign(QAction& command, const KeyList& keys);
    void resetAll();

Q_SIGNALS:
    void changed();

private:
    void take(QAction& command, const KeyList& keys);
    void applyStored();
    void store() const;

    QList<QAction*> commands_;
    QList<QAction*> menus_;
    QHash<const QAction*, KeyList> defaults_;
};

}  // namespace knotspan
