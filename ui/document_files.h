// Files in and out of the open document: asks which, asks before changes are lost, and says in the message
// bar what fails. Files that are read apart (formats::isReadApart) are read beside the window, one at a time:
// the calls return at once then, and the model is taken over when it is there.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QCoreApplication>
#include <QStringList>

#include "model/document/document.h"
#include "model/files/format.h"
#include "ui/file_watch.h"
#include "ui/questions.h"

namespace knotspan {

class MessageBar;
class ReadingLine;
class ReadingThread;

class DocumentFiles {
    Q_DECLARE_TR_FUNCTIONS(knotspan::DocumentFiles)

public:
    // All outlive it; dialogs stand before `window`.
    DocumentFiles(QWidget& window, Document& document, MessageBar& messages, ReadingLine& line,
                  Questions questions);
    ~DocumentFiles();

    // Opens the first, adds the others; asks first where changes would be lost. What fails is said in the
    // message bar, the open document stays. Refused while another is being read.
    void open(const std::vector<std::filesystem::path>& files);
    // Says so and forgets the file where it is gone.
    void openRecent(const QString& file);
    void openSample(const std::string& name);
    void startNew();  // an empty model
    void askAndOpen();
    // Reads the model's file again; the model as it is now is one undo away. Refused while another is read.
    void reload();
    void askAndAdd();
    bool save();  // false where it failed or was called off; so for the next
    bool saveAs();
    // Asks where changes would be lost; false: the document must stay.
    [[nodiscard]] bool mayDrop();

    [[nodiscard]] const Questions& questions() const { return questions_; }
    [[nodiscard]] bool isReading() const { return thread_ != nullptr; }
    // Stops reading, says so, and leaves the document as it is.
    void cancelReading();
    // Stops it without a word: nobody waits for it any more.
    void dropReading();

private:
    // The files of one call, read one after the other.
    struct Job {
        std::vector<std::filesystem::path> files;
        bool opens = false;    // the first replaces the document
        bool reloads = false;  // the only one is the document's own, anew
        size_t next = 0;
        Scene sceneBefore;  // whose loss was agreed to
        QStringList wrong;
        QStringList notes;
    };

    [[nodiscard]] bool isRefusedWhileReading();
    void start(Job job);
    void goOn();
    void readApart(const std::filesystem::path& path);
    void takeFromThread();
    void take(const std::filesystem::path& path, Result<formats::Import> import);
    void noteMeshesLeftOut(const std::filesystem::path& path);
    void offerReload(const QString& path);
    [[nodiscard]] bool takeFirst(const std::filesystem::path& path, Result<formats::Import>& import);
    void finish();
    void report(const Error& error);

    QWidget& window_;
    Document& document_;
    MessageBar& messages_;
    ReadingLine& line_;
    FileWatch watch_;
    Questions questions_;
    std::optional<Job> job_;
    std::unique_ptr<ReadingThread> thread_;
};

}  // namespace knotspan
