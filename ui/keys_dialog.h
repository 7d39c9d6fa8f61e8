// The window behind H: every action with its keys, and what the mouse does. Made from the lists, so that it
// cannot forget one.
#pragma once

#include <QDialog>

namespace knotspan {

class KeysDialog : public QDialog {
    Q_OBJECT

public:
    explicit KeysDialog(QWidget* parent = nullptr);

    // The content, as HTML.
    [[nodiscard]] static QString content();
};

}  // namespace knotspan
