#include "tests/model/mesh/half_edge_mesh.h"

// Before the mesh itself, as OpenMesh asks for.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace knotspan::testing {

namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

HalfEdgeFigures figuresOf(HalfEdgeMesh& mesh, bool read)
{
    HalfEdgeFigures figures{read, mesh.n_vertices(), mesh.n_faces(), mesh.n_edges(), 0, true};
    for (const auto edge : mesh.edges())
        figures.boundaryEdges += mesh.is_boundary(edge) ? 1 : 0;
    for (const auto vertex : mesh.vertices())
        figures.manifold = figures.manifold && mesh.is_manifold(vertex);
    return figures;
}

}  // namespace

HalfEdgeFigures halfEdgesOf(const TriangleMesh& mesh)
{
    ::omerr().disable();
    HalfEdgeMesh half;
    std::vector<HalfEdgeMesh::VertexHandle> handles;
    for (const Vec3& v : mesh.vertices)
        handles.push_back(half.add_vertex({v.x, v.y, v.z}));
    bool all = true;
    for (const Triangle& t : mesh.triangles)
        all = half.add_face(handles[t[0]], handles[t[1]], handles[t[2]]).is_valid() && all;
    return figuresOf(half, all);
}

HalfEdgeFigures halfEdgesOf(const std::filesystem::path& file)
{
    ::omerr().disable();
    ::omlog().disable();
    HalfEdgeMesh half;
    const bool read = OpenMesh::IO::read_mesh(half, file.string());
    return figuresOf(half, read);
}

}  // namespace knotspan::testing
