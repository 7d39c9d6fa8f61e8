#include "model/mesh_files/gltf_file.h"

#include <algorithm>

#include "model/core/result.h"
#include "model/files/base64.h"
#include "model/files/binary_numbers.h"
#include "model/files/json_parsing.h"
#include "model/files/text_file.h"

namespace knotspan::formats {

using nlohmann::json;

namespace {

constexpr std::uint64_t kByte = 5121;
constexpr std::uint64_t kShort = 5123;
constexpr std::uint64_t kInt = 5125;
constexpr std::uint64_t kFloat = 5126;

std::uint64_t bytesOf(std::uint64_t type)
{
    return type == kByte ? 1 : type == kShort ? 2 : type == kInt || type == kFloat ? 4 : 0;
}

std::uint64_t wholeNumber(const json& value, const char* name)
{
    constexpr std::uint64_t kLargest = std::uint64_t{1} << 40U;  // products of two stay below 2^64
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kLargest)
        refuseGltf(std::string("The member ") + name + " is no whole number");
    return value.get<std::uint64_t>();
}

}  // namespace

void refuseGltf(const std::string& why)
{
    throw Error{why, {}, "Export the mesh again"};
}

std::uint64_t wholeMember(const json& object, const char* name)
{
    const auto member = object.find(name);
    if (member == object.end())
        refuseGltf(std::string("The member ") + name + " is missing");
    return wholeNumber(*member, name);
}

std::uint64_t wholeMember(const json& object, const char* name, std::uint64_t otherwise)
{
    return object.contains(name) ? wholeMember(object, name) : otherwise;
}

GltfFile::GltfFile(std::string_view bytes, const std::filesystem::path& folder)
{
    std::string_view text = bytes;
    if (bytes.substr(0, 4) == "glTF") {
        readContainer(bytes);
        text = bytes.substr(20, numberAt<std::uint32_t>(bytes, 12));
    }
    auto parsed = parsedJson(std::string(text));
    if (!parsed)
        throw parsed.error();
    root_ = *std::move(parsed);
    if (!root_.is_object() || !root_.contains("asset") || !root_["asset"].is_object())
        refuseGltf("The file is no glTF: it has no member asset");
    const json version = root_["asset"].value("version", json());
    if (!version.is_string() || version.get<std::string>().substr(0, 2) != "2.")
        refuseGltf("The file is no glTF of version 2");
    if (const auto needed = root_.find("extensionsRequired"); needed != root_.end() && !needed->empty())
        refuseGltf("The file needs an extension of glTF that is not read: " +
                   quoted(std::string_view(needed->dump(-1, ' ', true, json::error_handler_t::replace))));
    readBuffers(folder);
}

// Twelve bytes of head, a chunk of JSON, perhaps a chunk of numbers.
void GltfFile::readContainer(std::string_view bytes)
{
    constexpr std::uint32_t kJson = 0x4E4F534A;
    constexpr std::uint32_t kBinary = 0x004E4942;
    constexpr size_t kHeads = 20;
    if (bytes.size() < kHeads || numberAt<std::uint32_t>(bytes, 4) != 2 ||
        numberAt<std::uint32_t>(bytes, 16) != kJson)
        refuseGltf("The file is no .glb of version 2");
    const size_t jsonEnd = kHeads + numberAt<std::uint32_t>(bytes, 12);
    if (numberAt<std::uint32_t>(bytes, 8) > bytes.size() || jsonEnd > bytes.size())
        refuseGltf("The file ends in the middle of the mesh");
    if (jsonEnd + 8 > bytes.size())
        return;
    const size_t size = numberAt<std::uint32_t>(bytes, jsonEnd);
    if (size > bytes.size() - jsonEnd - 8)
        refuseGltf("The file ends in the middle of the mesh");
    if (numberAt<std::uint32_t>(bytes, jsonEnd + 4) == kBinary)
        binary_ = bytes.substr(jsonEnd + 8, size);
}

