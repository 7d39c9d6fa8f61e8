#include "tests/corpus/program_run.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support.h"

namespace knotspan::corpus {
namespace fs = std::filesystem;

namespace {

// What the process between us and the program found out.
struct Finding {
    int status = 0;
    int leaked = 0;
    bool tookTooLong = false;
    double seconds = 0;
    double computing = 0;
    std::uint64_t peakBytes = 0;
};

// From here to runOn() only what may be called between fork() and exec().
double now()
{
    timespec time{};
    ::clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double secondsIn(const timeval& time)
{
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void rest()
{
    const timespec time{0, 2'000'000};
    ::nanosleep(&time, nullptr);
}

[[noreturn]] void becomeProgram(char* const* argv, const char* output, const char* messages)
{
    ::setpgid(0, 0);
    const int nowhere = ::open("/dev/null", O_RDONLY);
    const int out = ::open(output, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err = ::open(messages, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (::dup2(nowhere, STDIN_FILENO) >= 0 && ::dup2(out, STDOUT_FILENO) >= 0 &&
        ::dup2(err, STDERR_FILENO) >= 0)
        ::execv(argv[0], argv);
    ::_exit(127);
}

// Processes that are still there: whoever loses its parent becomes a child of this one. The program ends its
// importer by a signal, whose work may take a moment.
int leftBehind()
{
    const double latest = now() + 2;
    while (true) {
        const pid_t waited = ::waitpid(-1, nullptr, WNOHANG);
        if (waited < 0 && errno == ECHILD)
            return 0;
        if (now() > latest)
            break;
        if (waited == 0)
            rest();
    }
    return 1;
}

Finding superviseProgram(char* const* argv, const char* output, const char* messages, double secondsAllowed)
{
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    Finding finding;
    const double start = now();
    const pid_t program = ::fork();
    if (program == 0)
        becomeProgram(argv, output, messages);
    rusage usage{};
    while (::wait4(program, &finding.status, WNOHANG, &usage) == 0) {
        if (!finding.tookTooLong && now() - start > secondsAllowed) {
            finding.tookTooLong = true;
            ::kill(-program, SIGKILL);
        }
        rest();
    }
    finding.seconds = now() - start;
    finding.computing = secondsIn(usage.ru_utime) + secondsIn(usage.ru_stime);
    finding.peakBytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
    finding.leaked = leftBehind();
    return finding;
}

}  // namespace

ProgramRun runOn(const std::vector<std::string>& command, double secondsAllowed, const fs::path& scratch)
{
    static std::atomic<int> count = 0;
    const std::string number = std::to_string(count++);
    const std::string output = (scratch / (number + ".out")).string();
    const std::string messages = (scratch / (number + ".err")).string();
    std::vector<std::string> words = command;
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);

    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return {};
    const pid_t supervisor = ::fork();
    if (supervisor == 0) {
        const Finding finding =
            superviseProgram(argv.data(), output.c_str(), messages.c_str(), secondsAllowed);
        ::_exit(::write(ends[1], &finding, sizeof finding) == sizeof finding ? 0 : 1);
    }
    ::close(ends[1]);
    Finding finding;
    finding.status = 127 << 8;
    while (::read(ends[0], &finding, sizeof finding) < 0 && errno == EINTR) {
    }
    ::close(ends[0]);
    while (::waitpid(supervisor, nullptr, 0) < 0 && errno == EINTR) {
    }
    ProgramRun run{finding.status,
                   finding.tookTooLong,
                   finding.leaked,
                   finding.seconds,
                   finding.computing,
                   finding.peakBytes,
                   testing::readFile(output),
                   testing::readFile(messages)};
    std::error_code ignored;
    fs::remove(output, ignored);
    fs::remove(messages, ignored);
    return run;
}

}  // namespace knotspan::corpus
