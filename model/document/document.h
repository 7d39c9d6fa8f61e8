// The Qt object around a Scene: the current scene, its undo stack, the file it came from, and the signals
// that the window listens to. All changes of an open model go through apply().
#pragma once

#include <filesystem>
#include <optional>

#include <QObject>
#include <QUndoStack>

#include "model/scene/edit.h"

namespace knotspan {

class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] QUndoStack& undoStack() { return undoStack_; }
    [[nodiscard]] bool isModified() const { return !undoStack_.isClean(); }

    // The file that save() writes to; empty for a new or imported model, which needs saveAs().
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    // What a title bar calls the document; never empty.
    [[nodiscard]] QString title() const;

    // Replaces everything by the file's content. On failure nothing changes.
    [[nodiscard]] Result<void> open(const std::filesystem::path& path);
    // Replaces everything by a scene that belongs to no file.
    void reset(Scene scene, const QString& title);

    [[nodiscard]] Result<void> save();
    [[nodiscard]] Result<void> saveAs(const std::filesystem::path& path);

    // One gesture (a drag from press to release) is one undo step: edits applied with the same gesture number
    // join. 0 never joins. newGesture() hands out a number that was not used before.
    void apply(const Edit& edit, const QString& text, int gesture = 0);
    [[nodiscard]] int newGesture() { return ++lastGesture_; }

    // Takes a running gesture back without leaving a step that could be redone.
    void cancelGesture(int gesture);

Q_SIGNALS:
    void sceneChanged();      // scene() is another value than before
    void documentReplaced();  // additionally, after open() and reset(): it is another model
    void fileChanged();       // file(), title() or isModified()

private:
    friend class EditCommand;
    void swapIn(Edit& edit);

    Scene scene_;
    QUndoStack undoStack_;
    std::filesystem::path file_;
    QString title_;
    int lastGesture_ = 0;
};

}  // namespace knotspan
