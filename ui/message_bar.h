// The line above the picture that says what went wrong. It never blocks the window; it stays until it is
// closed or the next thing works.
#pragma once

#include <QFrame>

class QLabel;

namespace knotspan {

class MessageBar : public QFrame {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    void say(const QString& sentence);
    void dismiss();
    // Empty where nothing is shown.
    [[nodiscard]] QString message() const;

private:
    QLabel* text_ = nullptr;
};

}  // namespace knotspan
