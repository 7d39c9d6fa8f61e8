#include <cstdint>

#include "tests/fuzz/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, size_t size)
{
    (void)knotspan::fuzz::readPly({reinterpret_cast<const char*>(data), size});
    return 0;
}
