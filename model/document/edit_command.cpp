#include "model/document/edit_command.h"

#include "model/document/document.h"

namespace knotspan {

EditCommand::EditCommand(Document& document, Edit edit, const QString& text)
    : QUndoCommand(text),
      document_(document),
      edit_(std::move(edit))
{
}

void EditCommand::undo()
{
    document_.swapIn(edit_);
    applied_ = false;
}

// QUndoStack::push() redoes at once what is applied already.
void EditCommand::redo()
{
    if (!applied_)
        document_.swapIn(edit_);
    applied_ = true;
}

}  // namespace knotspan
