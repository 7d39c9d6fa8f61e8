#include "model/mesh/plane_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

constexpr int kMostHalvings = 8;

// A place of a KSQuad, in its own t.
struct Crossing {
    Vec2 t{0};
    Vec3 position{0};
};

// An edge of the mesh, by its vertices.
std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b)
{
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
}

// A part of a curve within one triangle, between two edges of the mesh.
struct Piece {
    std::array<std::uint64_t, 2> edges{};
    std::vector<Vec3> points;  // from the first edge to the second
};

// How far the surface is above the plane at places of one KSQuad.
class Height {
public:
    Height(const SceneObject& object, const KsQuad& quad, const SectionPlane& plane)
        : object_(object),
          plane_(plane),
          low_(object.surface.knotsU()[quad.spanU], object.surface.knotsV()[quad.spanV]),
          size_(Vec2(object.surface.knotsU()[quad.spanU + 1], object.surface.knotsV()[quad.spanV + 1]) - low_)
    {
    }

    struct At {
        Vec3 position{0};
        double value = 0;
        Vec2 slope{0};  // per t
    };
    [[nodiscard]] At at(const Vec2& t) const
    {
        const Vec2 place = low_ + t * size_;
        const SurfacePoint point = evaluate(object_.surface, place.x, place.y);
        const Vec3 position = transformed(point.position, object_.transform);
        const auto along = [&](const Vec3& way) {
            return glm::dot(plane_.normal, Vec3(object_.transform * Vec4(way, 0)));
        };
        return {position, glm::dot(plane_.normal, position) - plane_.offset,
                Vec2(along(point.du), along(point.dv)) * size_};
    }

    // Between two places on different sides of it: regula falsi that halves the end that stays (Illinois).
    [[nodiscard]] Crossing between(Vec2 a, Vec2 b) const
    {
        double atA = at(a).value;
        double atB = at(b).value;
        Crossing best{a, at(a).position};
        double least = std::abs(atA);
        if (std::abs(atB) < least) {
            best = {b, at(b).position};
            least = std::abs(atB);
        }
        if ((atA >= 0) == (atB >= 0))
            return best;  // the mesh's vertex is a neighbour's, by rounding on the other side
        for (int round = 0; round < 60 && least > 0; ++round) {
            const Vec2 t = a + (b - a) * (atA / (atA - atB));
            const At now = at(t);
            if (!(std::abs(now.value) < least) && round > 30)
                break;
            if (std::abs(now.value) < least) {
                best = {t, now.position};
                least = std::abs(now.value);
            }
            if ((now.value >= 0) == (atB >= 0)) {
                b = t;
                atB = now.value;
                atA *= 0.5;
            } else {
                a = t;
                atA = now.value;
                atB *= 0.5;
            }
        }
        return best;
    }

    // From a place nearby, the shortest way in t; nothing where it does not arrive.
    [[nodiscard]] std::optional<Crossing> nearest(Vec2 t, double rounding) const
    {
        for (int round = 0; round < 12; ++round) {
            const At now = at(t);
            if (std::abs(now.value) <= rounding)
                return Crossing{t, now.position};
            const double steep = glm::dot(now.slope, now.slope);
            if (!(steep > 0))
                return std::nullopt;
            t = glm::clamp(t - now.slope * (now.value / steep), Vec2(0), Vec2(1));
        }
        return std::nullopt;
    }

private:
    const SceneObject& object_;
    const SectionPlane& plane_;
    Vec2 low_;
    Vec2 size_;
};

// Finds the pieces of all triangles.
class Cutting {
public:
    Cutting(const SceneObject& object, const Tessellation& mesh, const SectionPlane& plane, double tolerance)
        : object_(object),
          mesh_(mesh),
          plane_(plane),
          tolerance_(tolerance),
          rounding_(1e-13 * object.bounds().diagonal() + 1e-15 * std::abs(plane.offset))
    {
    }

    [[nodiscard]] std::vector<Piece> run()
    {
        const std::vector<Vec3>& vertices = mesh_.mesh.vertices;
        above_.reserve(vertices.size());
        for (const Vec3& vertex : vertices)
            above_.push_back(glm::dot(plane_.normal, vertex) - plane_.offset >= 0);
        for (size_t patch = 0; patch < mesh_.patches.size(); ++patch) {
            const Height height(object_, mesh_.patches[patch].quad, plane_);
            for (size_t k = mesh_.patches[patch].firstTriangle; k < mesh_.endOf(patch); ++k)
                cutTriangle(k, height);
        }
        return std::move(pieces_);
    }

private:
    void cutTriangle(size_t number, const Height& height)
    {
        const Triangle& triangle = mesh_.mesh.triangles[number];
        const TriangleParameters& t = mesh_.parameters[number];
        Piece piece;
        std::array<Vec2, 2> ends{};
        size_t found = 0;
        for (size_t k = 0; k < 3; ++k) {
            const size_t next = (k + 1) % 3;
            if (above_[triangle[k]] == above_[triangle[next]])
                continue;
            piece.edges[found] = edgeKey(triangle[k], triangle[next]);
            // The same place from both sides: whoever comes first finds it.
            const Crossing crossing = height.between(t[k], t[next]);
            ends[found] = crossing.t;
            crossings_.emplace(piece.edges[found], crossing.position);
            ++found;
        }
        if (found < 2)
            return;
        const Crossing from{ends[0], crossings_.at(piece.edges[0])};
        const Crossing to{ends[1], crossings_.at(piece.edges[1])};
        piece.points.push_back(from.position);
        follow(height, from, to, 0, piece.points);
        pieces_.push_back(std::move(piece));
    }

