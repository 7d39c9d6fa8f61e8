// The line above the picture that says what went wrong, or what else one should know. It never blocks the
// window. What went wrong stays until it is closed or the next thing works.
#pragma once

#include <QFrame>
#include <QStyle>

class QLabel;

namespace knotspan {

class MessageBar : public QFrame {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    void say(const QString& sentence);   // what went wrong
    void note(const QString& sentence);  // what is as it should be, but may surprise
    void dismiss();
    // Something worked: what went wrong before is past. A note stays.
    void dismissTrouble();
    // Empty where nothing is shown.
    [[nodiscard]] QString message() const;

private:
    void showSentence(const QString& sentence, QStyle::StandardPixmap icon);

    QLabel* icon_ = nullptr;
    QLabel* text_ = nullptr;
    bool isTrouble_ = false;
};

}  // namespace knotspan
