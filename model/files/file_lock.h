// A lock on a file that lasts as long as who holds it: a kill, a crash and a power cut free it. Whoever gets
// the lock of another process's file knows that this process has left it behind.
#pragma once

#include <filesystem>
#include <optional>

#include "model/core/result.h"

namespace knotspan::formats {

class FileLock {
public:
    // A new, empty file that nobody else has, with the access rights a new file gets, and its lock. Nothing:
    // there is a file of that name.
    [[nodiscard]] static Result<std::optional<FileLock>> make(const std::filesystem::path& path);
    // The lock of a file that is there, an ordinary one of this user's; fails where another has it.
    [[nodiscard]] static Result<FileLock> take(const std::filesystem::path& path);

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;
    ~FileLock();

    // False where the file system knows no locks: then nobody gets the lock of such a file.
    [[nodiscard]] bool isHeld() const { return held_; }
    // Whether `path` is still the file that was locked.
    [[nodiscard]] bool isOf(const std::filesystem::path& path) const;

private:
    explicit FileLock(int descriptor);

    int descriptor_ = -1;
    bool held_ = false;
};

}  // namespace knotspan::formats
