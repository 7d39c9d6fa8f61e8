// Another process, to be killed: what a test shows of a crash, it shows by one.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <sys/types.h>

namespace knotspan::testing {

class Child {
public:
    // Runs the function in a copy of this process, which ends with what it returns.
    explicit Child(const std::function<int()>& work);
    // Kills it where it still runs.
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // The exit code, once it has ended by itself; 128 + the signal's number where one ended it.
    [[nodiscard]] int wait();
    [[nodiscard]] bool hasEnded();
    // As the kernel does it: nothing in the process hears of it.
    void kill();

private:
    pid_t pid_ = 0;
    std::optional<int> status_;
};

}  // namespace knotspan::testing
