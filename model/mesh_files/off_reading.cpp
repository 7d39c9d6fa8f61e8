#include <vector>

#include "model/files/text_file.h"
#include "model/files/text_statements.h"
#include "model/mesh_files/mesh_building.h"
#include "model/mesh_files/mesh_reading.h"

namespace knotspan::formats {

namespace {

// Geomview's format as text: OFF, then the numbers of vertices, faces and edges, then those. Behind a vertex
// its normal, colour or texture may stand, behind a face its colour; which they are says the first word
// (STCNOFF).
class OffReader {
public:
    explicit OffReader(std::string_view text) : words_(text), size_(text.size()) {}

    [[nodiscard]] TriangleMesh read() &&
    {
        const std::string_view keyword = words_.next();
        if (keyword.size() < 3 || keyword.substr(keyword.size() - 3) != "OFF")
            throw Error{"The file does not begin with OFF", {}, "Choose another file"};
        const std::string_view kind = keyword.substr(0, keyword.size() - 3);
        if (kind.find_first_not_of("STCN") != std::string_view::npos)
            words_.refuse("Files of the kind " + quoted(keyword) + " are not read, only of three dimensions");
        std::string_view first = words_.word();
        if (first == "BINARY")
            words_.refuse("Binary OFF files are not read");
        if (first.empty())
            first = words_.next();
        const size_t vertices = count(first, "vertices");
        const size_t faces = count(next(), "faces");
        building_.reserve(vertices, faces);
        for (size_t k = 0; k < vertices; ++k)
            addVertex();
        for (size_t k = 0; k < faces; ++k)
            addFace();
        return building_.take();
    }

private:
    // Of this line or those after it.
    std::string_view next()
    {
        const std::string_view word = words_.word();
        return word.empty() ? words_.next() : word;
    }

    // Each of them has at least a digit and a blank.
    [[nodiscard]] size_t count(std::string_view word, const std::string& what) const
    {
        const auto number = integerIn(word);
        if (!number || *number < 0)
            words_.refuse("The number of " + what + " is none, but " + quoted(word));
        if (static_cast<size_t>(*number) > size_ / 2)
            words_.refuse("The file says that it has " + std::to_string(*number) + " " + what +
                          ", but it is too short for them");
        return static_cast<size_t>(*number);
    }

    // On a line of its own: what stands behind does not matter.
    void addVertex()
    {
        Vec3 position;
        position.x = words_.numberOf(words_.next(), "The coordinate x");
        position.y = words_.numberOf(next(), "The coordinate y");
        position.z = words_.numberOf(next(), "The coordinate z");
        building_.vertex(position);
    }

    void addFace()
    {
        const size_t corners = count(words_.next(), "corners");
        corners_.clear();
        for (size_t k = 0; k < corners; ++k) {
            const std::string_view word = next();
            const auto number = integerIn(word);
            if (!number || *number < 0 || *number >= static_cast<std::int64_t>(building_.vertices()))
                words_.refuse("There is no vertex " + quoted(word) + ": the file has " +
                              std::to_string(building_.vertices()));
            corners_.push_back(static_cast<std::uint32_t>(*number));
        }
        if (corners > 2)  // some programs write edges and points as faces
            building_.polygon(corners_);
    }

    TextStatements words_;
    size_t size_;
    MeshBuilding building_;
    std::vector<std::uint32_t> corners_;
};

}  // namespace

Result<TriangleMesh> meshFromOff(std::string_view bytes)
{
    try {
        return OffReader(bytes).read();
    } catch (const Error& error) {
        return tl::unexpected(error);
    }
}

}  // namespace knotspan::formats
