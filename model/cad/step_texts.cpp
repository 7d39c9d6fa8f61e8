#include "model/cad/step_texts.h"

#include <charconv>
#include <cstdint>
#include <cstdio>

#include "model/files/text_file.h"

namespace knotspan::formats {
namespace {

constexpr std::string_view kStandIn = "'knotspan text ";

// The character that `utf8`, which is valid, begins with; cut off there.
std::uint32_t takeCharacter(std::string_view& utf8)
{
    const auto first = static_cast<unsigned char>(utf8[0]);
    const size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    std::uint32_t character = length == 1 ? first : first & (0x7Fu >> length);
    for (size_t k = 1; k < length; ++k)
        character = character << 6 | (static_cast<unsigned char>(utf8[k]) & 0x3Fu);
    utf8.remove_prefix(length);
    return character;
}

// The escape that a run of such characters stands in; empty: none.
std::string_view escapeFor(std::uint32_t character)
{
    return character < 0x80 ? "" : character < 0x10000 ? "\\X2\\" : "\\X4\\";
}

void append(std::string& text, std::uint32_t character)
{
    if (character >= 0x80) {
        char digits[12];
        std::snprintf(digits, sizeof digits, character < 0x10000 ? "%04X" : "%08X", character);
        text += digits;
        return;
    }
    text += static_cast<char>(character);
    if (character == '\'' || character == '\\')
        text += static_cast<char>(character);
}

}  // namespace

std::string stepText(std::string_view utf8)
{
    const std::string name = nameIn(utf8);
    std::string text = "'";
    std::string_view escape;
    for (std::string_view rest = name; !rest.empty();) {
        const std::uint32_t character = takeCharacter(rest);
        if (const std::string_view next = escapeFor(character); next != escape) {
            text += escape.empty() ? "" : "\\X0\\";
            text += next;
            escape = next;
        }
        append(text, character);
    }
    return text + (escape.empty() ? "'" : "\\X0\\'");
}

std::string StepTexts::standInFor(std::string_view utf8)
{
    texts_.push_back(stepText(utf8));
    return std::string(kStandIn.substr(1)) + std::to_string(texts_.size() - 1);
}

std::string StepTexts::replacedIn(std::string line) const
{
    for (size_t at = line.find(kStandIn); at != std::string::npos; at = line.find(kStandIn, at)) {
        const size_t number = at + kStandIn.size();
        size_t index = 0;
        const char* const end = line.data() + line.size();
        const auto parsed = std::from_chars(line.data() + number, end, index);
        if (parsed.ec != std::errc() || parsed.ptr == end || *parsed.ptr != '\'' || index >= texts_.size())
            return line;
        line.replace(at, static_cast<size_t>(parsed.ptr - line.data()) + 1 - at, texts_[index]);
        at += texts_[index].size();
    }
    return line;
}

}  // namespace knotspan::formats
