// The parts of a glTF 2.0 file (Khronos): the container of a .glb, its buffers, and the numbers in them.
// Throws Error where they are not what the standard says.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/core/space.h"

namespace knotspan::formats {

class GltfFile {
public:
    // Reads the buffers that lie beside the file, in `folder` or below.
    GltfFile(std::string_view bytes, const std::filesystem::path& folder);

    [[nodiscard]] const nlohmann::json& root() const { return root_; }
    // Element `index` of the list `name`; refuses one that is not there or no object.
    [[nodiscard]] const nlohmann::json& element(const char* name, std::uint64_t index) const;

    // What an accessor gives: three floats each, or whole numbers of any size.
    [[nodiscard]] std::vector<Vec3> vectors(std::uint64_t accessor) const;
    [[nodiscard]] std::vector<std::uint32_t> indices(std::uint64_t accessor) const;

private:
    struct View {
        std::string_view bytes;  // from its first element on
        std::uint64_t count = 0;
        std::uint64_t stride = 0;
        std::uint64_t type = 0;  // of a number: 5121 to 5126
    };
    [[nodiscard]] View view(std::uint64_t accessor, const std::string& shape) const;
    void readContainer(std::string_view bytes);
    void readBuffers(const std::filesystem::path& folder);
    [[nodiscard]] std::string bufferAt(const std::string& uri, const std::filesystem::path& folder) const;

    nlohmann::json root_;
    std::string_view binary_;  // the .glb's second chunk
    std::vector<std::string> texts_;
    std::vector<std::string_view> buffers_;
};

// A member that is a whole number from 0 on; `otherwise` where it is missing.
[[nodiscard]] std::uint64_t wholeMember(const nlohmann::json& object, const char* name,
                                        std::uint64_t otherwise);
[[nodiscard]] std::uint64_t wholeMember(const nlohmann::json& object, const char* name);

[[noreturn]] void refuseGltf(const std::string& why);

}  // namespace knotspan::formats
