// What is left of a window that did not end in peace: keeps snapshots of the open document, and offers those
// that processes left behind which are gone.
#pragma once

#include <deque>
#include <filesystem>
#include <memory>

#include <QCoreApplication>

#include "model/document/autosave.h"

namespace knotspan {

class DocumentFiles;
class MessageBar;
class RecoveryBar;

class Recovery {
    Q_DECLARE_TR_FUNCTIONS(knotspan::Recovery)

public:
    // All outlive it.
    Recovery(Document& document, DocumentFiles& files, MessageBar& messages, RecoveryBar& bar,
             const std::filesystem::path& folder, std::chrono::milliseconds interval);
    ~Recovery();

    [[nodiscard]] Autosave& autosave() { return autosave_; }

private:
    void offer();
    void recover();
    void next();

    Document& document_;
    DocumentFiles& files_;
    MessageBar& messages_;
    RecoveryBar& bar_;
    Autosave autosave_;
    std::deque<std::shared_ptr<formats::RecoveryEntry>> offered_;  // the first is on the bar
};

// Where this user's entries are.
[[nodiscard]] std::filesystem::path recoveryFolder();
// How often a snapshot is taken: the setting autosaveSeconds, two minutes where there is none.
[[nodiscard]] std::chrono::milliseconds autosaveInterval();

}  // namespace knotspan
