#include "model/mesh/trimmed_assembly.h"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

#include "model/mesh/facing_out.h"
#include "model/mesh/mesh_limits.h"

namespace knotspan {

namespace {

// Where the mesh uses an edge, by the face of the triangle.
struct EdgeUse {
    std::uint64_t edge = 0;
    std::uint32_t face = 0;
    bool rises = false;  // from the lower number to the higher
};

class Assembly {
public:
    explicit Assembly(const TrimmedParts& parts) : parts_(parts) {}

    Result<Tessellation> make()
    {
        size_t count = parts_.samples.positions().size();
        for (const FaceTriangles& face : parts_.triangles)
            count += face.inside.size();
        if (count > UINT32_MAX)
            return failure("A mesh this fine would have too many vertices", "Choose a larger deviation");
        result_.mesh.vertices = parts_.samples.positions();
        result_.mesh.vertices.reserve(count);
        joinSame();
        for (std::uint32_t face = 0; face < parts_.faces.size(); ++face)
            addFace(face);
        firstTriangles_.push_back(result_.mesh.triangles.size());
        addChords();
        findUses();
        boundChords();
        turn();
        sayWhatIsOpen();
        dropUnused(result_);
        return std::move(result_);
    }

private:
    // Vertices of outlines that are one place on some face.
    void joinSame()
    {
        into_.resize(result_.mesh.vertices.size());
        std::iota(into_.begin(), into_.end(), 0U);
        for (const FaceTriangles& face : parts_.triangles)
            for (const auto& [a, b] : face.same)
                into_[std::max(find(a), find(b))] = std::min(find(a), find(b));
    }
    std::uint32_t find(std::uint32_t vertex)
    {
        while (into_[vertex] != vertex)
            vertex = into_[vertex] = into_[into_[vertex]];
        return vertex;
    }

    void addFace(std::uint32_t number)
    {
        const FaceTriangles& face = parts_.triangles[number];
        const auto first = static_cast<std::uint32_t>(result_.mesh.vertices.size());
        firstTriangles_.push_back(result_.mesh.triangles.size());
        placeInside(number);
        const std::vector<KsQuad> quads = ksQuads(parts_.faces[number].surface());
        std::uint32_t ksquad = 0xffffffffU;
        for (const FaceTriangles::Corners& corners : face.triangles) {
            Triangle triangle;
            for (size_t k = 0; k < 3; ++k)
                triangle[k] = corners.vertices[k] < face.outlineCount
                                  ? find(corners.vertices[k])
                                  : first + (corners.vertices[k] - face.outlineCount);
            if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
                continue;
            if (ksquad != corners.ksquad) {
                ksquad = corners.ksquad;
                result_.patches.push_back(
                    {parts_.placed.objects[number], quads[ksquad], result_.mesh.triangles.size()});
            }
            result_.mesh.triangles.push_back(triangle);
            result_.parameters.push_back(corners.t);
        }
    }
    [[nodiscard]] double sizeOf(std::uint32_t face) const
    {
        const PlacedSurface& placed = parts_.placed.surfaces[face];
        return transformed(placed.surface->bounds(), placed.transform).diagonal();
    }

    void placeInside(std::uint32_t number)
    {
        const std::vector<OutlinePlace>& inside = parts_.triangles[number].inside;
        if (inside.empty())
            return;
        std::vector<SpanParameter> u;
        std::vector<SpanParameter> v;
        for (const OutlinePlace& place : inside) {
            const auto at = parts_.faces[number].parametersAt(place);
            u.push_back(at[0]);
            v.push_back(at[1]);
        }
        const PlacedSurface& placed = parts_.placed.surfaces[number];
        const GridEvaluator<double> evaluator(*placed.surface, {});
        GridSamples<double> samples;
        evaluator.evaluateScattered(u, v, samples, Threads::one);
        for (size_t k = 0; k < inside.size(); ++k)
            result_.mesh.vertices.push_back(
                transformed(samples.origin() + samples.position(0, static_cast<int>(k)), placed.transform));
    }

