// Every command with its keys, and giving it others: find it, press the new key, see at once who has it
// already, and take it from there or leave it.
#pragma once

#include <optional>

#include <QWidget>

#include "ui/command_keys.h"

class QCheckBox;
class QKeySequenceEdit;
class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace knotspan {

class KeysPage : public QWidget {
    Q_OBJECT

public:
    // `keys` outlives it.
    explicit KeysPage(CommandKeys& keys, QWidget* parent = nullptr);

private:
    // Keys that a command is to have.
    struct Wish {
        QAction* command = nullptr;
        KeyList keys;
    };

    [[nodiscard]] QWidget* makeList();
    [[nodiscard]] QLayout* makeRecorder();
    [[nodiscard]] QLayout* makeChoice();
    [[nodiscard]] QPushButton* makeButton(const char* id, const QString& text, const QString& tip);
    void filter();
    void showKeys();
    [[nodiscard]] QAction* chosen() const;
    void hearKey();
    void wishDefaults();
    void showWish();
    void grant();
    void forget();

    CommandKeys& keys_;
    std::optional<Wish> wish_;
    QLineEdit* filter_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QKeySequenceEdit* recorder_ = nullptr;
    QCheckBox* keepOld_ = nullptr;
    QPushButton* use_ = nullptr;
    QPushButton* none_ = nullptr;
    QPushButton* reset_ = nullptr;
    QLabel* trouble_ = nullptr;
    QPushButton* take_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QPushButton* resetAll_ = nullptr;
};

}  // namespace knotspan
