// Stops the program where one of our own beliefs is wrong, in release builds too: a bug found by a crash is
// better than a model that is silently damaged. Failures of the outside world are Result<T> (result.h).
#pragma once

namespace knotspan {

[[noreturn]] void failedCheck(const char* belief, const char* file, int line);

// `belief` states what should hold: check(i < size, "the index lies inside the net").
inline void check(bool holds, const char* belief, const char* file = __builtin_FILE(),
                  int line = __builtin_LINE())
{
    if (!holds)
        failedCheck(belief, file, line);
}

}  // namespace knotspan
