#include "renderer/scene/cpu_culling.h"

#include <array>

#include "shaders/shared/cull_list.h"

namespace knotspan {

namespace {

using Corners = std::array<Vec3, 4>;

// As shaders/culling/facing.glsl has it.
bool cornersFaceAway(const Corners& corners, const Vec4& eye)
{
    const Vec3 normal = glm::cross(corners[3] - corners[0], corners[2] - corners[1]);
    const Vec3 centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    return glm::dot(normal, Vec3(eye) - eye.w * centre) < 0.0;
}

bool culledBySurface(const CpuScene& scene, std::uint32_t ksquad, const Vec4& eye)
{
    const gpu::SurfaceRecord& surface = scene.surface(scene.ksquad(ksquad).surface);
    return cornersFaceAway({Vec3(surface.corners[0]), Vec3(surface.corners[1]), Vec3(surface.corners[2]),
                            Vec3(surface.corners[3])},
                           eye);
}

bool culledByLqc(const CpuScene& scene, std::uint32_t ksquad, const Vec4& eye)
{
    const gpu::KsQuadRecord& record = scene.ksquad(ksquad);
    const gpu::SurfaceRecord& surface = scene.surface(record.surface);
    const auto p = static_cast<int>(surface.degreeU);
    const auto q = static_cast<int>(surface.degreeV);
    const std::array u{scene.basis(record.spanU, p, 0.0), scene.basis(record.spanU, p, 1.0)};
    const std::array v{scene.basis(record.spanV, q, 0.0), scene.basis(record.spanV, q, 1.0)};
    Corners corners;
    for (size_t k = 0; k < 4; ++k)
        corners[k] =
            gpu::contractNet<double>(scene, record.firstPoint, surface.stride, p, q, u[k & 1U], v[k >> 1U])
                .position;
    return cornersFaceAway(corners, eye);
}

}  // namespace

int culledBy(const CpuScene& scene, std::uint32_t ksquad, const Vec4& eye, std::uint32_t cullBits)
{
#define KNOTSPAN_TEST(bit, name, culls, conservative, sentence)       \
    if ((cullBits & (1U << (bit))) != 0 && culls(scene, ksquad, eye)) \
        return bit;
    KNOTSPAN_CULL_LIST(KNOTSPAN_TEST)
#undef KNOTSPAN_TEST
    return kNotCulled;
}

}  // namespace knotspan
