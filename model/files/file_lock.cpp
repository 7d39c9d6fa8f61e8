#include "model/files/file_lock.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace knotspan::formats {
namespace fs = std::filesystem;

namespace {

// Not fcntl's locks: those go when the process closes any descriptor of the file, a writer's say.
bool locked(int descriptor)
{
    while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
        if (errno != EINTR)
            return false;
    return true;
}

}  // namespace

FileLock::FileLock(int descriptor) : descriptor_(descriptor), held_(locked(descriptor)) {}

FileLock::FileLock(FileLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      held_(std::exchange(other.held_, false))
{
}

FileLock& FileLock::operator=(FileLock&& other) noexcept
{
    std::swap(descriptor_, other.descriptor_);
    std::swap(held_, other.held_);
    return *this;
}

FileLock::~FileLock()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

Result<std::optional<FileLock>> FileLock::make(const fs::path& path)
{
    constexpr mode_t kAsTheUserHasIt = 0666;  // less the umask
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kAsTheUserHasIt);
    if (descriptor < 0 && errno == EEXIST)
        return std::nullopt;
    if (descriptor < 0)
        return failure("No file can be written in the folder: " + std::string(std::strerror(errno)),
                       "Choose another folder");
    FileLock lock(descriptor);
    // Somebody who cleans up was quicker, took it for left behind, and removes it.
    if (!lock.isHeld() && errno == EWOULDBLOCK)
        return std::nullopt;
    if (!lock.isOf(path))
        return std::nullopt;
    return lock;
}

Result<FileLock> FileLock::take(const fs::path& path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return failure("The file cannot be opened: " + std::string(std::strerror(errno)));
    FileLock lock(descriptor);
    struct stat status = {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode) || status.st_uid != ::geteuid())
        return failure("This is no ordinary file of this user's");
    // Who had it may have renamed it meanwhile: then it is no longer what the name says.
    if (!lock.isHeld() || !lock.isOf(path))
        return failure("Another process has the file");
    return lock;
}

bool FileLock::isOf(const fs::path& path) const
{
    struct stat mine = {};
    struct stat named = {};
    return ::fstat(descriptor_, &mine) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           mine.st_dev == named.st_dev && mine.st_ino == named.st_ino;
}

}  // namespace knotspan::formats
