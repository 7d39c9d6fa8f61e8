// Writes one snapshot for recovery beside the window.
#pragma once

#include <memory>

#include <QThread>

#include "model/formats/recovery_entry.h"

namespace knotspan {

class SnapshotThread : public QThread {
    Q_OBJECT

public:
    // Into `entry`, as of now; without one, into a new one in `folder`. `generation`: for who asked.
    SnapshotThread(std::shared_ptr<formats::RecoveryEntry> entry, std::filesystem::path folder, Scene scene,
                   formats::RecoveryNote note, int generation);
    // Waits for the snapshot.
    ~SnapshotThread() override;

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] int generation() const { return generation_; }
    // After finished(). The entry is null where none could be made.
    [[nodiscard]] const std::shared_ptr<formats::RecoveryEntry>& entry() const { return entry_; }
    [[nodiscard]] const Result<void>& result() const { return result_; }

protected:
    void run() override;

private:
    std::shared_ptr<formats::RecoveryEntry> entry_;
    std::filesystem::path folder_;
    Scene scene_;
    formats::RecoveryNote note_;
    int generation_;
    int epoch_;
    Result<void> result_;
};

}  // namespace knotspan
