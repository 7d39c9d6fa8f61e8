#include "model/mesh_files/mesh_formats.h"

#include "model/files/text_file.h"
#include "model/mesh_files/mesh_reading.h"
#include "model/mesh_files/vtp_file.h"

namespace knotspan::formats {

namespace {

namespace fs = std::filesystem;

constexpr unsigned kMostMebibytes = 2048;

// Named after the file, as these formats know no names.
Import importOf(TriangleMesh&& mesh, const fs::path& path)
{
    Import import;
    import.scene.addMesh(meshObject(nameIn(path.stem().string()), std::move(mesh)));
    return import;
}

template <Result<TriangleMesh> (*parse)(std::string_view)>
Result<Import> readBytes(const fs::path& path)
{
    auto bytes = wholeText(path, kMostMebibytes, path.extension().string().substr(1));
    if (!bytes)
        return tl::unexpected(bytes.error());
    auto mesh = parse(*bytes);
    if (!mesh)
        return tl::unexpected(mesh.error());
    return importOf(*std::move(mesh), path);
}

Result<Import> readVtpFile(const fs::path& path)
{
    return readVtp(path).map([&](TriangleMesh&& mesh) { return importOf(std::move(mesh), path); });
}

Result<Import> readVtpApart(const fs::path& path, const ImportProgress& progress)
{
    progress("Reading the mesh", -1);
    return readVtpFile(path);
}

Result<Import> readGltf(const fs::path& path)
{
    const auto bytes = wholeText(path, kMostMebibytes, path.extension().string().substr(1));
    if (!bytes)
        return tl::unexpected(bytes.error());
    auto scene = sceneFromGltf(*bytes, path.parent_path());
    if (!scene)
        return tl::unexpected(scene.error());
    Import import;
    import.scene = *std::move(scene);
    const Scene::Meshes meshes = import.scene.meshes();
    for (const auto& [id, mesh] : meshes)
        if (mesh->name.empty()) {
            MeshObject named = *mesh;
            named.name = nameIn(path.stem().string());
            import.scene.exchangeMesh(id, std::make_shared<const MeshObject>(std::move(named)));
        }
    return import;
}

Format withoutUnits(Format format)
{
    format.namesUnits = false;
    return format;
}

}  // namespace

Format stlFormat()
{
    return withoutUnits({"STL", {"stl"}, readBytes<meshFromStl>});
}

Format plyFormat()
{
    return withoutUnits({"PLY", {"ply"}, readBytes<meshFromPly>});
}

Format offFormat()
{
    return withoutUnits({"OFF", {"off"}, readBytes<meshFromOff>});
}

Format vtpFormat()
{
    return withoutUnits({"VTP", {"vtp"}, readVtpFile, nullptr, readVtpApart});
}

Format gltfFormat()
{
    return {"glTF", {"glb", "gltf"}, readGltf};
}

}  // namespace knotspan::formats
