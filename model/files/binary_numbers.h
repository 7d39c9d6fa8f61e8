// Numbers in binary files, and in files' byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace knotspan::formats {

// At that byte, which must lie inside with all of the number; of any alignment.
template <class Number>
[[nodiscard]] Number numberAt(std::string_view bytes, size_t at, std::endian order = std::endian::little)
{
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes.data() + at, raw.size());
    if (order != std::endian::native)
        std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Number>(raw);
}

}  // namespace knotspan::formats
