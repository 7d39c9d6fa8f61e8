#include <array>
#include <cmath>
#include <vector>

#include "model/files/binary_numbers.h"
#include "model/files/text_file.h"
#include "model/mesh_files/mesh_building.h"
#include "model/mesh_files/mesh_reading.h"
#include "model/mesh_files/ply_header.h"

namespace knotspan::formats {

namespace {

[[noreturn]] void refuse(const std::string& why)
{
    throw Error{why, {}, "Export or copy the mesh again"};
}

// The numbers behind the head, in order.
class PlyNumbers {
public:
    PlyNumbers(std::string_view bytes, const PlyHeader& header)
        : bytes_(bytes),
          at_(header.size),
          binary_(header.binary)
    {
    }

    [[nodiscard]] double next(PlyType type) { return binary_ ? nextBinary(type) : nextText(); }

    // Of a list; no more than the rest of the file has room for.
    [[nodiscard]] size_t nextLength(const PlyProperty& list)
    {
        const double length = next(*list.count);
        if (!(length >= 0) || length != std::floor(length) || length > room(sizeOf(list.type)))
            refuse("A list is longer than the file");
        return static_cast<size_t>(length);
    }

    // The file's claims are held against what is left of it before they cost anything.
    void requireRoomFor(const PlyElement& element) const
    {
        size_t least = 0;
        for (const PlyProperty& property : element.properties)
            least += binary_ ? sizeOf(property.count ? *property.count : property.type) : 2;
        const double room = static_cast<double>(bytes_.size() - at_ + (binary_ ? 0 : 1));
        if (static_cast<double>(element.count) > room / static_cast<double>(std::max<size_t>(least, 1)))
            refuse("The file says that it has " + std::to_string(element.count) + " elements " +
                   quoted(std::string_view(element.name)) + ", but it is too short for them");
    }

private:
    [[nodiscard]] double room(size_t bytesEach) const
    {
        const size_t each = binary_ ? bytesEach : 2;
        return static_cast<double>(bytes_.size() - at_ + (binary_ ? 0 : 1)) / static_cast<double>(each);
    }

    template <class Number>
    double take()
    {
        if (bytes_.size() - at_ < sizeof(Number))
            refuse("The file ends in the middle of the mesh");
        const auto number = numberAt<Number>(bytes_, at_, *binary_);
        at_ += sizeof(Number);
        return static_cast<double>(number);
    }

    double nextBinary(PlyType type)
    {
        switch (type) {
        case PlyType::int8:
            return take<std::int8_t>();
        case PlyType::uint8:
            return take<std::uint8_t>();
        case PlyType::int16:
            return take<std::int16_t>();
        case PlyType::uint16:
            return take<std::uint16_t>();
        case PlyType::int32:
            return take<std::int32_t>();
        case PlyType::uint32:
            return take<std::uint32_t>();
        case PlyType::float32:
            return take<float>();
        case PlyType::float64:
            break;
        }
        return take<double>();
    }

    double nextText()
    {
        constexpr std::string_view kBlanks = " \t\r\n\v\f";
        at_ = std::min(bytes_.find_first_not_of(kBlanks, at_), bytes_.size());
        const size_t end = std::min(bytes_.find_first_of(kBlanks, at_), bytes_.size());
        if (at_ == end)
            refuse("The file ends in the middle of the mesh");
        const std::string_view word = bytes_.substr(at_, end - at_);
        at_ = end;
        const auto number = numberIn(word);
        if (!number)
            refuse(quoted(word) + " is no finite number");
        return *number;
    }

    std::string_view bytes_;
    size_t at_;
    std::optional<std::endian> binary_;
};

class PlyReader {
public:
    explicit PlyReader(std::string_view bytes) : header_(plyHeaderOf(bytes)), numbers_(bytes, header_) {}

    [[nodiscard]] TriangleMesh read() &&
    {
        for (const PlyElement& element : header_.elements) {
            if (element.properties.empty())
                continue;
            numbers_.requireRoomFor(element);
            if (element.name == "vertex")
                requireCoordinates(element);
            for (std::uint64_t k = 0; k < element.count; ++k)
                element.name == "vertex" ? addVertex(element)
                : element.name == "face" ? addFace(element)
                                         : skip(element);
        }
        return building_.take();
    }

private:
    static void requireCoordinates(const PlyElement& element)
    {
        for (const char* axis : {"x", "y", "z"})
            if (std::none_of(element.properties.begin(), element.properties.end(),
                             [&](const PlyProperty& p) { return p.name == axis && !p.count; }))
                refuse(std::string("The vertices have no coordinate ") + axis);
    }

    void skip(const PlyProperty& property)
    {
        size_t count = 1;
        if (property.count)
            count = numbers_.nextLength(property);
        for (size_t k = 0; k < count; ++k)
            (void)numbers_.next(property.type);
    }

    void skip(const PlyElement& element)
    {
        for (const PlyProperty& property : element.properties)
            skip(property);
    }

    void addVertex(const PlyElement& element)
    {
        Vec3 position(0);
        for (const PlyProperty& property : element.properties) {
            const bool isAxis = !property.count && property.name.size() == 1 && property.name[0] >= 'x' &&
                                property.name[0] <= 'z';
            if (isAxis)
                position[property.name[0] - 'x'] = numbers_.next(property.type);
            else
                skip(property);
        }
        building_.vertex(position);
    }

    void addFace(const PlyElement& element)
    {
        corners_.clear();
        for (const PlyProperty& property : element.properties) {
            const bool isPolygon =
                property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
            if (!isPolygon) {
                skip(property);
                continue;
            }
            const size_t count = numbers_.nextLength(property);
            for (size_t k = 0; k < count; ++k)
                addCorner(numbers_.next(property.type));
        }
        if (corners_.size() > 2)  // some programs write edges and points as faces
            building_.polygon(corners_);
    }

    void addCorner(double number)
    {
        if (!(number >= 0) || number >= static_cast<double>(building_.vertices()) ||
            number != std::floor(number))
            refuse("A polygon names a vertex that is not there");
        corners_.push_back(static_cast<std::uint32_t>(number));
    }

    PlyHeader header_;
    PlyNumbers numbers_;
    MeshBuilding building_;
    std::vector<std::uint32_t> corners_;
};

}  // namespace

Result<TriangleMesh> meshFromPly(std::string_view bytes)
{
    try {
        return PlyReader(bytes).read();
    } catch (const Error& error) {
        return tl::unexpected(error);
    }
}

}  // namespace knotspan::formats
