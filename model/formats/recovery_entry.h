// What is kept of an open model for the case that its window does not end in peace: a folder of its own with
// the latest snapshot, and a lock that goes with the process. Whoever gets the lock has found a model whose
// process is gone, however long ago.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "model/files/file_lock.h"
#include "model/scene/scene.h"

namespace knotspan::formats {

// What the snapshot's document was.
struct RecoveryNote {
    std::string title;
    std::filesystem::path file;  // that saving would have written; empty: none yet
    bool isImported = false;
    std::int64_t seconds = 0;  // since 1970, when the snapshot was taken; only to be told
};

class RecoveryEntry {
public:
    // An entry of this process's own among those in `folder`, which is made where it is not there.
    [[nodiscard]] static Result<std::shared_ptr<RecoveryEntry>> create(const std::filesystem::path& folder);
    // Those in `folder` whose process is gone, latest snapshot first; this process has them then. Entries
    // without a snapshot are cleared away.
    [[nodiscard]] static std::vector<std::shared_ptr<RecoveryEntry>>
    leftBehind(const std::filesystem::path& folder);

    RecoveryEntry(const RecoveryEntry&) = delete;
    RecoveryEntry& operator=(const RecoveryEntry&) = delete;
    // Leaves the snapshot where it is: only forget() and remove() say that nobody needs it.
    ~RecoveryEntry() = default;

    // Puts the snapshot in the place of the one before; whenever that is interrupted, one of the two is
    // there, whole. On one thread at a time. `epoch` is what epoch() gave when the scene was copied: what was
    // forgotten since is not brought back.
    [[nodiscard]] Result<void> write(const Scene& scene, const RecoveryNote& note, int epoch);
    [[nodiscard]] int epoch() const { return epoch_; }

    [[nodiscard]] Result<RecoveryNote> note() const;
    [[nodiscard]] Result<Scene> read() const;

    // False where somebody cleared its folder away: nothing can be kept in it any more.
    [[nodiscard]] bool isThere() const { return lock_.isOf(folder_ / "lock"); }

    // The snapshot is not needed any more; another may come. Does not wait for a write() elsewhere.
    void forget();
    // Nothing is left; the object is of no use then. Not during a write().
    void remove();

private:
    RecoveryEntry(std::filesystem::path folder, FileLock lock);
    [[nodiscard]] bool holdsSnapshot() const;
    void removeOthersThan(const std::filesystem::path& kept) const;

    std::filesystem::path folder_;
    FileLock lock_;
    int next_ = 1;  // the number of the next snapshot's file
    std::atomic<int> epoch_ = 0;
};

}  // namespace knotspan::formats
