#include "app/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

#include "model/formats/format_list.h"

namespace knotspan::app {

namespace {

std::optional<double> finiteNumber(const std::string& text)
{
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
        return {};
    return value;
}

std::string shortText(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g", number);
    return text;
}

std::vector<std::string> writableExtensions()
{
    std::vector<std::string> extensions;
    for (const formats::Format& format : formats::all())
        if (format.write != nullptr)
            extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
    return extensions;
}

}  // namespace

void addModel(CLI::App& command, std::string& file)
{
    command.add_option("FILE", file, "Model to read")->required();
}

void addJson(CLI::App& command, bool& json)
{
    command.add_flag("--json", json, "As one JSON object");
}

double parseNumber(const std::string& option, const std::string& text)
{
    const auto value = finiteNumber(text);
    if (!value)
        throw CLI::ValidationError(option, "'" + text + "' is no number");
    return *value;
}

CLI::Validator within(double low, double high)
{
    const auto check = [low, high](const std::string& text) -> std::string {
        const auto value = finiteNumber(text);
        if (value && *value >= low && *value <= high)
            return {};
        return "'" + text + "' should be a number from " + shortText(low) + " to " + shortText(high);
    };
    return {check, ""};
}

CLI::Validator wholeWithin(int low, int high)
{
    const auto check = [low, high](const std::string& text) -> std::string {
        int value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size() && value >= low && value <= high)
            return {};
        return "'" + text + "' should be a whole number from " + std::to_string(low) + " to " +
               std::to_string(high);
    };
    return {check, ""};
}

std::vector<std::string> splitAtCommas(const std::string& text)
{
    std::vector<std::string> parts;
    for (size_t start = 0; start <= text.size();) {
        const size_t comma = std::min(text.find(',', start), text.size());
        parts.push_back(text.substr(start, comma - start));
        start = comma + 1;
    }
    return parts;
}

std::vector<double> parseNumbers(const std::string& option, const std::string& text, size_t count)
{
    std::vector<double> numbers;
    for (const std::string& part : splitAtCommas(text))
        numbers.push_back(parseNumber(option, part));
    if (numbers.size() != count)
        throw CLI::ValidationError(option, "'" + text + "' should be " + std::to_string(count) +
                                               " numbers with commas between them");
    return numbers;
}

Vec3 parseVec3(const std::string& option, const std::string& text)
{
    const auto numbers = parseNumbers(option, text, 3);
    return {numbers[0], numbers[1], numbers[2]};
}

PixelSize parseSize(const std::string& option, const std::string& text)
{
    constexpr int kLargest = 16384;
    PixelSize size;
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    const bool widthIsGood = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height = widthIsGood ? std::from_chars(width.ptr + 1, end, size.height) : width;
    const auto fits = [](int pixels) { return pixels >= 1 && pixels <= kLargest; };
    if (!widthIsGood || height.ec != std::errc() || height.ptr != end || !fits(size.width) ||
        !fits(size.height))
        throw CLI::ValidationError(option, "'" + text + "' should be like 1280x800, each 1 to 16384");
    return size;
}

void refuseName(const std::string& option, const std::string& text, const std::vector<std::string>& names)
{
    throw CLI::ValidationError(option, "'" + text + "' is not known; known are " + joined(names, ", "));
}

bool isSameFile(const std::string& a, const std::string& b)
{
    std::error_code unknown;
    const auto whole = [&](const std::string& path) {
        return std::filesystem::weakly_canonical(path, unknown);
    };
    return !a.empty() && whole(a) == whole(b);
}

void checkOutput(const std::string& option, const std::string& path, const std::string& extension,
                 const std::string& model)
{
    if (std::filesystem::path(path).extension() != extension)
        throw CLI::ValidationError(option, "'" + path + "' should end in " + extension);
    if (isSameFile(path, model))
        throw CLI::ValidationError(option, "'" + path + "' is the model; choose another file");
}

std::string joined(const std::vector<std::string>& texts, const std::string& separator)
{
    std::string result;
    for (const std::string& text : texts)
        result += (result.empty() ? "" : separator) + text;
    return result;
}

void checkWritable(const std::string& option, const std::filesystem::path& path, const std::string& also)
{
    const formats::Format* format = formats::find(path);
    if (format != nullptr && format->write != nullptr)
        return;
    throw CLI::ValidationError(option, "'" + path.string() +
                                           "' has no format that can be written; known are " +
                                           joined(writableExtensions(), ", ") + also);
}

}  // namespace knotspan::app
