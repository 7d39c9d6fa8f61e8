#include "renderer/scene/cpu_vertices.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace knotspan {

namespace {

using DoubleBasis = gpu::Basis<double>;

double largest(const Vec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

Vec3 directionOf(const Vec3& v)
{
    const double scale = largest(v);
    return scale > 0.0 ? glm::normalize(v / scale) : Vec3(0);
}

class VertexMaker {
public:
    VertexMaker(const CpuScene& scene, std::uint32_t ksquad) : scene_(scene), ksquad_(ksquad) {}

    [[nodiscard]] DoubleBasis alongU(std::uint32_t ksquad, double t) const
    {
        const gpu::KsQuadRecord& record = scene_.ksquad(ksquad);
        return scene_.basis(record.spanU, degree(scene_.surface(record.surface).degreeU), t);
    }
    [[nodiscard]] DoubleBasis alongV(std::uint32_t ksquad, double t) const
    {
        const gpu::KsQuadRecord& record = scene_.ksquad(ksquad);
        return scene_.basis(record.spanV, degree(scene_.surface(record.surface).degreeV), t);
    }

    // From the basis functions at the vertex.
    [[nodiscard]] gpu::ObjectVertex inside(const gpu::vec2& t, const DoubleBasis& u,
                                           const DoubleBasis& v) const
    {
        const auto at = sample(ksquad_, u, v);
        return made(t, ksquad_, at.position, at);
    }

    [[nodiscard]] gpu::ObjectVertex at(const gpu::GridVertex& vertex) const
    {
        const auto seen = sample(vertex.source, vertex.sourceT);
        const bool same = vertex.source == ksquad_ && vertex.sourceT == vertex.t;
        const bool serves = same || (vertex.sharesNormal && tells(seen));
        return made(vertex.t, vertex.source, seen.position, serves ? seen : sample(ksquad_, vertex.t));
    }

private:
    [[nodiscard]] static int degree(gpu::uint number) { return static_cast<int>(number); }

    [[nodiscard]] gpu::SurfaceSample<double> sample(std::uint32_t ksquad, const DoubleBasis& u,
                                                    const DoubleBasis& v) const
    {
        const gpu::KsQuadRecord& record = scene_.ksquad(ksquad);
        const gpu::SurfaceRecord& surface = scene_.surface(record.surface);
        return gpu::contractNet<double>(scene_, record.firstPoint, surface.stride, degree(surface.degreeU),
                                        degree(surface.degreeV), u, v);
    }
    [[nodiscard]] gpu::SurfaceSample<double> sample(std::uint32_t ksquad, const Vec2& t) const
    {
        return sample(ksquad, alongU(ksquad, t.x), alongV(ksquad, t.y));
    }

    [[nodiscard]] static Vec3 crossOf(const gpu::SurfaceSample<double>& at)
    {
        return glm::cross(directionOf(at.du), directionOf(at.dv));
    }
    // Whether the tangents tell a normal.
    [[nodiscard]] static bool tells(const gpu::SurfaceSample<double>& at)
    {
        constexpr double kRounding = 1e-14;
        constexpr double kLeastSine = 32.0 * kRounding;
        const Vec3 n = crossOf(at);
        return std::min(largest(at.du), largest(at.dv)) > kRounding * largest(at.position) &&
               glm::dot(n, n) > kLeastSine * kLeastSine;
    }

    // Where the tangents tell none, that of the nearest point a little further inside whose tangents do.
    [[nodiscard]] Vec3 normalAt(const Vec2& t, gpu::SurfaceSample<double> at) const
    {
        Vec3 normal(0);
        double inwards = 0.0;
        for (int attempt = 0; attempt < 6; ++attempt) {
            const bool enough = tells(at);
            if (enough || normal == Vec3(0))
                normal = directionOf(crossOf(at));
            if (enough)
                break;
            inwards = std::max(8.0 * inwards, 0.0009765625);
            at = sample(ksquad_, t + inwards * (Vec2(0.5) - t));
        }
        return normal == Vec3(0) ? Vec3(0, 0, 1) : normal;
    }

    // `own` is the KSQuad's own point at t, or one of the source's that serves for it.
    [[nodiscard]] gpu::ObjectVertex made(const gpu::vec2& t, std::uint32_t source, const Vec3& position,
                                         const gpu::SurfaceSample<double>& own) const
    {
        return {gpu::vec3(position),           gpu::vec3(normalAt(t, own)), t, ksquad_, source,
                static_cast<float>(own.weight)};
    }

    const CpuScene& scene_;
    std::uint32_t ksquad_;
};

float stepOf(std::uint32_t k, std::uint32_t cells)
{
    return static_cast<float>(k) / static_cast<float>(cells);
}

bool isBorder(const gpu::DrawnGrid& grid, std::uint32_t i, std::uint32_t j)
{
    return i == 0 || i == grid.u || j == 0 || j == grid.v;
}

}  // namespace

void makeVertices(const CpuScene& scene, const AskedGrids& asked, std::uint32_t ksquad,
                  const gpu::DrawnGrid& grid, gpu::ObjectVertex* vertices)
{
    const VertexMaker maker(scene, ksquad);
    std::vector<DoubleBasis> alongV(grid.v + 1);
    for (std::uint32_t j = 1; j < grid.v && grid.u > 1; ++j)
        alongV[j] = maker.alongV(ksquad, stepOf(j, grid.v));
    for (std::uint32_t i = 0; i <= grid.u; ++i) {
        const DoubleBasis alongU = maker.alongU(ksquad, stepOf(i, grid.u));
        for (std::uint32_t j = 0; j <= grid.v; ++j, ++vertices)
            *vertices = isBorder(grid, i, j)
                            ? maker.at(gpu::gridVertex(asked, ksquad, grid, i, j, SNAP_FALLING))
                            : maker.inside({stepOf(i, grid.u), stepOf(j, grid.v)}, alongU, alongV[j]);
    }
}

std::uint32_t renewBorder(const CpuScene& scene, const AskedGrids& asked,
                          const std::vector<std::uint8_t>& touched, bool all, std::uint32_t ksquad,
                          const gpu::DrawnGrid& grid, gpu::ObjectVertex* vertices)
{
    const VertexMaker maker(scene, ksquad);
    std::uint32_t renewed = 0;
    for (std::uint32_t i = 0; i <= grid.u; ++i)
        for (std::uint32_t j = 0; j <= grid.v; j += i == 0 || i == grid.u ? 1 : grid.v) {
            const gpu::GridVertex wanted = gpu::gridVertex(asked, ksquad, grid, i, j, SNAP_FALLING);
            gpu::ObjectVertex& held = vertices[i * (grid.v + 1) + j];
            const bool same = !all && held.t == wanted.t && held.source == wanted.source;
            if (same && (touched.empty() || touched[wanted.source] == 0))
                continue;
            held = maker.at(wanted);
            ++renewed;
        }
    return renewed;
}

}  // namespace knotspan
