// Writes a mesh's file: collects numbers and texts, so that one costs no call to the system.
#pragma once

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace knotspan::formats {

class MeshOutput {
public:
    explicit MeshOutput(const std::filesystem::path& path) : file_(path, std::ios::binary) {}

    MeshOutput& text(std::string_view text)
    {
        buffer_.append(text);
        if (buffer_.size() > kFull)
            flush();
        return *this;
    }
    template <class Number>
    MeshOutput& number(Number value)
    {
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
        return text({digits, static_cast<size_t>(end - digits)});
    }
    // Least byte first.
    template <class Number>
    MeshOutput& bytes(Number value)
    {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        if constexpr (std::endian::native == std::endian::big)
            std::reverse(raw, raw + sizeof raw);
        return text({raw, sizeof raw});
    }
    [[nodiscard]] bool close()
    {
        flush();
        file_.close();
        return !file_.fail();
    }

private:
    static constexpr size_t kFull = 1U << 20U;

    void flush()
    {
        file_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
        buffer_.clear();
    }

    std::ofstream file_;
    std::string buffer_;
};

}  // namespace knotspan::formats
