// The window behind H: every command with its keys, which can be changed there, and what the mouse does, for
// hands that know other programs, too. Made from the lists, so that it cannot forget one.
#pragma once

#include <QDialog>

class QComboBox;
class QTextBrowser;

namespace knotspan {

class CommandKeys;
class Viewport;

class KeysDialog : public QDialog {
    Q_OBJECT

public:
    // Both outlive it.
    KeysDialog(CommandKeys& keys, Viewport& viewport, QWidget* parent = nullptr);

private:
    [[nodiscard]] QWidget* makeMousePage();
    void showMouse();

    Viewport& viewport_;
    QComboBox* navigation_ = nullptr;
    QTextBrowser* mouse_ = nullptr;
};

}  // namespace knotspan
