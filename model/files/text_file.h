// Text files that others wrote, and the numbers in them, whatever the user's language calls a decimal point.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "model/core/result.h"

namespace knotspan::formats {

// The whole file. Refuses one of more than `mostMebibytes`; `extension` is that of its format, for the
// sentence.
[[nodiscard]] Result<std::string> wholeText(const std::filesystem::path& path, unsigned mostMebibytes,
                                            const std::string& extension);

// The number that the whole word is, with or without a sign; nothing where it is none, or none that is
// finite. What is too small for a double is 0.
[[nodiscard]] std::optional<double> numberIn(std::string_view word);
[[nodiscard]] std::optional<std::int64_t> integerIn(std::string_view word);

// The word in quotes for a sentence: cut where it is long, question marks for what cannot be shown.
[[nodiscard]] std::string quoted(std::string_view word);

// The text as a name: UTF-8 (what is not is taken for Latin-1), blanks for control characters, at most 255
// bytes.
[[nodiscard]] std::string nameIn(std::string_view text);

// Appends the shortest text that gives the same double again.
void append(std::string& text, double number);

}  // namespace knotspan::formats
