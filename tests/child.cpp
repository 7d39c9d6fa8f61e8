#include "tests/child.h"

#include <csignal>
#include <exception>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace knotspan::testing {

Child::Child(const std::function<int()>& work) : pid_(::fork())
{
    if (pid_ != 0)
        return;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    int code = 99;
    try {
        code = work();
    } catch (const std::exception&) {
    }
    ::_exit(code);
}

Child::~Child()
{
    kill();
}

int Child::wait()
{
    int status = 0;
    if (!status_ && ::waitpid(pid_, &status, 0) == pid_)
        status_ = status;
    const int ended = status_.value_or(0);
    return WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended);
}

bool Child::hasEnded()
{
    int status = 0;
    if (!status_ && ::waitpid(pid_, &status, WNOHANG) == pid_)
        status_ = status;
    return status_.has_value();
}

void Child::kill()
{
    if (hasEnded())
        return;
    ::kill(pid_, SIGKILL);
    static_cast<void>(wait());
}

}  // namespace knotspan::testing