std::string GltfFile::bufferAt(const std::string& uri, const std::filesystem::path& folder) const
{
    if (uri.rfind("data:", 0) == 0) {
        const size_t start = uri.find(";base64,");
        const auto bytes = start == std::string::npos
                               ? std::nullopt
                               : bytesOfBase64(std::string_view(uri).substr(start + 8));
        if (!bytes)
            refuseGltf("A buffer inside the file is no base64");
        return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
    }
    // Only what was sent along with the file.
    const std::filesystem::path name = std::filesystem::path(uri).lexically_normal();
    if (uri.find(':') != std::string::npos || name.empty() || name.is_absolute() || *name.begin() == "..")
        refuseGltf("The file takes a buffer from a place outside its folder");
    const std::filesystem::path path = folder / name;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw Error{"The file " + path.string() + " is missing, which belongs to it",
                    {},
                    "Copy both into one folder"};
    auto text = wholeText(path, 2048, "bin");
    if (!text)
        throw text.error();
    return *std::move(text);
}

void GltfFile::readBuffers(const std::filesystem::path& folder)
{
    constexpr size_t kMostBuffers = 1000;
    const json list = root_.value("buffers", json::array());
    if (!list.is_array() || list.size() > kMostBuffers)
        refuseGltf("The buffers are no list of a sensible length");
    texts_.reserve(list.size());
    for (const json& buffer : list) {
        const bool hasUri = buffer.is_object() && buffer.contains("uri");
        if (hasUri) {
            if (!buffer["uri"].is_string())
                refuseGltf("A buffer's place is no text");
            texts_.push_back(bufferAt(buffer["uri"].get<std::string>(), folder));
        }
        buffers_.push_back(hasUri ? std::string_view(texts_.back()) : binary_);
    }
}

const json& GltfFile::element(const char* name, std::uint64_t index) const
{
    const auto list = root_.find(name);
    if (list == root_.end() || !list->is_array() || index >= list->size() || !(*list)[index].is_object())
        refuseGltf(std::string("The list ") + name + " has no element " + std::to_string(index));
    return (*list)[index];
}

GltfFile::View GltfFile::view(std::uint64_t accessor, const std::string& shape) const
{
    const json& from = element("accessors", accessor);
    if (from.contains("sparse") || !from.contains("bufferView"))
        refuseGltf("Sparse accessors are not read");
    if (from.value("type", json()) != shape)
        refuseGltf("An accessor is no " + shape);
    const json& view = element("bufferViews", wholeMember(from, "bufferView"));
    const std::uint64_t number = wholeMember(view, "buffer");
    if (number >= buffers_.size())
        refuseGltf("The list buffers has no element " + std::to_string(number));
    const std::string_view buffer = buffers_[number];
    const std::uint64_t type = wholeMember(from, "componentType");
    const std::uint64_t size = bytesOf(type) * (shape == "VEC3" ? 3 : 1);
    const std::uint64_t start = wholeMember(view, "byteOffset", 0);
    const std::uint64_t length = wholeMember(view, "byteLength");
    const std::uint64_t offset = wholeMember(from, "byteOffset", 0);
    const std::uint64_t stride = wholeMember(view, "byteStride", size);
    const std::uint64_t count = wholeMember(from, "count");
    if (size == 0)
        refuseGltf("An accessor has the unknown component type " + std::to_string(type));
    if (start > buffer.size() || length > buffer.size() - start || offset > length || stride < size ||
        stride > 255 || (count > 0 && (count - 1) * stride + size > length - offset))
        refuseGltf("An accessor reaches beyond its buffer");
    return {buffer.substr(start + offset, length - offset), count, stride, type};
}

std::vector<Vec3> GltfFile::vectors(std::uint64_t accessor) const
{
    const View from = view(accessor, "VEC3");
    if (from.type != kFloat)
        refuseGltf("Positions that are no floats are not read");
    std::vector<Vec3> result(from.count);
    for (std::uint64_t k = 0; k < from.count; ++k)
        for (int axis = 0; axis < 3; ++axis)
            result[k][axis] =
                numberAt<float>(from.bytes, k * from.stride + 4 * static_cast<std::uint64_t>(axis));
    return result;
}

std::vector<std::uint32_t> GltfFile::indices(std::uint64_t accessor) const
{
    const View from = view(accessor, "SCALAR");
    std::vector<std::uint32_t> result(from.count);
    for (std::uint64_t k = 0; k < from.count; ++k) {
        const size_t at = k * from.stride;
        result[k] = from.type == kByte    ? numberAt<std::uint8_t>(from.bytes, at)
                    : from.type == kShort ? numberAt<std::uint16_t>(from.bytes, at)
                                          : numberAt<std::uint32_t>(from.bytes, at);
    }
    return result;
}

}  // namespace knotspan::formats
