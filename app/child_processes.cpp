#include "app/child_processes.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace knotspan::app {

namespace {

// What it writes goes into nameless files: no pipe has to be emptied while it runs.
using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File namelessFile()
{
    File file(std::tmpfile(), &std::fclose);
    if (file)
        ::fcntl(::fileno(file.get()), F_SETFD, FD_CLOEXEC);
    return file;
}

std::string contentOf(const File& file)
{
    std::string content;
    std::rewind(file.get());
    char part[4096];
    for (size_t count = 0; (count = std::fread(part, 1, sizeof part, file.get())) > 0;)
        content.append(part, count);
    return content;
}

// Between fork() and exec() in a program with threads: only calls to the system.
[[noreturn]] void becomeProgram(char* const* argv, int output, int messages, pid_t parent)
{
    constexpr int kNotStarted = 127;
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    const int nothing = ::open("/dev/null", O_RDONLY);
    if (::getppid() != parent || nothing < 0 || ::dup2(nothing, STDIN_FILENO) < 0 ||
        ::dup2(output, STDOUT_FILENO) < 0 || ::dup2(messages, STDERR_FILENO) < 0)
        ::_exit(kNotStarted);
    ::execv("/proc/self/exe", argv);
    ::_exit(kNotStarted);
}

ChildRun runOne(std::vector<std::string> arguments)
{
    const auto start = std::chrono::steady_clock::now();
    ChildRun run;
    run.status = 127 << 8;
    const File output = namelessFile();
    const File messages = namelessFile();
    if (!output || !messages)
        return run;
    arguments.insert(arguments.begin(), "knotspan");
    std::vector<char*> argv;
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child < 0)
        return run;
    if (child == 0)
        becomeProgram(argv.data(), ::fileno(output.get()), ::fileno(messages.get()), parent);
    rusage usage{};
    while (::wait4(child, &run.status, 0, &usage) < 0 && errno == EINTR) {
    }
    run.output = contentOf(output);
    run.messages = contentOf(messages);
    run.peakMebibytes = static_cast<double>(usage.ru_maxrss) / 1024;
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return run;
}

}  // namespace

int ChildRun::exitCode() const
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool ChildRun::isDone() const
{
    return exitCode() == 0;
}

bool ChildRun::hasCrashed() const
{
    return exitCode() < 0 || exitCode() > 3;
}

std::string ChildRun::end() const
{
    return WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                               : "exit code " + std::to_string(WEXITSTATUS(status));
}

void runChildren(const std::vector<std::vector<std::string>>& calls, int atOnce,
                 const std::function<void(size_t call, const ChildRun& run)>& told)
{
    std::atomic<size_t> next{0};
    std::mutex telling;
    size_t nextTold = 0;
    std::map<size_t, ChildRun> ended;
    const auto work = [&] {
        for (size_t k = next++; k < calls.size(); k = next++) {
            ChildRun run = runOne(calls[k]);
            const std::scoped_lock lock(telling);
            ended.emplace(k, std::move(run));
            for (auto first = ended.find(nextTold); first != ended.end(); first = ended.find(++nextTold)) {
                told(nextTold, first->second);
                ended.erase(first);
            }
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < atOnce && static_cast<size_t>(k) < calls.size(); ++k)
        threads.emplace_back(work);
    for (std::thread& thread : threads)
        thread.join();
}

}  // namespace knotspan::app
