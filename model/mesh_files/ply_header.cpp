#include "model/mesh_files/ply_header.h"

#include <algorithm>
#include <map>

#include "model/core/result.h"
#include "model/files/text_file.h"

namespace knotspan::formats {

namespace {

[[noreturn]] void refuse(const std::string& why)
{
    throw Error{why, {}, "Export the mesh again"};
}

PlyType typeCalled(std::string_view name)
{
    static const std::map<std::string_view, PlyType> kTypes{
        {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
        {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
        {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
        {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
        {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
        {"float64", PlyType::float64}};
    const auto found = kTypes.find(name);
    if (found == kTypes.end())
        refuse("The head of the file names the unknown type " + quoted(name));
    return found->second;
}

std::vector<std::string_view> wordsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    for (size_t at = line.find_first_not_of(" \t\r"); at < line.size();
         at = line.find_first_not_of(" \t\r", at)) {
        const size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

void readFormat(const std::vector<std::string_view>& words, PlyHeader& header)
{
    if (words.size() < 2)
        refuse("The head of the file does not say its format");
    if (words[1] == "binary_little_endian")
        header.binary = std::endian::little;
    else if (words[1] == "binary_big_endian")
        header.binary = std::endian::big;
    else if (words[1] != "ascii")
        refuse("The file has the unknown format " + quoted(words[1]));
}

void readElement(const std::vector<std::string_view>& words, PlyHeader& header)
{
    constexpr size_t kMostElements = 100;
    const auto count = words.size() == 3 ? integerIn(words[2]) : std::nullopt;
    if (!count || *count < 0 || header.elements.size() == kMostElements)
        refuse("The head of the file does not say how many elements of a kind there are");
    header.elements.push_back({std::string(words[1]), static_cast<std::uint64_t>(*count), {}});
}

void readProperty(const std::vector<std::string_view>& words, PlyHeader& header)
{
    constexpr size_t kMostProperties = 1000;
    const bool isList = words.size() == 5 && words[1] == "list";
    if (header.elements.empty() || (words.size() != 3 && !isList) ||
        header.elements.back().properties.size() == kMostProperties)
        refuse("The head of the file has a property that cannot be understood");
    PlyProperty property{std::string(words.back()), typeCalled(words[words.size() - 2]), {}};
    if (isList)
        property.count = typeCalled(words[2]);
    header.elements.back().properties.push_back(std::move(property));
}

}  // namespace

size_t sizeOf(PlyType type)
{
    constexpr size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<size_t>(type)];
}

PlyHeader plyHeaderOf(std::string_view bytes)
{
    constexpr size_t kLongest = 1U << 20U;
    PlyHeader header;
    bool hasFormat = false;
    bool isFirst = true;
    while (header.size < std::min(bytes.size(), kLongest)) {
        const size_t end = bytes.find('\n', header.size);
        if (end == std::string_view::npos)
            break;
        const auto words = wordsOf(bytes.substr(header.size, end - header.size));
        header.size = end + 1;
        if (isFirst && (words.empty() || words[0] != "ply"))
            refuse("The file does not begin as PLY files do");
        isFirst = false;
        if (words.empty())
            continue;
        if (words[0] == "end_header" && hasFormat)
            return header;
        if (words[0] == "format") {
            readFormat(words, header);
            hasFormat = true;
        } else if (words[0] == "element") {
            readElement(words, header);
        } else if (words[0] == "property") {
            readProperty(words, header);
        }
    }
    refuse("The file is no PLY: its head does not end");
}

}  // namespace knotspan::formats
