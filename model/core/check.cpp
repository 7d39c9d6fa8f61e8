#include "model/core/check.h"

#include <cstdio>
#include <cstdlib>

namespace knotspan {

void failedCheck(const char* belief, const char* file, int line)
{
    std::fprintf(stderr, "Knotspan stopped because of a mistake in itself: not true that %s (%s:%d).\n",
                 belief, file, line);
    std::abort();
}

}  // namespace knotspan
