// Files in and out of the open document: asks which, asks before changes are lost, and says in the message
// bar what fails.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <QCoreApplication>

#include "model/document/document.h"
#include "ui/questions.h"

namespace knotspan {

class MessageBar;

class DocumentFiles {
    Q_DECLARE_TR_FUNCTIONS(knotspan::DocumentFiles)

public:
    // All outlive it; dialogs stand before `window`.
    DocumentFiles(QWidget& window, Document& document, MessageBar& messages, Questions questions);

    // Opens the first, adds the others; asks first where changes would be lost. What fails is said in the
    // message bar, the open document stays.
    void open(const std::vector<std::filesystem::path>& files);
    void openSample(const std::string& name);
    void askAndOpen();
    void askAndAdd();
    bool save();  // false where it failed or was called off; so for the next
    bool saveAs();
    // Asks where changes would be lost; false: the document must stay.
    [[nodiscard]] bool mayDrop();

private:
    bool openOne(const std::filesystem::path& path);
    // `trimmedBefore`: how many trimmed faces the user knows of.
    void add(const std::vector<std::filesystem::path>& files, std::ptrdiff_t trimmedBefore);
    void report(const Error& error);

    QWidget& window_;
    Document& document_;
    MessageBar& messages_;
    Questions questions_;
};

}  // namespace knotspan
