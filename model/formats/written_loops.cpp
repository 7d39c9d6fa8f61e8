#include "model/formats/written_loops.h"

#include <algorithm>
#include <optional>
#include <set>

#include "model/trimming/loop_clipping.h"
#include "model/trimming/loop_combining.h"
#include "model/trimming/trim_region.h"

namespace knotspan::formats {

namespace {

// Of the domain: what reaches no further is the tolerance of files.
constexpr double kBeyond = 1e-4;

bool leaveTheSame(const TrimRegion& a, const TrimRegion& b, const NurbsSurface& surface)
{
    constexpr int kPlaces = 64;  // along each side
    constexpr int kOnLoops = 4;  // where either answer is right
    int differ = 0;
    const KnotVector& u = surface.knotsU();
    const KnotVector& v = surface.knotsV();
    for (int i = 0; i < kPlaces; ++i)
        for (int k = 0; k < kPlaces; ++k) {
            const double x = u.domainStart() + (u.domainEnd() - u.domainStart()) * (i + 0.37) / kPlaces;
            const double y = v.domainStart() + (v.domainEnd() - v.domainStart()) * (k + 0.41) / kPlaces;
            differ += a.contains(x, y) != b.contains(x, y) ? 1 : 0;
        }
    return differ <= kOnLoops;
}

// Each loop that reaches beyond trims what the others leave.
std::optional<std::vector<TrimLoop>> trimmedByEach(const std::set<std::uint32_t>& beyond,
                                                   const SceneObject& object)
{
    std::vector<TrimLoop> kept;
    for (std::uint32_t k = 0; k < object.trimLoops.size(); ++k)
        if (beyond.count(k) == 0)
            kept.push_back(object.trimLoops[k]);
    for (const std::uint32_t k : beyond) {
        const TrimLoop& loop = object.trimLoops[k];
        auto made =
            trimmedBy(loop.curves, kept, object.surface, loop.outer ? KeptSide::inside : KeptSide::outside);
        if (!made)
            return std::nullopt;
        kept = *std::move(made);
    }
    return kept;
}

// Nothing where they may stay.
std::optional<std::vector<TrimLoop>> shownLoops(const SceneObject& object)
{
    LoopReading reading = readLoops(object.trimLoops, object.surface);
    if (reading.refused)
        return std::vector<TrimLoop>();
    std::set<std::uint32_t> beyond;
    for (const LoopFinding& finding : reading.findings)
        if (finding.trouble == LoopTrouble::beyond && finding.share > kBeyond)
            beyond.insert(finding.loop);
    if (beyond.empty())
        return std::nullopt;
    const TrimRegion shown(object.trimLoops, object.surface);
    if (auto loops = trimmedByEach(beyond, object);
        loops && leaveTheSame(shown, TrimRegion(*loops, object.surface), object.surface))
        return loops;
    const DomainChains within = withinDomain(std::move(reading), object.surface, false);
    auto loops = loopsOf(within, object.trimLoops);
    if (!loops.empty() && leaveTheSame(shown, TrimRegion(loops, object.surface), object.surface))
        return loops;
    return std::nullopt;
}

}  // namespace

Scene withLoopsAsShown(const Scene& scene)
{
    Scene result = scene;
    for (const auto& [id, object] : scene.objects()) {
        if (object->trimLoops.empty())
            continue;
        if (auto loops = shownLoops(*object)) {
            SceneObject shown = *object;
            shown.trimLoops = *std::move(loops);
            result.exchange(id, std::make_shared<const SceneObject>(std::move(shown)));
        }
    }
    return result;
}

}  // namespace knotspan::formats
