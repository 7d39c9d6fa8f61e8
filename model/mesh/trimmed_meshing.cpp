#include "model/mesh/trimmed_meshing.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "model/mesh/face_triangles.h"
#include "model/mesh/mesh_limits.h"
#include "model/mesh/mesh_parts.h"
#include "model/mesh/touching_bodies.h"
#include "model/mesh/trimmed_assembly.h"

namespace knotspan {

namespace {

constexpr int kMostRounds = 12;

// Faces and their outlines, joined.
struct Outlined {
    std::vector<TrimRegion> regions;
    std::vector<OutlinedFace> faces;
    WeldReach reach;
    OutlineWeld weld;
};

// Of a part of a scene with the whole one's reach.
Outlined outlinesOf(const PlacedScene& placed, const TessellationOptions& options,
                    std::optional<WeldReach> reach = {})
{
    static const std::vector<TrimLoop> kNoLoops;
    Outlined result;
    for (const PlacedSurface& surface : placed.surfaces) {
        result.regions.emplace_back(surface.trimLoops != nullptr ? *surface.trimLoops : kNoLoops,
                                    *surface.surface);
        result.faces.emplace_back(surface, result.regions.back());
    }
    result.reach = reach ? *reach : weldReach(result.faces, options.deviation);
    if (!options.joinsEdges)
        result.reach.tiny = result.reach.edges = result.reach.same;
    result.weld = weldOutlines(result.faces, result.reach);
    return result;
}

class TrimmedMeshing {
public:
    TrimmedMeshing(const Outlined& outlined, const std::vector<FaceErrors>& errors)
        : outlined_(outlined),
          weld_(outlined.weld),
          errors_(errors),
          samples_(outlined.faces, weld_, outlined.reach.same, errors),
          stretches_(outlined.faces.size()),
          made_(outlined.faces.size())
    {
        for (std::uint32_t seam = 0; seam < weld_.seams.size(); ++seam)
            for (std::uint32_t m = 0; m < weld_.seams[seam].stretches.size(); ++m) {
                const OutlineStretch& stretch = weld_.stretches[weld_.seams[seam].stretches[m]];
                stretches_[stretch.face].push_back({seam, m, stretch.arc});
            }
    }

    // Outlines are made finer where triangles ask for it, or chords cross, and their faces made again.
    void make()
    {
        std::vector<char> due(outlined_.faces.size(), 1);
        for (int round = 0; round < kMostRounds; ++round) {
            std::map<std::uint32_t, std::vector<std::uint32_t>> cuts;  // by seam
            for (std::uint32_t face = 0; face < due.size(); ++face)
                if (due[face] != 0) {
                    made_[face] = trianglesOf(taskOf(face), false);
                    for (const SeamSegment& segment : made_[face].tooLong)
                        cuts[segment.seam].push_back(segment.segment);
                }
            due.assign(due.size(), 0);
            bool any = false;
            for (auto& [seam, segments] : cuts)
                any = cut(seam, segments, due) || any;
            if (!any)
                break;
        }
        for (std::uint32_t face = 0; face < due.size(); ++face)
            if (due[face] != 0 || made_[face].crosses)
                made_[face] = trianglesOf(taskOf(face), true);
    }

    [[nodiscard]] const OutlineSamples& samples() const { return samples_; }
    [[nodiscard]] const std::vector<FaceTriangles>& made() const { return made_; }
    [[nodiscard]] const std::vector<std::vector<FaceStretch>>& stretches() const { return stretches_; }

private:
    [[nodiscard]] FaceTask taskOf(std::uint32_t face) const
    {
        return {outlined_.faces[face], errors_[face], outlined_.regions[face], stretches_[face], samples_};
    }

    bool cut(std::uint32_t seam, std::vector<std::uint32_t>& segments, std::vector<char>& due)
    {
        std::sort(segments.begin(), segments.end(), std::greater<>());
        segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
        bool any = false;
        for (const std::uint32_t segment : segments)
            any = samples_.split(seam, segment) || any;
        if (any)
            for (const std::uint32_t stretch : weld_.seams[seam].stretches)
                due[weld_.stretches[stretch].face] = 1;
        return any;
    }

