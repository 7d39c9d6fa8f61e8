// The one undo command: an edit, which undoing and redoing swap with the scene.
#pragma once

#include <QUndoCommand>

#include "model/scene/edit.h"

namespace knotspan {

class Document;

class EditCommand : public QUndoCommand {
public:
    // `edit` was applied to the document's scene already, so it holds its inverse.
    EditCommand(Document& document, Edit edit, const QString& text);

    void undo() override;
    void redo() override;

private:
    Document& document_;
    Edit edit_;
    bool applied_ = true;
};

}  // namespace knotspan
