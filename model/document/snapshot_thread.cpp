#include "model/document/snapshot_thread.h"

namespace knotspan {

SnapshotThread::SnapshotThread(std::shared_ptr<formats::RecoveryEntry> entry, std::filesystem::path folder,
                               Scene scene, formats::RecoveryNote note, int generation)
    : entry_(std::move(entry)),
      folder_(std::move(folder)),
      scene_(std::move(scene)),
      note_(std::move(note)),
      generation_(generation),
      epoch_(entry_ ? entry_->epoch() : 0)
{
}

SnapshotThread::~SnapshotThread()
{
    wait();
}

void SnapshotThread::run()
{
    if (!entry_) {
        auto made = formats::RecoveryEntry::create(folder_);
        if (!made) {
            result_ = tl::unexpected(made.error());
            return;
        }
        entry_ = std::move(*made);
    }
    result_ = entry_->write(scene_, note_, epoch_);
}

}  // namespace knotspan
