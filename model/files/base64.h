// Numbers as text, bit for bit: RFC 4648's base64 of their bytes, the lowest first.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knotspan::formats {

[[nodiscard]] std::string base64Of(std::span<const std::byte> bytes);
// Nothing where the text is no base64, padding and all.
[[nodiscard]] std::optional<std::vector<std::byte>> bytesOfBase64(std::string_view text);

}  // namespace knotspan::formats
