#include "renderer/scene/cpu_culling.h"

#include <array>

#include "shaders/culling/evs.glsl"
#include "shaders/culling/frustum.glsl"
#include "shaders/culling/hull_on_screen.glsl"
#include "shaders/culling/lqc.glsl"
#include "shaders/culling/occlusion.glsl"
#include "shaders/culling/small.glsl"
#include "shaders/culling/sqc.glsl"
#include "shaders/culling/surface.glsl"
#include "shaders/culling/trimmed.glsl"
#include "shaders/shared/cull_list.h"

namespace knotspan {

namespace {

// What the texts read.
struct CullSource {
    const CpuScene& scene;
    const CullView& seen;

    [[nodiscard]] const gpu::SurfaceRecord& surface(gpu::uint k) const { return scene.surface(k); }
    [[nodiscard]] const gpu::KsQuadRecord& ksquad(gpu::uint k) const { return scene.ksquad(k); }
    [[nodiscard]] double spanTable(gpu::uint k) const { return scene.spanTable(k); }
    [[nodiscard]] const glm::dvec4& controlPoint(gpu::uint k) const { return scene.controlPoint(k); }
    [[nodiscard]] const gpu::SurfaceView& surfaceView(gpu::uint) const { return seen.view; }
    [[nodiscard]] float shownSide(gpu::uint) const { return seen.side; }
    [[nodiscard]] const gpu::PixelMap<float>& pixelMap(gpu::uint) const { return seen.map; }

    [[nodiscard]] gpu::FacingBox facingBox(gpu::uint k) const
    {
        return gpu::facingBoxOf(seen.facing->boxes()[k]);
    }
    [[nodiscard]] gpu::uint facingWord(gpu::uint k) const { return seen.facing->words()[k]; }

    [[nodiscard]] gpu::uint trimVerdict(gpu::uint k) const
    {
        const Resident& resident = scene.residents()[scene.ksquad(k).surface];
        return isTrimmed(resident) ? resident.trim->index->words()[k - resident.firstKsquad] : TRIM_WHOLE;
    }

    [[nodiscard]] gpu::vec3 position(gpu::uint k, const gpu::vec2& t) const
    {
        const gpu::KsQuadRecord& record = scene.ksquad(k);
        const gpu::SurfaceRecord& surface = scene.surface(record.surface);
        const auto p = static_cast<int>(surface.degreeU);
        const auto q = static_cast<int>(surface.degreeV);
        return gpu::vec3(gpu::contractNet<double>(scene, record.firstPoint, surface.stride, p, q,
                                                  scene.basis(record.spanU, p, double{t.x}),
                                                  scene.basis(record.spanV, q, double{t.y}))
                             .position);
    }
};

}  // namespace

int culledBy(const CpuScene& scene, std::uint32_t ksquad, const CullView& view, std::uint32_t cullBits)
{
    const CullSource source{scene, view};
    gpu::SeenKsQuad seen = gpu::seenKsQuad(source, ksquad);
#define KNOTSPAN_TEST(bit, name, culls, conservative, byDefault, colour, sentence) \
    if ((CULL_LATE & (1U << (bit))) == 0 && (cullBits & (1U << (bit))) != 0 &&     \
        gpu::culls(source, ksquad, seen))                                          \
        return bit;
    KNOTSPAN_CULL_LIST(KNOTSPAN_TEST)
#undef KNOTSPAN_TEST
    if ((cullBits & CULL_BY_HULL) != 0)
        seen.hull = gpu::hullOnScreen(source, ksquad);
#define KNOTSPAN_TEST(bit, name, culls, conservative, byDefault, colour, sentence) \
    if ((CULL_LATE & (1U << (bit))) != 0 && (cullBits & (1U << (bit))) != 0 &&     \
        gpu::culls(source, ksquad, seen))                                          \
        return bit;
    KNOTSPAN_CULL_LIST(KNOTSPAN_TEST)
#undef KNOTSPAN_TEST
    return kNotCulled;
}

}  // namespace knotspan
