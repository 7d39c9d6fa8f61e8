// What Ctrl+K brings up: every command of the window, found by a few typed letters and run by Enter. It goes
// when another window is wanted.
#pragma once

#include <QDialog>

class QAction;
class QLineEdit;
class QListView;

namespace knotspan {

class CommandModel;

class CommandPalette : public QDialog {
    Q_OBJECT

public:
    // The commands, in the order of the menus, outlive it.
    CommandPalette(const QList<QAction*>& commands, QWidget* parent);

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void find();
    void go(int key);
    void tellCurrent();
    void run(const QModelIndex& index);

    QList<QAction*> commands_;
    QLineEdit* filter_;
    QListView* list_;
    CommandModel* model_;
};

}  // namespace knotspan
