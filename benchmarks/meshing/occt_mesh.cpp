#include "benchmarks/meshing/occt_mesh.h"

#include <chrono>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>

#include "benchmarks/evaluation/occt_surface.h"

namespace knotspan::benchmarks {

struct OcctMesh::Faces {
    std::vector<NurbsSurface> surfaces;
    std::vector<TopoDS_Face> faces;
    TopoDS_Compound all;
};

OcctMesh::OcctMesh(const Scene& scene) : faces_(std::make_unique<Faces>())
{
    BRep_Builder builder;
    builder.MakeCompound(faces_->all);
    for (const auto& [id, object] : scene.objects()) {
        faces_->surfaces.push_back(object->surface);
        faces_->faces.push_back(BRepBuilderAPI_MakeFace(occtSurface(object->surface), 1e-7).Face());
        builder.Add(faces_->all, faces_->faces.back());
    }
}

OcctMesh::~OcctMesh() = default;

double OcctMesh::make(double deflection)
{
    BRepTools::Clean(faces_->all);
    const auto start = std::chrono::steady_clock::now();
    const BRepMesh_IncrementalMesh mesh(faces_->all, deflection, Standard_False, 3.0, Standard_False);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

size_t OcctMesh::triangleCount() const
{
    size_t count = 0;
    for (const TopoDS_Face& face : faces_->faces) {
        TopLoc_Location location;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
        count += mesh.IsNull() ? 0 : static_cast<size_t>(mesh->NbTriangles());
    }
    return count;
}

double OcctMesh::measured() const
{
    double largest = 0;
    const std::vector<Vec3>& places = DeviationSampler::places();
    for (size_t f = 0; f < faces_->faces.size(); ++f) {
        TopLoc_Location location;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(faces_->faces[f], location);
        if (mesh.IsNull())
            continue;
        const NurbsSurface& surface = faces_->surfaces[f];
        DeviationSampler sampler(surface, Mat4(1.0), false, Threads::one);
        std::vector<double> u(places.size());
        std::vector<double> v(places.size());
        for (int k = 1; k <= mesh->NbTriangles(); ++k) {
            int nodes[3];
            mesh->Triangle(k).Get(nodes[0], nodes[1], nodes[2]);
            std::array<Vec3, 3> corners;
            for (size_t c = 0; c < 3; ++c) {
                const gp_Pnt at = mesh->Node(nodes[c]);
                corners[c] = {at.X(), at.Y(), at.Z()};
            }
            for (size_t p = 0; p < places.size(); ++p) {
                u[p] = v[p] = 0;
                for (int c = 0; c < 3; ++c) {
                    u[p] += places[p][c] * mesh->UVNode(nodes[c]).X();
                    v[p] += places[p][c] * mesh->UVNode(nodes[c]).Y();
                }
            }
            sampler.add(corners, spanParameters(surface.knotsU(), u), spanParameters(surface.knotsV(), v));
        }
        largest = std::max(largest, sampler.result().largest);
    }
    return largest;
}

}  // namespace knotspan::benchmarks
