// The line above the picture that tells how far the reading of a file is, with the button that stops it. The
// window stays in use meanwhile.
#pragma once

#include <QFrame>
#include <QTimer>

class QLabel;
class QProgressBar;
class QPushButton;

namespace knotspan {

class ReadingLine : public QFrame {
    Q_OBJECT

public:
    explicit ReadingLine(QWidget* parent = nullptr);

    // Shows itself where that takes more than a moment: a line that flashes would only move the picture.
    void begin(const QString& file);
    // `done`: 0 to 1; below 0: nobody knows.
    void tell(const QString& stage, double done);
    void end();
    // What it says; empty where nothing is read.
    [[nodiscard]] QString text() const;

Q_SIGNALS:
    void cancelled();

private:
    QString file_;
    QTimer moment_;
    QLabel* text_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QPushButton* cancel_ = nullptr;
};

}  // namespace knotspan
