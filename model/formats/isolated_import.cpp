#include "model/formats/isolated_import.h"

#include <chrono>
#include <csignal>
#include <mutex>

#include <sys/wait.h>
#include <unistd.h>

#include "model/formats/import_lines.h"

namespace knotspan::formats {
namespace fs = std::filesystem;
using std::chrono::steady_clock;

namespace {

struct WorkerPath {
    std::mutex mutex;
    fs::path path;
};

WorkerPath& workerPath()
{
    static WorkerPath instance;
    return instance;
}

std::string mebibytes(std::uint64_t bytes)
{
    return std::to_string(bytes >> 20) + " MiB";
}

// Follows one worker from its first line to its end.
class Supervision {
public:
    Supervision(WorkerProcess worker, const ImportWatch& watch, const ProcessLimits& limits)
        : worker_(std::move(worker)),
          watch_(watch),
          limits_(limits),
          lines_(watch.progress)
    {
    }

    [[nodiscard]] Result<Import> run()
    {
        while (true) {
            if (const auto may = mayGoOn(); !may)
                return tl::unexpected(may.error());
            constexpr int kPatience = 25;  // milliseconds
            const bool hadEnded = worker_.hasEnded();
            const auto reading = worker_.read(text_, kPatience);
            if (const auto taken = takeLines(); !taken)
                return tl::unexpected(taken.error());
            if (lines_.isComplete())
                return std::move(lines_).result();
            // What has ended may have left a child that holds the line open.
            if (reading == WorkerProcess::Reading::end ||
                (reading == WorkerProcess::Reading::nothing && hadEnded))
                return tl::unexpected(whyItEnded());
        }
    }

private:
    [[nodiscard]] Result<void> mayGoOn()
    {
        if (watch_.cancelled != nullptr && *watch_.cancelled)
            return failure("Reading was cancelled; nothing was changed");
        if (received_ + text_.size() > limits_.output)
            return failure("The model became larger than the " + mebibytes(limits_.output) +
                               " that an import may give; nothing was changed",
                           "Split the model into several files");
        const auto now = steady_clock::now();
        if (now - start_ > std::chrono::seconds(limits_.wallSeconds))
            return failure("Reading the file takes longer than it may (" +
                               std::to_string(limits_.wallSeconds) +
                               " seconds, much of it waiting); nothing was changed",
                           "Try again when the computer is less busy, or split the model into several files");
        if (now - lastLook_ < std::chrono::milliseconds(20))
            return {};
        lastLook_ = now;
        if (worker_.residentBytes() > limits_.memory)
            return failure("Reading the file takes more than the " + mebibytes(limits_.memory) +
                               " of memory that it may take here; nothing was changed",
                           "Split the model into several files, or open it on a larger machine");
        return {};
    }

    [[nodiscard]] Result<void> takeLines()
    {
        size_t start = 0;
        for (size_t end = text_.find('\n', searched_); end != std::string::npos && !lines_.isComplete();
             end = text_.find('\n', start)) {
            if (auto taken = lines_.take(std::string_view(text_).substr(start, end - start)); !taken)
                return taken;
            start = end + 1;
        }
        received_ += start;
        text_.erase(0, start);
        searched_ = text_.size();
        return {};
    }

    [[nodiscard]] Error tookTooLong() const
    {
        return {"Reading the file takes longer than it may (" + std::to_string(limits_.cpuSeconds) +
                    " seconds of computing); nothing was changed",
                {},
                "Split the model into several files, or export it again"};
    }

    // It closed its output without a last line.
    [[nodiscard]] Error whyItEnded()
    {
        // Its output is closed a moment before it has ended; on a busy machine that is a long moment.
        const auto latest = steady_clock::now() + std::chrono::seconds(1);
        while (!worker_.hasEnded() && steady_clock::now() < latest) {
            if (const auto may = mayGoOn(); !may)
                return may.error();
            ::usleep(1000);
        }
        const bool endedItself = worker_.hasEnded();
        const int status = worker_.end();
        const std::string again = "Export it again from the program that made it";
        if (!endedItself)
            return {"The importer stopped answering on this file; nothing was changed", {}, again};
        if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
            return {"The importer cannot be started", {}, "Start Knotspan again, or install it again"};
        if (WIFEXITED(status))
            return {"The importer gave up on this file (exit code " + std::to_string(WEXITSTATUS(status)) +
                        "); nothing was changed",
                    {},
                    again};
        if (WTERMSIG(status) == SIGXCPU)
            return tookTooLong();
        if (WTERMSIG(status) == SIGKILL)
            return {"The system ended the importer, most likely because the memory ran out; nothing was "
                    "changed",
                    {},
                    "Close other programs, or split the model into several files"};
        return {"The importer crashed on this file (signal " + std::to_string(WTERMSIG(status)) +
                    "); nothing was changed",
                {},
                again};
    }

    WorkerProcess worker_;
    const ImportWatch& watch_;
    const ProcessLimits& limits_;
    ImportLines lines_;
    std::string text_;            // received, but no whole line yet
    size_t searched_ = 0;         // of it, for the end of the line
    std::uint64_t received_ = 0;  // before text_
    steady_clock::time_point start_ = steady_clock::now();
    steady_clock::time_point lastLook_{};
};

}  // namespace

void setImportWorker(const fs::path& program)
{
    const std::scoped_lock lock(workerPath().mutex);
    workerPath().path = program;
}

fs::path importWorker()
{
    const std::scoped_lock lock(workerPath().mutex);
    return workerPath().path;
}

ProcessLimits limitsFor(const fs::path& path)
{
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    const unsigned megabytes = error ? 0 : static_cast<unsigned>(size / 1'000'000);
    ProcessLimits limits;
    // Measured: 0.2 seconds a megabyte.
    limits.cpuSeconds = 30 + 10 * megabytes;
    limits.wallSeconds = 3 * limits.cpuSeconds;
    limits.memory = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                    static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) / 2;
    limits.output = std::uint64_t{4} << 30;
    return limits;
}

Result<Import> importIsolated(const fs::path& path, const ImportWatch& watch, const ProcessLimits& limits)
{
    std::error_code error;
    const fs::path whole = fs::absolute(path, error);  // no word of the command may begin with a dash
    if (error)
        return failure("The file cannot be reached: " + error.message(), "Give its whole path");
    auto worker = WorkerProcess::start({importWorker().string(), "import-worker", whole.string()}, limits);
    if (!worker)
        return tl::unexpected(worker.error());
    return Supervision(std::move(*worker), watch, limits).run();
}

}  // namespace knotspan::formats
