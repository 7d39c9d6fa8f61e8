// The head of a PLY file: what its elements are made of.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knotspan::formats {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] size_t sizeOf(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> count;  // of a list: what its length is written as
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    std::optional<std::endian> binary;  // which byte of a number comes first; nothing: text
    std::vector<PlyElement> elements;
    size_t size = 0;  // bytes up to the first element
};

// Throws Error where it is none.
[[nodiscard]] PlyHeader plyHeaderOf(std::string_view bytes);

}  // namespace knotspan::formats
