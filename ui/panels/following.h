// For panels that show what the model has: however many changes come in one turn of the event loop they are
// looked at once, and only while the panel shows.
#pragma once

#include <functional>

#include <QEvent>
#include <QTimer>
#include <QWidget>

namespace knotspan {

class Following : public QObject {
public:
    // Calls `follow` for the widget, which owns this, also when it is shown again.
    Following(QWidget& widget, std::function<void()> follow)
        : QObject(&widget),
          widget_(widget),
          follow_(std::move(follow))
    {
        widget.installEventFilter(this);
    }

    void soon()
    {
        if (isPending_ || !widget_.isVisible())
            return;
        isPending_ = true;
        QTimer::singleShot(0, this, [this] {
            isPending_ = false;
            if (widget_.isVisible())
                follow_();
        });
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::Show)
            soon();
        return QObject::eventFilter(watched, event);
    }

private:
    QWidget& widget_;
    std::function<void()> follow_;
    bool isPending_ = false;
};

}  // namespace knotspan