    const Outlined& outlined_;
    const OutlineWeld& weld_;
    const std::vector<FaceErrors>& errors_;
    OutlineSamples samples_;
    std::vector<std::vector<FaceStretch>> stretches_;  // by face
    std::vector<FaceTriangles> made_;
};

// What of the deviation is left for a face's triangles. Finer than the file's own edges are apart there is
// nothing to be gained, and triangles would fold.
double leftOf(double deviation, double gap)
{
    constexpr double kLeast = 0.25;
    constexpr double kSpare = 1.1;
    const double left = deviation - kSpare * gap;
    return left >= kLeast * deviation ? left : std::max(kLeast * deviation, gap / 2);
}

// `gaps`: how far each face is from the vertices that it shares, about; and in the end, in truth.
Result<Tessellation> tessellateOutlined(const PlacedScene& placed, const Outlined& outlined,
                                        const TessellationOptions& options, std::vector<double>& gaps)
{
    std::vector<double> left;
    std::vector<double> forCells;
    for (const double gap : gaps) {
        left.push_back(leftOf(options.deviation, gap));
        forCells.push_back(FaceErrors::kForCells * left.back());
    }
    KsQuadShapes shapes;
    const CellCounts counts = cellCounts(placed.surfaces, forCells, options.angleDegrees, &shapes);
    if (const auto fine = isNotTooFine(counts, options.mostTriangles); !fine)
        return tl::unexpected(fine.error());
    std::vector<FaceErrors> errors;
    const std::vector<BorderNumbers> numbers = borderNumbers(placed.surfaces);
    for (size_t face = 0; face < numbers.size(); ++face)
        errors.emplace_back(counts, shapes, numbers[face].firstKsquad, static_cast<int>(numbers[face].spansV),
                            left[face], options.angleDegrees.has_value());
    TrimmedMeshing meshing(outlined, errors);
    meshing.make();
    for (std::uint32_t face = 0; face < gaps.size(); ++face)
        gaps[face] = std::max(gaps[face], meshing.samples().gap(face));
    return assembled({placed, outlined.regions, outlined.faces, outlined.weld, outlined.reach,
                      meshing.samples(), meshing.stretches(), meshing.made()});
}

Result<Tessellation> tessellateWelded(const PlacedScene& placed, const Outlined& outlined,
                                      const TessellationOptions& options)
{
    std::vector<double> gaps = outlined.weld.gaps;
    auto made = tessellateOutlined(placed, outlined, options, gaps);
    if (!made || made->crossing > 0 || made->bound <= options.deviation || gaps == outlined.weld.gaps)
        return made;
    // Joined edges were further apart than where the weld had looked.
    auto again = tessellateOutlined(placed, outlined, options, gaps);
    return again && again->bound < made->bound ? again : made;
}

}  // namespace

std::vector<std::uint32_t> reachedByTrimming(const PlacedScene& placed, const TessellationOptions& options)
{
    const bool all = std::all_of(placed.surfaces.begin(), placed.surfaces.end(), [](const auto& surface) {
        return surface.trimLoops != nullptr && !surface.trimLoops->empty();
    });
    std::vector<std::uint32_t> reached(placed.surfaces.size(), 1);
    if (all)
        return reached;
    const Outlined outlined = outlinesOf(placed, options);
    for (size_t k = 0; k < reached.size(); ++k)
        reached[k] = outlined.faces[k].isTrimmed() ? 1U : 0U;
    const auto& stretches = outlined.weld.stretches;
    for (bool more = true; more;) {
        more = false;
        for (const OutlineSeam& seam : outlined.weld.seams) {
            const auto is = [&](std::uint32_t k) { return reached[stretches[k].face] != 0; };
            const auto count = std::count_if(seam.stretches.begin(), seam.stretches.end(), is);
            if (count == 0 || count == static_cast<std::ptrdiff_t>(seam.stretches.size()))
                continue;
            more = true;
            for (const std::uint32_t stretch : seam.stretches)
                reached[stretches[stretch].face] = 1;
        }
    }
    return reached;
}

Result<Tessellation> tessellateTrimmed(const PlacedScene& placed, const TessellationOptions& options)
{
    const Outlined outlined = outlinesOf(placed, options);
    const auto bodies = touchingBodies(static_cast<std::uint32_t>(placed.surfaces.size()), outlined.weld);
    const std::uint32_t count = *std::max_element(bodies.begin(), bodies.end()) + 1;
    if (count == 1)
        return tessellateWelded(placed, outlined, options);
    Result<Tessellation> result = Tessellation{};
    for (std::uint32_t body = 0; body < count && result; ++body) {
        const PlacedScene part = partOf(placed, bodies, body);
        TessellationOptions left = options;
        left.mostTriangles -= std::min(left.mostTriangles, result->mesh.triangles.size());
        auto made = tessellateWelded(part, outlinesOf(part, options, outlined.reach), left);
        if (!made)
            return made;
        result = appended(*std::move(result), *std::move(made));
    }
    return result;
}

}  // namespace knotspan