    // Adds the points after `from` up to `to`.
    void follow(const Height& height, const Crossing& from, const Crossing& to, int halvings,
                std::vector<Vec3>& points) const
    {
        const auto middle =
            halvings < kMostHalvings ? height.nearest(0.5 * (from.t + to.t), rounding_) : std::nullopt;
        if (middle && isBetween(from, *middle, to) &&
            (glm::distance(middle->position, 0.5 * (from.position + to.position)) > tolerance_)) {
            follow(height, from, *middle, halvings + 1, points);
            follow(height, *middle, to, halvings + 1, points);
            return;
        }
        points.push_back(to.position);
    }

    // Not thrown far off, as where the plane nearly touches.
    [[nodiscard]] static bool isBetween(const Crossing& from, const Crossing& middle, const Crossing& to)
    {
        const double chord = glm::distance(from.position, to.position);
        return chord > 0 && glm::distance(middle.position, from.position) < chord &&
               glm::distance(middle.position, to.position) < chord;
    }

    const SceneObject& object_;
    const Tessellation& mesh_;
    const SectionPlane& plane_;
    double tolerance_;
    double rounding_;
    std::vector<bool> above_;  // by vertex
    std::unordered_map<std::uint64_t, Vec3> crossings_;
    std::vector<Piece> pieces_;
};

// Joins pieces that end on the same edges.
class Joining {
public:
    explicit Joining(std::vector<Piece> pieces) : pieces_(std::move(pieces)), taken_(pieces_.size())
    {
        for (size_t k = 0; k < pieces_.size(); ++k)
            for (const std::uint64_t edge : pieces_[k].edges)
                at_.emplace(edge, k);
    }

    [[nodiscard]] std::vector<SectionCurve> run()
    {
        std::vector<SectionCurve> curves;
        // Those that end at a border first, from there on; what is left is closed.
        for (const bool closed : {false, true})
            for (size_t k = 0; k < pieces_.size(); ++k)
                for (const size_t start : {size_t{0}, size_t{1}})
                    if (!taken_[k] && (closed || at_.count(pieces_[k].edges[start]) == 1))
                        curves.push_back(walk(k, start));
        std::erase_if(curves, [](const SectionCurve& curve) { return curve.points.size() < 2; });
        return curves;
    }

private:
    [[nodiscard]] SectionCurve walk(size_t piece, size_t start)
    {
        SectionCurve curve;
        for (;;) {
            taken_[piece] = true;
            std::vector<Vec3>& points = pieces_[piece].points;
            if (start == 1)
                std::reverse(points.begin(), points.end());
            for (const Vec3& point : points)
                if (curve.points.empty() || curve.points.back() != point)
                    curve.points.push_back(point);
            const std::uint64_t edge = pieces_[piece].edges[1 - start];
            const auto [first, last] = at_.equal_range(edge);
            const auto next = std::find_if(first, last, [&](const auto& at) { return !taken_[at.second]; });
            if (next == last)
                return curve;
            piece = next->second;
            start = pieces_[piece].edges[0] == edge ? 0 : 1;
        }
    }

    std::vector<Piece> pieces_;
    std::vector<bool> taken_;
    std::unordered_multimap<std::uint64_t, size_t> at_;  // the pieces at an edge
};

}  // namespace

double SectionCurve::length() const
{
    double sum = 0;
    for (size_t k = 1; k < points.size(); ++k)
        sum += glm::distance(points[k - 1], points[k]);
    return sum;
}

SectionSurface::SectionSurface(SharedObject object, Tessellation mesh)
    : object_(std::move(object)),
      mesh_(std::make_shared<const Tessellation>(std::move(mesh)))
{
}

Result<SectionSurface> SectionSurface::create(SharedObject object, double deviation)
{
    Scene scene;
    scene.add(*object);
    auto mesh = tessellate(scene, {.deviation = deviation, .angleDegrees = {}, .hiddenToo = true});
    if (!mesh)
        return tl::unexpected(mesh.error());
    return SectionSurface(std::move(object), *std::move(mesh));
}

std::vector<SectionCurve> SectionSurface::cut(const SectionPlane& plane, double tolerance) const
{
    return Joining(Cutting(*object_, *mesh_, plane, tolerance).run()).run();
}

}  // namespace knotspan
