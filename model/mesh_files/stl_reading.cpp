#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "model/files/binary_numbers.h"
#include "model/files/text_file.h"
#include "model/files/text_statements.h"
#include "model/mesh_files/mesh_building.h"
#include "model/mesh_files/mesh_reading.h"

namespace knotspan::formats {

namespace {

constexpr size_t kHeader = 84;  // 80 bytes of any text, and how many triangles follow
constexpr size_t kRecord = 50;  // a normal, three corners, two bytes for anything

std::string lowered(std::string_view word)
{
    std::string lower(word.substr(0, 16));
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

TriangleMesh fromBinary(std::string_view bytes, size_t count)
{
    MeshBuilding building;
    building.reserve(count / 2, count);
    for (size_t k = 0; k < count; ++k) {
        std::array<std::uint32_t, 3> corners{};
        for (size_t corner = 0; corner < 3; ++corner) {
            Vec3 position;
            for (int axis = 0; axis < 3; ++axis)
                position[axis] = numberAt<float>(bytes, kHeader + k * kRecord + 12 * (corner + 1) +
                                                            4 * static_cast<size_t>(axis));
            corners[corner] = building.weldedVertex(position);
        }
        building.polygon(corners);
    }
    return building.take();
}

// Word by word, however they are spread over lines.
TriangleMesh fromText(std::string_view text)
{
    MeshBuilding building;
    std::vector<std::uint32_t> corners;
    TextStatements words(text);
    const auto next = [&] {
        const std::string_view word = words.word();
        return word.empty() ? words.next() : word;
    };
    for (std::string_view word = next(); !word.empty(); word = next()) {
        const std::string keyword = lowered(word);
        if (keyword == "vertex") {
            Vec3 position;
            for (int axis = 0; axis < 3; ++axis)
                position[axis] = words.numberOf(next(), "The coordinate");
            corners.push_back(building.weldedVertex(position));
        } else if (keyword == "endloop") {
            building.polygon(corners);
            corners.clear();
        } else if (keyword == "solid" || keyword == "endsolid") {
            (void)words.rest();
        } else if (keyword == "normal") {  // the corners tell it, and this one may be wrong or no number
            for (int axis = 0; axis < 3; ++axis)
                (void)next();
        } else if (keyword != "facet" && keyword != "outer" && keyword != "loop" && keyword != "endfacet") {
            words.refuse(quoted(word) + " is no word of STL files");
        }
    }
    return building.take();
}

bool beginsAsText(std::string_view bytes)
{
    const size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    return lowered(bytes.substr(start, 5)) == "solid";
}

}  // namespace

Result<TriangleMesh> meshFromStl(std::string_view bytes)
{
    try {
        const std::uint64_t count = bytes.size() >= kHeader ? numberAt<std::uint32_t>(bytes, 80) : 0;
        const std::uint64_t size = kHeader + kRecord * count;
        // Binary files may begin as text, too: then their size tells.
        if (bytes.size() < kHeader || (beginsAsText(bytes) && size != bytes.size())) {
            if (!beginsAsText(bytes))
                return failure("The file is no STL: it is too short", "Choose another file");
            return fromText(bytes);
        }
        if (size > bytes.size())
            return failure("The file should have " + std::to_string(count) + " triangles but ends after " +
                               std::to_string((bytes.size() - kHeader) / kRecord),
                           "Export or copy the mesh again");
        return fromBinary(bytes, count);
    } catch (const Error& error) {
        return tl::unexpected(error);
    }
}

}  // namespace knotspan::formats
