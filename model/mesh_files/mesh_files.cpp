#include "model/mesh_files/mesh_files.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/files/file_replacement.h"
#include "model/files/length_units.h"
#include "model/mesh_files/glb_writing.h"
#include "model/mesh_files/mesh_output.h"
#include "model/mesh_files/vtp_file.h"

namespace knotspan::formats {

namespace {

void writeStl(MeshOutput& out, const TriangleMesh& mesh)
{
    // The header must not begin with "solid", or readers take the file for text.
    std::string header = "Binary STL, made by Knotspan";
    header.resize(80, ' ');
    out.text(header).bytes(static_cast<std::uint32_t>(mesh.triangles.size()));
    const auto vector = [&](const Vec3& v) {
        for (int c = 0; c < 3; ++c)
            out.bytes(static_cast<float>(v[c]));
    };
    for (const Triangle& t : mesh.triangles) {
        const Vec3 normal =
            glm::cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]);
        const double length = glm::length(normal);
        vector(length > 0 ? normal / length : Vec3(0));
        for (const std::uint32_t k : t)
            vector(mesh.vertices[k]);
        out.bytes(std::uint16_t{0});
    }
}

void writeRow(MeshOutput& out, const Vec3& v)
{
    out.number(v.x).text(" ").number(v.y).text(" ").number(v.z).text("\n");
}

void writeObj(MeshOutput& out, const TriangleMesh& mesh)
{
    out.text("# made by Knotspan\n");
    for (const Vec3& vertex : mesh.vertices)
        writeRow(out.text("v "), vertex);
    for (const Triangle& t : mesh.triangles)
        out.text("f ").number(t[0] + 1).text(" ").number(t[1] + 1).text(" ").number(t[2] + 1).text("\n");
}

void writeOff(MeshOutput& out, const TriangleMesh& mesh)
{
    out.text("OFF\n").number(mesh.vertices.size()).text(" ").number(mesh.triangles.size()).text(" 0\n");
    for (const Vec3& vertex : mesh.vertices)
        writeRow(out, vertex);
    for (const Triangle& t : mesh.triangles)
        out.text("3 ").number(t[0]).text(" ").number(t[1]).text(" ").number(t[2]).text("\n");
}

void writePly(MeshOutput& out, const TriangleMesh& mesh)
{
    out.text("ply\nformat binary_little_endian 1.0\ncomment made by Knotspan\nelement vertex ")
        .number(mesh.vertices.size())
        .text("\nproperty double x\nproperty double y\nproperty double z\nelement face ")
        .number(mesh.triangles.size())
        .text("\nproperty list uchar int vertex_indices\nend_header\n");
    for (const Vec3& vertex : mesh.vertices)
        out.bytes(vertex.x).bytes(vertex.y).bytes(vertex.z);
    for (const Triangle& t : mesh.triangles) {
        out.bytes(std::uint8_t{3});
        for (const std::uint32_t vertex : t)
            out.bytes(vertex);
    }
}

bool hasFloats(MeshKind kind)
{
    return kind == MeshKind::stl || kind == MeshKind::glb;
}

Result<void> fits(const TriangleMesh& mesh, MeshKind kind)
{
    // PLY's and many readers' numbers of vertices are signed.
    if (mesh.triangles.size() > UINT32_MAX || mesh.vertices.size() > INT32_MAX ||
        (kind == MeshKind::glb && !fitsGlb(mesh)))
        return failure("The mesh has more triangles than the format can count", "Choose a larger deviation");
    const bool finite = std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vec3& v) {
        const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        return hasFloats(kind) ? largest < 3e38 : std::isfinite(largest);
    });
    if (!finite)
        return failure("The model is larger than the numbers of the format",
                       "Choose PLY, or scale the model");
    return {};
}

}  // namespace

const std::vector<MeshFormat>& meshFormats()
{
    static const std::vector<MeshFormat> kFormats{
        {MeshKind::stl, "STL", "stl"}, {MeshKind::obj, "OBJ polygons", "obj"},
        {MeshKind::ply, "PLY", "ply"}, {MeshKind::off, "OFF", "off"},
        {MeshKind::vtp, "VTP", "vtp"}, {MeshKind::glb, "glTF", "glb"}};
    return kFormats;
}

std::optional<MeshKind> meshKindOf(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    for (const MeshFormat& format : meshFormats())
        if (extension == "." + format.extension)
            return format.kind;
    return std::nullopt;
}

double roundTo(MeshKind kind, TriangleMesh& mesh)
{
    if (!hasFloats(kind))
        return 0;
    double furthest = 0;
    const Vec3 origin = kind == MeshKind::glb ? glbOrigin(mesh) : Vec3(0);
    for (Vec3& vertex : mesh.vertices) {
        // Not by casts alone: g++ 12 leaves out pairs of them where it vectorizes.
        const auto stored = [](double number) {
            const volatile float single = static_cast<float>(number);
            return static_cast<double>(single);
        };
        const Vec3 from = vertex - origin;
        const Vec3 rounded = Vec3(stored(from.x), stored(from.y), stored(from.z)) + origin;
        furthest = std::max(furthest, glm::distance(rounded, vertex));
        vertex = rounded;
    }
    return furthest;
}

double metresIn(const std::string& units)
{
    const double millimetres = millimetresIn(units);
    return millimetres > 0 ? millimetres / 1000 : 1;
}

std::string noteOnUnits(const std::string& units)
{
    return "glTF is in metres with y up: " + (millimetresIn(units) > 0
                                                  ? "the model's " + units + " were converted."
                                                  : "the model's numbers are taken for metres.");
}

Result<void> writeMeshTo(const std::filesystem::path& path, const TriangleMesh& mesh, MeshKind kind,
                         const std::string& units)
{
    if (auto possible = fits(mesh, kind); !possible)
        return possible;
    if (kind == MeshKind::vtp)
        return writeVtp(path, mesh);
    MeshOutput out(path);
    switch (kind) {
    case MeshKind::stl:
        writeStl(out, mesh);
        break;
    case MeshKind::obj:
        writeObj(out, mesh);
        break;
    case MeshKind::ply:
        writePly(out, mesh);
        break;
    case MeshKind::off:
        writeOff(out, mesh);
        break;
    case MeshKind::glb:
        writeGlb(out, mesh, metresIn(units));
        break;
    case MeshKind::vtp:
        break;
    }
    if (!out.close())
        return failure("The file cannot be written", "Make room on the disk, or choose another place");
    return {};
}

Result<void> writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh, MeshKind kind,
                       const std::string& units)
{
    auto done = replaceFile(path, [&](const std::filesystem::path& temporary) {
        return writeMeshTo(temporary, mesh, kind, units);
    });
    if (!done)
        return tl::unexpected(done.error().at(path.string()));
    return {};
}

}  // namespace knotspan::formats
