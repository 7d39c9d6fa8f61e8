// Keeps what would be lost: while the document has changes that are not saved, a snapshot of it every two
// minutes, in an entry that is found when the process dies (model/formats/recovery_entry.h). Written on
// another thread; of a running drag or preview nothing is in it.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include <QTimer>

#include "model/document/document.h"

namespace knotspan {

namespace formats {
class RecoveryEntry;
}
class SnapshotThread;

class Autosave : public QObject {
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds kInterval = std::chrono::minutes(2);

    // Entries are made in `folder`. The document outlives it.
    Autosave(Document& document, std::filesystem::path folder, std::chrono::milliseconds interval = kInterval,
             QObject* parent = nullptr);
    // Waits for a snapshot that is being written. What would be lost stays kept.
    ~Autosave() override;

    // The document has just been recovered from this entry, which becomes its own.
    void adopt(std::shared_ptr<formats::RecoveryEntry> entry);
    // The document goes with its user's consent: nothing is kept.
    void endInPeace();

Q_SIGNALS:
    void kept();
    // A sentence; then no other until a snapshot has worked again. It keeps trying.
    void failed(const QString& sentence);

private:
    void keep();
    void take();
    void forgetWhatIsSaved();
    [[nodiscard]] bool isKept(const Scene& scene) const;

    Document& document_;
    std::filesystem::path folder_;
    QTimer timer_;
    std::shared_ptr<formats::RecoveryEntry> entry_;  // null until the first snapshot
    std::optional<Scene> kept_;
    std::unique_ptr<SnapshotThread> thread_;  // at work
    int generation_ = 0;                      // changes when what is kept becomes needless
    bool hasFailed_ = false;
};

}  // namespace knotspan
