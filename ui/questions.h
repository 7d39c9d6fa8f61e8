// What the window asks the user in dialogs of their own. Functions, so that tests can answer without a hand.
#pragma once

#include <functional>

#include <QStringList>

class QWidget;

namespace knotspan {

enum class SaveAnswer { save, discard, cancel };

struct Questions {
    // Whether to save the named document before it goes.
    std::function<SaveAnswer(QWidget* parent, const QString& title)> saveChanges;
    // Whether to write over the named file, which another program has changed.
    std::function<bool(QWidget* parent, const QString& file)> overwrite;
    // Which files to read; empty: none. `filters` as QFileDialog takes them.
    std::function<QStringList(QWidget* parent, const QString& caption, const QStringList& filters)>
        filesToOpen;
    // Where to write; empty: nowhere.
    std::function<QString(QWidget* parent, const QString& caption, const QString& proposal,
                          const QStringList& filters)>
        fileToSave;
};

// The dialogs.
[[nodiscard]] Questions askTheUser();

// The filters for the formats that can be read, "all models" first, or that can be written.
[[nodiscard]] QStringList readFilters();
[[nodiscard]] QStringList writeFilters();

}  // namespace knotspan
