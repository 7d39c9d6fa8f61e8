// Another program, started for one piece of work: what it may use up, what it writes, and its certain end.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <sys/types.h>

#include "model/core/result.h"

namespace knotspan::formats {

struct ProcessLimits {
    std::uint64_t memory = 0;     // bytes; the system's own limit lies a fixed room for libraries above it
    unsigned cpuSeconds = 600;    // of computing
    unsigned wallSeconds = 1200;  // in all: for who supervises it
    std::uint64_t output = 0;     // bytes it may write: for who supervises it
};

// Runs in a process group of its own, with nothing open but its standard output, which comes here; writes no
// files, leaves no core, dies with the thread that started it, and is the first to go when memory runs out.
class WorkerProcess {
public:
    // command[0] is the path of the program.
    [[nodiscard]] static Result<WorkerProcess> start(const std::vector<std::string>& command,
                                                     const ProcessLimits& limits);
    // Ends it and all it started, if they still run. Takes milliseconds.
    ~WorkerProcess();
    WorkerProcess(WorkerProcess&& other) noexcept;
    WorkerProcess& operator=(WorkerProcess&&) = delete;
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;

    enum class Reading { some, nothing, end };
    // Appends what it wrote, waiting for it no longer than that. `end`: it will write no more.
    [[nodiscard]] Reading read(std::string& text, int milliseconds);

    // Memory it has in use; 0 where that cannot be told.
    [[nodiscard]] std::uint64_t residentBytes() const;
    // It has ended by itself, or been ended.
    [[nodiscard]] bool hasEnded() const;

    // How it ended, as waitpid() tells; ends it if it has not. Once.
    [[nodiscard]] int end();

private:
    WorkerProcess(pid_t pid, int output) : pid_(pid), output_(output) {}

    pid_t pid_;  // 0: waited for
    int output_;
};

}  // namespace knotspan::formats
