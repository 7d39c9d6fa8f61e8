#include "tests/model/formats/hostile_files.h"

#include <cstdint>
#include <cstring>

#include "model/formats/format_list.h"
#include "model/mesh_files/mesh_files.h"
#include "model/samples/sample_list.h"
#include "tests/model/formats/obj_text.h"
#include "tests/support.h"

namespace knotspan::testing {

namespace {

// A rational surface, closed and with poles; and one that is trimmed.
Scene wholeScene()
{
    Scene scene = findSample("sphere")->make();
    const Scene trimmed = sceneOf(sixVertices() + polygon("0.25 0.25  0.75 0.25  0.75 0.75  0.25 0.25") +
                                  sixPointSurface("trim 0 3 1\n"));
    for (const auto& [id, object] : trimmed.objects())
        scene.add(*object);
    return scene;
}

TriangleMesh wholeMesh()
{
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    return mesh;
}

std::string bptText()
{
    std::string text = "2\n";
    for (const int rows : {4, 2}) {
        text += rows == 4 ? "3 3\n" : "1 2\n";
        for (int k = 0; k < (rows == 4 ? 16 : 6); ++k)
            text += std::to_string(k % 4) + ".5 " + std::to_string(k / 4) + " -1e-3\n";
    }
    return text;
}

// Two nodes, a mesh, an accessor, a buffer in the text.
std::string gltfText()
{
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"children": [1], "scale": [2, 2, 2]}, {"mesh": 0, "name": "one"}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)"
           R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

}  // namespace

std::string handWrittenFile(const std::string& extension)
{
    if (extension == "bpt")
        return bptText();
    if (extension == "gltf")
        return gltfText();
    if (extension == "ply")
        return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
               "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
               "0\n3 "
               "0 1 2\n";
    if (extension == "stl")
        return "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
               "0\nendloop\nendfacet\nendsolid one\n";
    if (extension == "off")
        return "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    return {};
}

std::vector<HostileFile> wholeFilesOf(const formats::Format& format, const std::filesystem::path& scratch)
{
    std::vector<HostileFile> files;
    const std::string& first = format.extensions.front();
    const auto path = scratch / ("whole." + first);
    if (format.write != nullptr) {
        if (formats::write(wholeScene(), path))
            files.push_back({"as we write it", first, readFile(path)});
    } else if (const auto kind = formats::meshKindOf(path)) {
        if (formats::writeMeshTo(path, wholeMesh(), *kind, "mm"))
            files.push_back({"as we write it", first, readFile(path)});
    }
    for (const std::string& extension : format.extensions)
        if (const std::string text = handWrittenFile(extension); !text.empty())
            files.push_back({"by hand", extension, text});
    return files;
}

std::vector<HostileFile> cyclicFilesOf(const HostileFile& whole)
{
    const std::string& text = whole.content;
    std::string cyclic;
    if (whole.extension == "step") {
        // The first reference of every list of references becomes the record's own number.
        std::string number;
        for (size_t at = 0; at < text.size(); ++at) {
            if (text[at] == '#' && (at == 0 || text[at - 1] == '\n'))
                number = text.substr(at, text.find_first_of(" =", at) - at);
            if (text[at] == '(' && at + 1 < text.size() && text[at + 1] == '#' && !number.empty()) {
                cyclic += "(" + number;
                at = text.find_first_of(",)", at) - 1;
                continue;
            }
            cyclic += text[at];
        }
    } else if (whole.extension == "brep") {
        // Every shape is made of the last one, which is made of itself.
        for (size_t at = 0; at < text.size(); ++at) {
            cyclic += text[at];
            const bool isReference = (text[at] == '+' || text[at] == '-') && at > 0 && text[at - 1] <= ' ' &&
                                     at > text.find("TShapes");
            if (!isReference)
                continue;
            cyclic += '1';
            while (at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9')
                ++at;
        }
    } else if (whole.extension == "igs") {
        // The first pointer of every entity that has one first is to itself: line by line.
        for (size_t at = 0; at + 81 <= text.size(); at += 81) {
            std::string line = text.substr(at, 81);
            if (line[72] == 'P' && line[3] == ',' && std::strchr("45", line[1]) != nullptr)
                line.replace(4, line.find_first_of(",;", 4) - 4,
                             std::to_string(std::stoi(line.substr(64, 8))));
            line.erase(line.find_first_of('\n'));
            const std::string end = text.substr(at + 64, 17);
            line = line.substr(0, 64);
            line.resize(64, ' ');
            cyclic += line + end;
        }
    }
    if (cyclic.empty() || cyclic == text)
        return {};
    return {{whole.name + ", cyclic", whole.extension, cyclic}};
}

std::vector<HostileFile> cutOff(const HostileFile& whole, size_t parts)
{
    std::vector<HostileFile> files;
    for (size_t part = 0; part < parts; ++part)
        files.push_back({whole.name + ", cut off at " + std::to_string(part) + "/" + std::to_string(parts),
                         whole.extension, whole.content.substr(0, whole.content.size() * part / parts)});
    return files;
}

std::vector<HostileFile> withOneByteChanged(const HostileFile& whole, int count)
{
    std::mt19937 random(3);
    std::vector<HostileFile> files;
    for (int change = 0; change < count; ++change) {
        HostileFile file = whole;
        const size_t at = random() % file.content.size();
        const auto byte = static_cast<unsigned char>(random() % 256);
        file.content[at] = static_cast<char>(byte);
        file.name += ", byte " + std::to_string(at) + " now " + std::to_string(byte);
        files.push_back(std::move(file));
    }
    return files;
}

std::vector<HostileFile> ofRandomBytes(const std::string& extension, int count)
{
    std::mt19937 random(4);
    std::vector<HostileFile> files;
    for (int k = 0; k < count; ++k) {
        HostileFile file{"random bytes " + std::to_string(k), extension, {}};
        for (size_t n = 1 + random() % 5000; n > 0; --n)
            file.content += static_cast<char>(random() % 256);
        files.push_back(std::move(file));
    }
    return files;
}

}  // namespace knotspan::testing
