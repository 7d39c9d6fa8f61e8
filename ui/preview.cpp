#include "ui/preview.h"

#include <QScopedValueRollback>

namespace knotspan {

Preview::Preview(Document& document, QString text, QObject* parent)
    : QObject(parent),
      document_(document),
      text_(std::move(text))
{
    connect(&document_, &Document::sceneChanged, this, [this] {
        if (isOurs_)
            return;
        gesture_ = 0;  // the document has taken it back
        Q_EMIT modelChanged();
    });
}

Preview::~Preview()
{
    takeBack();
}

void Preview::show(const Edit& edit)
{
    takeBack();
    if (edit.isEmpty())
        return;
    const QScopedValueRollback ours(isOurs_, true);
    gesture_ = document_.preview(edit, text_);
}

void Preview::takeBack()
{
    if (gesture_ == 0)
        return;
    const QScopedValueRollback ours(isOurs_, true);
    document_.cancelGesture(gesture_);
    gesture_ = 0;
}

void Preview::apply(const Edit& edit)
{
    const QScopedValueRollback ours(isOurs_, true);
    if (gesture_ != 0)
        document_.finishGesture(gesture_);
    else
        document_.apply(edit, text_);
    gesture_ = 0;
}

}  // namespace knotspan
