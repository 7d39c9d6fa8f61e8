// The line above the picture that says what went wrong, or what else one should know. It never blocks the
// window. What went wrong stays until it is closed or the next thing works.
#pragma once

#include <functional>

#include <QFrame>
#include <QStyle>

class QLabel;
class QPushButton;

namespace knotspan {

class MessageBar : public QFrame {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    void say(const QString& sentence);   // what went wrong
    void note(const QString& sentence);  // what is as it should be, but may surprise
    // A note with a button; pressing it dismisses the note first.
    void offer(const QString& sentence, const QString& button, std::function<void()> run);
    void dismiss();
    // Something worked: what went wrong before is past. A note stays.
    void dismissTrouble();
    // What was offered is out of date.
    void dismissOffer();
    // Empty where nothing is shown.
    [[nodiscard]] QString message() const;

private:
    void showSentence(const QString& sentence, QStyle::StandardPixmap icon);

    QLabel* icon_ = nullptr;
    QLabel* text_ = nullptr;
    QPushButton* button_ = nullptr;
    std::function<void()> run_;
    bool isTrouble_ = false;
};

}  // namespace knotspan
