#include "model/files/text_file.h"

#include <charconv>
#include <cmath>
#include <fstream>

#include "model/core/check.h"

namespace knotspan::formats {

namespace {

// std::from_chars knows no plus sign.
std::string_view withoutPlus(std::string_view word)
{
    const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
    return plus ? word.substr(1) : word;
}

// How many bytes the character at the start of `text` has; 0 where it is not UTF-8.
size_t utf8Length(std::string_view text)
{
    const auto byte = [&](size_t k) { return static_cast<unsigned char>(text[k]); };
    const size_t length = byte(0) < 0x80   ? 1
                          : byte(0) < 0xC2 ? 0
                          : byte(0) < 0xE0 ? 2
                          : byte(0) < 0xF0 ? 3
                                           : 4;
    if (length == 0 || length > text.size() || byte(0) > 0xF4)
        return 0;
    for (size_t k = 1; k < length; ++k)
        if ((byte(k) & 0xC0) != 0x80)
            return 0;
    // Written longer than needed; half of a UTF-16 pair; above the last character.
    const bool wrong = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) > 0x9F) ||
                       (byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) > 0x8F);
    return wrong ? 0 : length;
}

}  // namespace

Result<std::string> wholeText(const std::filesystem::path& path, unsigned mostMebibytes,
                              const std::string& extension)
{
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error)
        return failure("The file's size cannot be told: " + error.message());
    if (size > std::uintmax_t{mostMebibytes} << 20)
        return failure("The file is larger than the " + std::to_string(mostMebibytes) + " MiB that a ." +
                           extension + " file may have",
                       "Split the model into several files");
    std::string text(static_cast<size_t>(size), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(text.data(), static_cast<std::streamsize>(size));
    if (!file)
        return failure("The file cannot be read to its end");
    return text;
}

std::optional<double> numberIn(std::string_view word)
{
    word = withoutPlus(word);
    const char* const end = word.data() + word.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end)
        return std::nullopt;
    // Too large and too small are one error.
    if (error == std::errc::result_out_of_range && word.find_last_of("eE") != std::string_view::npos &&
        word[word.find_last_of("eE") + 1] == '-')
        return 0.0;
    return error == std::errc() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::int64_t> integerIn(std::string_view word)
{
    word = withoutPlus(word);
    const char* const end = word.data() + word.size();
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

std::string quoted(std::string_view word)
{
    constexpr size_t kLongest = 24;
    std::string text = "\"";
    for (const char c : word.substr(0, kLongest))
        text += c >= ' ' && c <= '~' ? c : '?';
    return text + (word.size() > kLongest ? "...\"" : "\"");
}

std::string nameIn(std::string_view text)
{
    constexpr size_t kLongest = 255;
    std::string name;
    while (!text.empty()) {
        const size_t length = utf8Length(text);
        const auto first = static_cast<unsigned char>(text[0]);
        std::string character(text.substr(0, length));
        if (length == 0)
            character = {static_cast<char>(0xC0 | first >> 6), static_cast<char>(0x80 | (first & 0x3F))};
        else if (first < ' ' || first == 0x7F)
            character = " ";
        if (name.size() + character.size() > kLongest)
            break;
        name += character;
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return name;
}

void append(std::string& text, double number)
{
    char digits[32];
    const auto [end, error] = std::to_chars(std::begin(digits), std::end(digits), number);
    check(error == std::errc(), "the shortest text of a double fits into 32 characters");
    text.append(digits, end);
}

}  // namespace knotspan::formats
