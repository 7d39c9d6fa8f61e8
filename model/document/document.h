// The Qt object around a Scene: the current scene, its undo stack, the file it came from, and the signals
// that the window listens to. All changes of an open model go through apply().
#pragma once

#include <filesystem>
#include <optional>

#include <QObject>
#include <QUndoStack>

#include "model/scene/edit.h"
#include "model/scene/object_counts.h"

namespace knotspan {

class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    // The scene as its steps made it: without a running drag or preview.
    [[nodiscard]] Scene settledScene() const;
    [[nodiscard]] const ObjectCounts& objectCounts() const
    {
        counts_.follow(scene_);
        return counts_;
    }
    // Ends a running gesture first, so that its step is on the stack; where a drag may run, ask canUndo()
    // etc.
    [[nodiscard]] QUndoStack& undoStack();
    // The same, to be looked at: a running gesture is not among its steps and goes on.
    [[nodiscard]] const QUndoStack& history() const { return undoStack_; }
    void undo() { undoStack().undo(); }
    void redo() { undoStack().redo(); }
    [[nodiscard]] bool canUndo() const { return isDragging() || undoStack_.canUndo(); }
    [[nodiscard]] bool canRedo() const { return !isDragging() && undoStack_.canRedo(); }
    [[nodiscard]] QString undoText() const { return isDragging() ? running_->text : undoStack_.undoText(); }
    [[nodiscard]] QString redoText() const { return undoStack_.redoText(); }
    [[nodiscard]] bool isModified() const { return isDragging() || !undoStack_.isClean(); }

    // The file that save() writes to; empty for a new or imported model, which needs saveAs().
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    // The file that the model was read from or written to last, whatever its format; empty: none.
    [[nodiscard]] const std::filesystem::path& source() const { return source_; }
    // Counts the times that it was.
    [[nodiscard]] int sourceRevision() const { return sourceRevision_; }
    // Whether another program's format brought the model here.
    [[nodiscard]] bool isImported() const { return isImported_; }
    // What a title bar calls the document; never empty.
    [[nodiscard]] QString title() const;

    // Replaces everything by the file's content. On failure nothing changes.
    [[nodiscard]] Result<void> open(const std::filesystem::path& path);
    // Adds the file's objects to the scene, as one step, scaled to the scene's units. On failure nothing
    // changes.
    [[nodiscard]] Result<void> add(const std::filesystem::path& path);
    // The same with the file's content read already, as on another thread.
    void open(const std::filesystem::path& path, Scene content);
    [[nodiscard]] Result<void> add(const std::filesystem::path& path, const Scene& content);
    // Takes over what source() holds now, as a step that can be undone; the model is unmodified then.
    void reload(const Scene& content);
    // Replaces everything by a scene that belongs to no file.
    void reset(Scene scene, const QString& title);
    // Replaces everything by what was kept of a document that was not saved: modified, and of the same file.
    void recover(Scene scene, const std::filesystem::path& file, const QString& title, bool isImported);

    [[nodiscard]] Result<void> save();
    [[nodiscard]] Result<void> saveAs(const std::filesystem::path& path);

    // One gesture (a drag from press to release) is one undo step: edits applied with the same gesture number
    // join. 0 never joins. newGesture() hands out a number that was not used before.
    void apply(const Edit& edit, const QString& text, int gesture = 0);
    [[nodiscard]] int newGesture() { return ++lastGesture_; }

    // Shows what an edit would do: a gesture that is no step and that no file gets, until finishGesture()
    // makes it one. Whatever else is done to the model takes it back. Who makes an edit from the objects of
    // the scene calls endPreview() before looking at them. Returns the gesture's number; 0: there is nothing
    // to show.
    [[nodiscard]] int preview(const Edit& edit, const QString& text);
    void endPreview();
    [[nodiscard]] bool isPreviewing() const { return running_ && running_->isPreview; }

    // The running gesture is kept outside the stack until it ends: by finishGesture(), or by whatever else
    // uses the stack.
    void finishGesture(int gesture);
    // Takes the running gesture back and leaves no trace: the steps that could be redone are still there.
    void cancelGesture(int gesture);

Q_SIGNALS:
    void sceneChanged();      // scene() is another value than before
    void documentReplaced();  // additionally, after open() and reset(): it is another model
    void fileChanged();       // file(), title() or isModified()

private:
    friend class EditCommand;
    struct Running {
        int gesture = 0;
        Edit edit;  // applied: holds its inverse
        QString text;
        bool isPreview = false;
    };
    [[nodiscard]] bool isDragging() const { return running_ && !running_->isPreview; }
    void swapIn(Edit& edit);
    void finishRunning();
    [[nodiscard]] bool isBackAtStart() const;
    void replace(Scene scene, const std::filesystem::path& file, const QString& title, bool isImported,
                 const std::filesystem::path& source);

    Scene scene_;
    mutable ObjectCounts counts_;  // of the scene when last asked
    QUndoStack undoStack_;
    std::optional<Running> running_;
    std::filesystem::path file_;
    std::filesystem::path source_;
    int sourceRevision_ = 0;
    QString title_;
    bool isImported_ = false;
    int lastGesture_ = 0;
};

}  // namespace knotspan