    void addChords()
    {
        for (std::uint32_t face = 0; face < parts_.faces.size(); ++face)
            for (const FaceStretch& stretch : parts_.stretches[face]) {
                const auto& samples = parts_.samples.of(stretch.seam);
                for (size_t k = 0; k + 1 < samples.size(); ++k)
                    addChord(face, stretch, samples[k], samples[k + 1]);
            }
    }
    void addChord(std::uint32_t face, const FaceStretch& stretch, const OutlineSamples::Sample& from,
                  const OutlineSamples::Sample& to)
    {
        OutlineChord chord;
        chord.object = parts_.placed.objects[face];
        chord.vertices = {find(from.vertex), find(to.vertex)};
        for (size_t k = 0; k < chord.places.size(); ++k) {
            const double share = static_cast<double>(k + 1) / static_cast<double>(chord.places.size() + 1);
            const double t = from.t[stretch.member] + share * (to.t[stretch.member] - from.t[stretch.member]);
            chord.places[k] =
                parts_.faces[face].parametersAt(parts_.faces[face].arcs()[stretch.arc].placeAt(t));
        }
        result_.chords.push_back(chord);
    }

    // Only edges between vertices of outlines can be anybody else's.
    void findUses()
    {
        for (std::uint32_t face = 0; face < parts_.faces.size(); ++face)
            for (size_t k = firstTriangles_[face]; k < firstTriangles_[face + 1]; ++k)
                for (size_t corner = 0; corner < 3; ++corner) {
                    const std::uint32_t from = result_.mesh.triangles[k][corner];
                    const std::uint32_t to = result_.mesh.triangles[k][(corner + 1) % 3];
                    if (std::max(from, to) < into_.size())
                        uses_.push_back(
                            {std::uint64_t{std::min(from, to)} << 32U | std::max(from, to), face, from < to});
                }
        std::sort(uses_.begin(), uses_.end(), [](const EdgeUse& a, const EdgeUse& b) {
            return std::tie(a.edge, a.face, a.rises) < std::tie(b.edge, b.face, b.rises);
        });
    }

    // Triangles and chords are as near to a face as it is said, but for what their ends were moved by; and a
    // chord that no triangle has is as near to those as its ends are.
    void boundChords()
    {
        Box box;
        for (const Vec3& vertex : result_.mesh.vertices)
            box.add(vertex);
        unknown_ = box.diagonal();
        std::vector<char> used(into_.size(), 0);
        for (const Triangle& triangle : result_.mesh.triangles)
            for (const std::uint32_t vertex : triangle)
                if (vertex < used.size())
                    used[vertex] = 1;
        for (std::uint32_t face = 0; face < parts_.faces.size(); ++face) {
            double moved = 0;
            double lost = 0;
            for (const FaceStretch& stretch : parts_.stretches[face]) {
                const auto& samples = parts_.samples.of(stretch.seam);
                for (size_t k = 0; k < samples.size(); ++k) {
                    const std::uint32_t vertex = samples[k].vertex;
                    const Vec3& at = result_.mesh.vertices[find(vertex)];
                    moved = std::max(moved, glm::distance(parts_.samples.positions()[vertex], at));
                    if (k > 0 && !isHair(face, samples[k - 1].vertex, vertex))
                        lost =
                            std::max(lost, farthestFromMesh(find(samples[k - 1].vertex), find(vertex), used));
                }
            }
            const FaceTriangles& triangles = parts_.triangles[face];
            const double known = triangles.bound + parts_.samples.gap(face) + moved + lost;
            result_.bound =
                std::max(result_.bound, triangles.crosses ? std::max(known, sizeOf(face)) : known);
        }
    }
    [[nodiscard]] bool isHair(std::uint32_t face, std::uint32_t a, std::uint32_t b) const
    {
        const auto& hairs = parts_.triangles[face].hairs;
        return std::binary_search(hairs.begin(), hairs.end(),
                                  std::array<std::uint32_t, 2>{std::min(a, b), std::max(a, b)});
    }
    // Of a segment between two vertices.
    [[nodiscard]] double farthestFromMesh(std::uint32_t from, std::uint32_t to,
                                          const std::vector<char>& used) const
    {
        const std::uint64_t edge = std::uint64_t{std::min(from, to)} << 32U | std::max(from, to);
        const auto use = std::lower_bound(uses_.begin(), uses_.end(), edge,
                                          [](const EdgeUse& a, std::uint64_t b) { return a.edge < b; });
        if (use != uses_.end() && use->edge == edge)
            return 0;
        const double length = glm::distance(result_.mesh.vertices[from], result_.mesh.vertices[to]);
        if (used[from] != 0 && used[to] != 0)
            return length / 2;
        return used[from] != 0 || used[to] != 0 ? length : unknown_;
    }

