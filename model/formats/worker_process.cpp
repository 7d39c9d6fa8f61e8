#include "model/formats/worker_process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace knotspan::formats {
namespace {

// Libraries and stacks take address space that is never touched.
constexpr rlim_t kAddressRoom = rlim_t{4} << 30;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitsAddresses = false;  // its shadow takes terabytes of addresses
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kLimitsAddresses = false;
#else
constexpr bool kLimitsAddresses = true;
#endif
#else
constexpr bool kLimitsAddresses = true;
#endif

// From here to the next function the new process runs: only what may be called between fork() and exec().
void limit(decltype(RLIMIT_CORE) resource, rlim_t soft, rlim_t hard)
{
    rlimit now{};
    if (::getrlimit(resource, &now) != 0)
        return;
    const rlimit wanted{soft < now.rlim_max ? soft : now.rlim_max, hard < now.rlim_max ? hard : now.rlim_max};
    ::setrlimit(resource, &wanted);
}

void preferForKilling()
{
    const int file = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
    if (file < 0)
        return;
    if (::write(file, "1000", 4) < 0) {
        // Then it is one process among others.
    }
    ::close(file);
}

void resetSignals()
{
    for (const int signal : {SIGPIPE, SIGXCPU, SIGXFSZ, SIGINT, SIGTERM, SIGCHLD})
        ::signal(signal, SIG_DFL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void becomeWorker(char* const* argv, const ProcessLimits& limits, int output, pid_t parent)
{
    constexpr int kNotStarted = 127;
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent)  // it has died before it could be said
        ::_exit(kNotStarted);
    resetSignals();
    preferForKilling();
    const int nowhere = ::open("/dev/null", O_RDWR);
    if (nowhere < 0 || ::dup2(nowhere, STDIN_FILENO) < 0 || ::dup2(nowhere, STDERR_FILENO) < 0 ||
        ::dup2(output, STDOUT_FILENO) < 0)
        ::_exit(kNotStarted);
#ifdef SYS_close_range
    ::syscall(SYS_close_range, static_cast<unsigned>(STDERR_FILENO + 1), ~0U, 0U);
#endif
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, 0, 0);
    limit(RLIMIT_CPU, limits.cpuSeconds, limits.cpuSeconds + 5);
    if (kLimitsAddresses)
        limit(RLIMIT_AS, limits.memory + kAddressRoom, limits.memory + kAddressRoom);
    ::execv(argv[0], argv);
    ::_exit(kNotStarted);
}

// Whether it has ended within that time; then `status` tells how.
bool waitFor(pid_t pid, int& status, std::chrono::milliseconds time)
{
    const auto latest = std::chrono::steady_clock::now() + time;
    while (true) {
        const pid_t waited = ::waitpid(pid, &status, WNOHANG);
        if (waited == pid || (waited < 0 && errno != EINTR))
            return true;
        if (std::chrono::steady_clock::now() >= latest)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

}  // namespace

Result<WorkerProcess> WorkerProcess::start(const std::vector<std::string>& command,
                                           const ProcessLimits& limits)
{
    const auto refused = [](int error) {
        return failure("The importer cannot be started (" + std::generic_category().message(error) + ")",
                       "Close other programs and try again");
    };
    std::vector<std::string> words = command;
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return refused(errno);
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid == 0)
        becomeWorker(argv.data(), limits, ends[1], parent);
    const int error = errno;
    ::close(ends[1]);
    if (pid < 0) {
        ::close(ends[0]);
        return refused(error);
    }
    ::setpgid(pid, pid);  // whoever of the two comes first
    return WorkerProcess(pid, ends[0]);
}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept : pid_(other.pid_), output_(other.output_)
{
    other.pid_ = 0;
    other.output_ = -1;
}

WorkerProcess::~WorkerProcess()
{
    if (pid_ != 0)
        static_cast<void>(end());
    if (output_ >= 0)
        ::close(output_);
}

WorkerProcess::Reading WorkerProcess::read(std::string& text, int milliseconds)
{
    pollfd waiting{output_, POLLIN, 0};
    if (::poll(&waiting, 1, milliseconds) <= 0)
        return Reading::nothing;
    std::array<char, 65536> block{};
    const ssize_t count = ::read(output_, block.data(), block.size());
    if (count < 0)
        return errno == EINTR ? Reading::nothing : Reading::end;
    text.append(block.data(), static_cast<size_t>(count));
    return count == 0 ? Reading::end : Reading::some;
}

std::uint64_t WorkerProcess::residentBytes() const
{
    std::ifstream file("/proc/" + std::to_string(pid_) + "/statm");
    std::uint64_t all = 0;
    std::uint64_t resident = 0;
    if (!(file >> all >> resident))
        return 0;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

bool WorkerProcess::hasEnded() const
{
    siginfo_t info{};
    const int told = ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
    return told != 0 || info.si_pid == pid_;
}

int WorkerProcess::end()
{
    // Its group first: while it has not been waited for, nobody else can have its number.
    ::kill(-pid_, SIGKILL);
    ::kill(pid_, SIGKILL);
    int status = 0;
    // A process that waits for a disk that does not answer dies when the disk does: not our time.
    if (!waitFor(pid_, status, std::chrono::milliseconds(100)))
        std::thread([pid = pid_] {
            int late = 0;
            while (::waitpid(pid, &late, 0) < 0 && errno == EINTR) {
            }
        }).detach();
    pid_ = 0;
    return status;
}

}  // namespace knotspan::formats
