#include "model/formats/file_replacement.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

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

// A new, empty file beside `path` that nobody else has, with the access rights a new file gets.
Result<fs::path> temporaryBeside(const fs::path& path)
{
    const mode_t mask = ::umask(0);
    ::umask(mask);
    std::string name =
        (path.parent_path() / ("." + path.filename().string().substr(0, 200) + ".XXXXXX")).string();
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0)
        return failure("No file can be written in the folder: " + reason(), "Choose another folder");
    ::fchmod(descriptor, 0666 & ~mask);
    ::close(descriptor);
    return fs::path(name);
}

Result<void> renamed(const fs::path& temporary, const fs::path& path)
{
    std::error_code error;
    if (const fs::file_status old = fs::status(path, error); fs::exists(old))
        fs::permissions(temporary, old.permissions(), error);
    if (const Descriptor file(temporary, O_RDONLY); !file.isOpen() || !file.sync())
        return failure("The file cannot be brought to the disk: " + reason(),
                       "Check that the disk has room and try again");
    fs::rename(temporary, path, error);
    if (error)
        return failure("The file cannot be replaced: " + error.message(), "Choose another name");
    // The new name is there already; that it outlasts a power cut is worth a try, not a failure.
    if (const Descriptor folder(path.parent_path(), O_RDONLY | O_DIRECTORY); folder.isOpen())
        (void)folder.sync();
    return {};
}

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

    const auto temporary = temporaryBeside(target);
    if (!temporary)
        return tl::unexpected(temporary.error());
    Result<void> result = writeTo(*temporary);
    if (result)
        result = renamed(*temporary, target);
    if (!result)
        fs::remove(*temporary, error);
    return result;
}

}  // namespace knotspan::formats
