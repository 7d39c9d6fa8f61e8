#include "model/mesh/mesh_parts.h"

#include <algorithm>

namespace knotspan {

PlacedScene partOf(const PlacedScene& placed, const std::vector<std::uint32_t>& numbers, std::uint32_t number)
{
    PlacedScene part;
    for (size_t k = 0; k < numbers.size(); ++k)
        if (numbers[k] == number) {
            part.surfaces.push_back(placed.surfaces[k]);
            part.objects.push_back(placed.objects[k]);
            part.names.push_back(placed.names[k]);
        }
    return part;
}

Result<Tessellation> appended(Tessellation to, Tessellation more)
{
    if (to.mesh.vertices.size() + more.mesh.vertices.size() > UINT32_MAX)
        return failure("A mesh this fine would have too many vertices", "Choose a larger deviation");
    const auto vertices = static_cast<std::uint32_t>(to.mesh.vertices.size());
    const size_t triangles = to.mesh.triangles.size();
    to.mesh.vertices.insert(to.mesh.vertices.end(), more.mesh.vertices.begin(), more.mesh.vertices.end());
    for (const Triangle& triangle : more.mesh.triangles)
        to.mesh.triangles.push_back({triangle[0] + vertices, triangle[1] + vertices, triangle[2] + vertices});
    to.parameters.insert(to.parameters.end(), more.parameters.begin(), more.parameters.end());
    for (MeshPatch patch : more.patches) {
        patch.firstTriangle += triangles;
        to.patches.push_back(patch);
    }
    for (OutlineChord chord : more.chords) {
        for (std::uint32_t& vertex : chord.vertices)
            vertex += vertices;
        to.chords.push_back(chord);
    }
    to.bound = std::max(to.bound, more.bound);
    to.uncut += more.uncut;
    to.crossing += more.crossing;
    for (std::string& note : more.notes)
        if (std::find(to.notes.begin(), to.notes.end(), note) == to.notes.end())
            to.notes.push_back(std::move(note));
    return to;
}

}  // namespace knotspan