    template <class Visit>
    void forEachEdge(const Visit& visit) const
    {
        for (size_t first = 0; first < uses_.size();) {
            size_t end = first;
            while (end < uses_.size() && uses_[end].edge == uses_[first].edge)
                ++end;
            visit(first, end - first);
            first = end;
        }
    }

    void turn()
    {
        std::vector<char> closed(parts_.faces.size(), 1);
        std::vector<MeshVertices::Seam> seams;
        forEachEdge([&](size_t first, size_t count) {
            if (count != 2) {
                for (size_t k = first; k < first + count; ++k)
                    closed[uses_[k].face] = 0;
                return;
            }
            const EdgeUse& a = uses_[first];
            const EdgeUse& b = uses_[first + 1];
            if (a.face != b.face || a.rises == b.rises)
                seams.push_back({a.face, b.face, a.rises != b.rises});
        });
        std::sort(seams.begin(), seams.end(), [](const auto& a, const auto& b) {
            return std::tie(a.surface, a.other, a.agree) < std::tie(b.surface, b.other, b.agree);
        });
        seams.erase(std::unique(seams.begin(), seams.end(),
                                [](const auto& a, const auto& b) {
                                    return a.surface == b.surface && a.other == b.other && a.agree == b.agree;
                                }),
                    seams.end());
        turnOut(result_, facingOut(result_.mesh, firstTriangles_, parts_.placed.surfaces, seams, closed),
                firstTriangles_);
    }

    void sayWhatIsOpen()
    {
        std::vector<std::uint32_t> open;
        forEachEdge([&](size_t first, size_t count) {
            if (count == 1)
                open.push_back(uses_[first].face);
        });
        std::sort(open.begin(), open.end());
        open.erase(std::unique(open.begin(), open.end()), open.end());
        std::vector<std::uint32_t> refused;
        std::vector<std::uint32_t> crossing;
        for (std::uint32_t face = 0; face < parts_.faces.size(); ++face) {
            const auto* loops = parts_.placed.surfaces[face].trimLoops;
            if (loops != nullptr && !loops->empty() && !parts_.faces[face].isTrimmed())
                refused.push_back(face);
            if (parts_.triangles[face].crosses)
                crossing.push_back(face);
        }
        result_.uncut = refused.size();
        result_.crossing = crossing.size();
        say(refused, "in the mesh whole, because its trim loops cannot be followed",
            "in the mesh whole, because their trim loops cannot be followed");
        say(crossing,
            "cut as well as can be, because its outline crosses itself; how far it is off is not known",
            "cut as well as can be, because their outlines cross themselves; how far they are off is not "
            "known");
        say(open,
            "where the mesh is open: no other edge runs along one of its edges within " +
                shortText(parts_.reach.edges),
            "where the mesh is open: no other edge runs along one of their edges within " +
                shortText(parts_.reach.edges));
    }
    void say(const std::vector<std::uint32_t>& faces, const std::string& ofOne, const std::string& ofMany)
    {
        constexpr size_t kNamed = 5;
        if (faces.empty())
            return;
        std::string names;
        for (size_t k = 0; k < std::min(kNamed, faces.size()); ++k)
            names += (k > 0 ? ", " : "") + parts_.placed.names[faces[k]];
        if (faces.size() > kNamed)
            names += ", ...";
        result_.notes.push_back(faces.size() == 1 ? "1 face is " + ofOne + " (" + names + ")."
                                                  : std::to_string(faces.size()) + " faces are " + ofMany +
                                                        " (" + names + ").");
    }

    const TrimmedParts& parts_;
    double unknown_ = 0;  // how far what lies next to no triangle is from them, at most
    Tessellation result_;
    std::vector<std::uint32_t> into_;  // of the outlines' vertices
    std::vector<size_t> firstTriangles_;
    std::vector<EdgeUse> uses_;
};

}  // namespace

Result<Tessellation> assembled(const TrimmedParts& parts)
{
    return Assembly(parts).make();
}

}  // namespace knotspan
