// The line above the picture that offers a model that was not saved when its process ended. It waits for an
// answer as long as it takes; the window stays in use meanwhile.
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace knotspan {

class RecoveryBar : public QFrame {
    Q_OBJECT

public:
    explicit RecoveryBar(QWidget* parent = nullptr);

    // `readable`: false where there is nothing to recover but something to discard.
    void offer(const QString& sentence, bool readable);
    void withdraw();
    // Empty where nothing is offered.
    [[nodiscard]] QString sentence() const;

Q_SIGNALS:
    void recover();
    void discard();
    void later();

private:
    QPushButton* addButton(const char* name, const QString& text, const QString& tip);

    QLabel* text_ = nullptr;
    QPushButton* recover_ = nullptr;
};

}  // namespace knotspan
