#include "model/files/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace knotspan::formats {

namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoDigit = 64;

constexpr std::array<std::uint8_t, 256> valuesOfDigits()
{
    std::array<std::uint8_t, 256> values{};
    values.fill(kNoDigit);
    for (std::uint8_t k = 0; k < kDigits.size(); ++k)
        values[static_cast<unsigned char>(kDigits[k])] = k;
    return values;
}

}  // namespace

std::string base64Of(std::span<const std::byte> bytes)
{
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t count = std::min<size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (size_t k = 0; k < 3; ++k)
            group = group << 8U | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0U);
        for (size_t k = 0; k < 4; ++k)
            text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

std::optional<std::vector<std::byte>> bytesOfBase64(std::string_view text)
{
    static constexpr auto kValues = valuesOfDigits();
    if (text.size() % 4 != 0)
        return std::nullopt;
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3);
    for (size_t i = 0; i < text.size(); i += 4) {
        size_t digits = 4;
        if (i + 4 == text.size() && text[i + 3] == '=')
            digits = text[i + 2] == '=' ? 2 : 3;
        std::uint32_t group = 0;
        for (size_t k = 0; k < 4; ++k) {
            const std::uint8_t value = k < digits ? kValues[static_cast<unsigned char>(text[i + k])] : 0;
            if (value == kNoDigit)
                return std::nullopt;
            group = group << 6U | value;
        }
        for (size_t k = 0; k + 1 < digits; ++k)
            bytes.push_back(static_cast<std::byte>(group >> (16 - 8 * k) & 255U));
    }
    return bytes;
}

}  // namespace knotspan::formats
