#include "model/files/file_replacement.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "model/files/file_lock.h"
#include "model/files/unfinished_files.h"

namespace knotspan::formats {
namespace fs = std::filesystem;

namespace {

// A file descriptor that is closed with its scope.
class Descriptor {
public:
    Descriptor(const fs::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC)) {}
    ~Descriptor()
    {
        if (number_ >= 0)
            ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] bool isOpen() const { return number_ >= 0; }
    [[nodiscard]] bool sync() const { return ::fsync(number_) == 0; }

private:
    int number_;
};

std::string reason()
{
    return std::strerror(errno);
}

fs::path numbered(const fs::path& first, int number)
{
    return number == 0 ? first : fs::path(first.string() + "-" + std::to_string(number));
}

void removeLeftBehind(const fs::path& path)
{
    std::error_code ignored;
    if (const auto lock = FileLock::take(path))  // held until it is gone
        fs::remove(path, ignored);
}

// The file that is written: goes with its scope, unless it got the other's name. Its lock says that somebody
// is at work: what a killed process left behind has none, and goes with the next file that is written there.
class Temporary {
public:
    static Result<Temporary> beside(const fs::path& path)
    {
        constexpr int kMost = 16;  // that write the same file at the same time
        constexpr size_t kLongest = 200;
        const fs::path first =
            path.parent_path() / ("." + path.filename().string().substr(0, kLongest) + ".saving");
        for (int number = 0; number < kMost; ++number) {
            const fs::path candidate = numbered(first, number);
            removeLeftBehind(candidate);
            auto made = FileLock::make(candidate);
            if (!made)
                return tl::unexpected(made.error());
            if (!*made)
                continue;
            while (++number < kMost)
                removeLeftBehind(numbered(first, number));
            return Temporary(candidate, std::move(**made));
        }
        return failure("The file is just being written by many others", "Try again, or choose another name");
    }

    Temporary(Temporary&& other) noexcept
        : path_(std::exchange(other.path_, {})),
          lock_(std::move(other.lock_)),
          unfinished_(std::move(other.unfinished_))
    {
    }
    Temporary& operator=(Temporary&&) = delete;
    ~Temporary()
    {
        std::error_code ignored;
        if (!path_.empty())
            fs::remove(path_, ignored);
    }

    [[nodiscard]] const fs::path& path() const { return path_; }

    [[nodiscard]] Result<void> renameTo(const fs::path& path)
    {
        std::error_code error;
        if (const Descriptor file(path_, O_RDONLY); !file.isOpen() || !file.sync())
            return failure("The file cannot be brought to the disk: " + reason(),
                           "Check that the disk has room and try again");
        if (const fs::file_status old = fs::status(path, error); fs::exists(old))
            fs::permissions(path_, old.permissions(), error);
        fs::rename(path_, path, error);
        if (error)
            return failure("The file cannot be replaced: " + error.message(), "Choose another name");
        path_.clear();
        // The new name is there already; that it outlasts a power cut is worth a try, not a failure.
        if (const Descriptor folder(path.parent_path(), O_RDONLY | O_DIRECTORY); folder.isOpen())
            (void)folder.sync();
        return {};
    }

private:
    Temporary(fs::path path, FileLock lock)
        : path_(std::move(path)),
          lock_(std::move(lock)),
          unfinished_(path_)
    {
    }

    fs::path path_;
    FileLock lock_;
    UnfinishedFile unfinished_;
};

}  // namespace

Result<void> openedForReading(const fs::path& path)
{
    if (!Descriptor(path, O_RDONLY | O_NONBLOCK).isOpen())
        return failure("The file cannot be opened: " + reason(), "Check who may read it");
    return {};
}

Result<void> replaceFile(const fs::path& path, const std::function<Result<void>(const fs::path&)>& writeTo)
{
    std::error_code error;
    fs::path target = fs::weakly_canonical(fs::absolute(path), error);
    if (error)
        return failure("The place cannot be reached: " + error.message(), "Choose another folder");
    if (!fs::is_directory(target.parent_path(), error))
        return failure("There is no folder " + target.parent_path().string(), "Create it first");
    const fs::file_status old = fs::status(target, error);
    if (fs::is_directory(old))
        return failure("This is a folder, not a file", "Choose a file's name");
    if (fs::exists(old) && !fs::is_regular_file(old))
        return failure("This is no ordinary file", "Choose another name");
    // Renaming would not ask, and those who may do anything are asked as well.
    constexpr fs::perms kAnyoneWrites =
        fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    if (fs::exists(old) &&
        ((old.permissions() & kAnyoneWrites) == fs::perms::none || ::access(target.c_str(), W_OK) != 0))
        return failure("The file may not be changed: it is write-protected", "Choose another name");

    auto temporary = Temporary::beside(target);
    if (!temporary)
        return tl::unexpected(temporary.error());
    if (auto written = writeTo(temporary->path()); !written)
        return written;
    return temporary->renameTo(target);
}

Result<void> replaceText(const fs::path& path, const std::string& text)
{
    return replaceFile(path, [&](const fs::path& beside) -> Result<void> {
        std::ofstream file(beside, std::ios::binary | std::ios::trunc);
        file << text;
        file.close();
        if (!file)
            return tl::unexpected<Error>(
                {"The file cannot be written", path.string(), "Check that the disk has room and try again"});
        return {};
    });
}

}  // namespace knotspan::formats
