#include "renderer/scene/framed_points.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <glm/common.hpp>

#include "model/geometry/evaluation.h"
#include "model/trimming/loop_reading.h"

namespace knotspan {

namespace {

constexpr int kCellsPerSpan = 4;
constexpr double kMostCells = 32;

struct Range {
    Vec2 low{std::numeric_limits<double>::infinity()};
    Vec2 high{-std::numeric_limits<double>::infinity()};
};

// Of the parameters that the loops reach over; nothing where that is all of the surface.
std::optional<Range> rangeOf(const SceneObject& object)
{
    if (object.trimLoops.empty())
        return std::nullopt;
    const LoopReading reading = readLoops(object.trimLoops, object.surface);
    if (reading.refused || reading.startsInside)
        return std::nullopt;
    Range range;
    for (const LoopChain& chain : reading.chains)
        for (const LoopArc& part : chain)
            for (const TrimPoint& point : part.arc.points) {
                range.low = glm::min(range.low, point.position);
                range.high = glm::max(range.high, point.position);
            }
    const KnotVector& u = object.surface.knotsU();
    const KnotVector& v = object.surface.knotsV();
    range.low = glm::max(range.low, Vec2(u.domainStart(), v.domainStart()));
    range.high = glm::min(range.high, Vec2(u.domainEnd(), v.domainEnd()));
    if (range.low.x > range.high.x || range.low.y > range.high.y)
        return std::nullopt;
    return range;
}

int cellsBetween(const KnotVector& knots, double low, double high)
{
    const double spans = static_cast<double>(knots.spans().size());
    const double share = (high - low) / (knots.domainEnd() - knots.domainStart());
    return static_cast<int>(std::clamp(kCellsPerSpan * spans * share, double{kCellsPerSpan}, kMostCells));
}

void addPart(const SceneObject& object, const Range& range, std::vector<Vec3>& to)
{
    const NurbsSurface& surface = object.surface;
    const int cellsU = cellsBetween(surface.knotsU(), range.low.x, range.high.x);
    const int cellsV = cellsBetween(surface.knotsV(), range.low.y, range.high.y);
    for (int i = 0; i <= cellsU; ++i)
        for (int j = 0; j <= cellsV; ++j) {
            const Vec2 at = glm::mix(range.low, range.high, Vec2(double(i) / cellsU, double(j) / cellsV));
            to.push_back(transformed(evaluate(surface, at.x, at.y).position, object.transform));
        }
}

}  // namespace

std::vector<Vec3> framedPoints(const Scene& scene)
{
    Scene whole = scene;
    std::vector<Vec3> parts;
    for (const auto& [id, object] : scene.objects()) {
        const std::optional<Range> range = object->visible ? rangeOf(*object) : std::nullopt;
        if (!range)
            continue;
        addPart(*object, *range, parts);
        whole.exchange(id, nullptr);
    }
    std::vector<Vec3> points = whole.hullPoints();
    points.insert(points.end(), parts.begin(), parts.end());
    return points;
}

}  // namespace knotspan
