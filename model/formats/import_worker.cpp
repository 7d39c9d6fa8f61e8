#include "model/formats/import_worker.h"

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <new>
#include <set>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "model/formats/format_list.h"
#include "model/formats/import_lines.h"

namespace knotspan::formats {
namespace {

// Standard output as it was, which from now on only the lines go to.
int takeOutput()
{
    const int output = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (output < 0 || nowhere < 0 || ::dup2(nowhere, STDOUT_FILENO) < 0)
        ::_exit(1);
    return output;
}

// Nobody listens any more: nothing is left to do.
void send(int output, const std::string& line)
{
    for (size_t sent = 0; sent < line.size();) {
        const ssize_t count = ::write(output, line.data() + sent, line.size() - sent);
        if (count < 0 && errno != EINTR)
            ::_exit(1);
        sent += count > 0 ? static_cast<size_t>(count) : 0;
    }
}

// Thousands of faces a second are told of twenty times a second, and each kind of work once at least.
class ToldProgress {
public:
    explicit ToldProgress(int output) : output_(output) {}

    void operator()(const std::string& stage, double done)
    {
        using std::chrono::steady_clock;
        const auto now = steady_clock::now();
        const bool isNew = told_.insert(stage.substr(0, stage.find_first_of("0123456789"))).second;
        if (!isNew && now - last_ < std::chrono::milliseconds(50))
            return;
        last_ = now;
        send(output_, progressLine(stage, done));
    }

private:
    int output_;
    std::chrono::steady_clock::time_point last_{};
    std::set<std::string> told_;  // kinds of work: stages without what they count
};

// The most memory it has had in use so far. Not getrusage(): that counts what the parent had at the fork.
std::uint64_t peakBytes()
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmHWM:") {
            std::uint64_t kilobytes = 0;
            status >> kilobytes;
            return kilobytes << 10;
        }
    return 0;
}

Result<Import> readHere(const std::filesystem::path& path, int output)
{
    const Format* format = find(path);
    if (format == nullptr || format->readIsolated == nullptr)
        return failure("The importer does not know this format", "Open the file in the window");
    try {
        return format->readIsolated(path, ToldProgress(output));
    } catch (const std::bad_alloc&) {
        return failure("The model needs more memory than the importer may take; nothing was changed",
                       "Split the model into several files");
    }
}

}  // namespace

void runImportWorker(const std::filesystem::path& path)
{
    const int output = takeOutput();
    auto import = readHere(path, output);
    if (!import) {
        send(output, errorLine(import.error()));
        ::_exit(1);
    }
    for (const auto& [id, object] : import->scene.objects())
        send(output, objectLine(*object));
    for (const auto& [id, mesh] : import->scene.meshes())
        send(output, meshLine(*mesh));
    import->report.peakBytes = peakBytes();
    send(output, endLine(*import));
    ::_exit(0);
}

}  // namespace knotspan::formats
