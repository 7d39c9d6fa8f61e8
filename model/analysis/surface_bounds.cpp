#include "model/analysis/surface_bounds.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <glm/common.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

constexpr int kCellsPerSpan = 4;

// One of six: up or down along an axis.
struct Direction {
    int axis;
    double sign;

    [[nodiscard]] double heightOf(const Vec3& point) const { return sign * point[axis]; }
};

// The highest place found so far.
struct Summit {
    double height = -std::numeric_limits<double>::infinity();
    Vec2 at{};
    Vec3 point{};
};

// Looks for the highest point of a surface in one direction.
class Climb {
public:
    Climb(const NurbsSurface& surface, const Mat4& transform, const Direction& direction)
        : surface_(surface),
          transform_(transform),
          direction_(direction)
    {
    }

    // No KSQuad reaches above its control points: those whose control points all lie below what has been
    // found elsewhere are not looked at. The rest are, the most promising first.
    [[nodiscard]] Vec3 highest()
    {
        const std::vector<double> ceilings = ceilingsOfKsQuads();
        const auto top = std::max_element(ceilings.begin(), ceilings.end());
        look(static_cast<size_t>(top - ceilings.begin()), *top);
        const double slack = 1e-10 * size_;
        std::vector<size_t> promising;
        for (size_t quad = 0; quad < ceilings.size(); ++quad)
            if (ceilings[quad] > best_.height + slack)
                promising.push_back(quad);
        std::sort(promising.begin(), promising.end(), [&](size_t a, size_t b) {
            return ceilings[a] != ceilings[b] ? ceilings[a] > ceilings[b] : a < b;
        });
        for (const size_t quad : promising) {
            if (!(ceilings[quad] > best_.height + slack))
                break;
            look(quad, ceilings[quad]);
        }
        return best_.point;
    }

private:
    // The height of the highest control point of each KSQuad, those of one span in u after another.
    [[nodiscard]] std::vector<double> ceilingsOfKsQuads()
    {
        const std::vector<double> rows = ceilingsInRows();
        const auto spans = surface_.knotsV().spans().size();
        std::vector<double> ceilings;
        ceilings.reserve(surface_.knotsU().spans().size() * spans);
        for (const int spanU : surface_.knotsU().spans()) {
            const auto first = static_cast<size_t>(spanU - surface_.degreeU());
            for (size_t k = 0; k < spans; ++k) {
                double ceiling = rows[first * spans + k];
                for (size_t i = first + 1; i <= static_cast<size_t>(spanU); ++i)
                    ceiling = std::max(ceiling, rows[i * spans + k]);
                ceilings.push_back(ceiling);
            }
        }
        return ceilings;
    }

    // Of each row of control points and each span in v.
    [[nodiscard]] std::vector<double> ceilingsInRows()
    {
        std::vector<double> rows;
        rows.reserve(static_cast<size_t>(surface_.countU()) * surface_.knotsV().spans().size());
        std::vector<double> heights(static_cast<size_t>(surface_.countV()));
        double lowest = std::numeric_limits<double>::infinity();
        double highest = -lowest;
        for (int i = 0; i < surface_.countU(); ++i) {
            for (int j = 0; j < surface_.countV(); ++j) {
                const double height =
                    direction_.heightOf(transformed(surface_.controlPoint(i, j).position, transform_));
                heights[static_cast<size_t>(j)] = height;
                lowest = std::min(lowest, height);
                highest = std::max(highest, height);
            }
            for (const int span : surface_.knotsV().spans())
                rows.push_back(*std::max_element(heights.begin() + span - surface_.degreeV(),
                                                 heights.begin() + span + 1));
        }
        size_ = highest - lowest;
        return rows;
    }

    // A grid on the KSQuad; and from its highest point upwards, if that may lead above all others.
    void look(size_t quad, double ceiling)
    {
        const auto spans = surface_.knotsV().spans().size();
        const int spanU = surface_.knotsU().spans()[quad / spans];
        const int spanV = surface_.knotsV().spans()[quad % spans];
        const Vec2 low(surface_.knotsU()[spanU], surface_.knotsV()[spanV]);
        const Vec2 cell =
            (Vec2(surface_.knotsU()[spanU + 1], surface_.knotsV()[spanV + 1]) - low) / double{kCellsPerSpan};
        Summit summit;
        for (int i = 0; i <= kCellsPerSpan; ++i)
            for (int j = 0; j <= kCellsPerSpan; ++j)
                offer(summit, low + Vec2(i, j) * cell);
        // Of many peaks of about the same height, only so many are climbed.
        constexpr int kMostClimbs = 64;
        const bool mayBeHigher = (summit.height + ceiling) / 2 > best_.height && climbs_ < kMostClimbs;
        if (summit.height > best_.height || mayBeHigher) {
            ++climbs_;
            climb(summit, cell);
        }
        if (summit.height > best_.height)
            best_ = summit;
    }

    bool offer(Summit& summit, const Vec2& at) const
    {
        const Vec3 point = transformed(evaluate(surface_, at.x, at.y).position, transform_);
        const double height = direction_.heightOf(point);
        if (!(height > summit.height))
            return false;
        summit = {height, at, point};
        return true;
    }

    // Looks to all sides at a distance that doubles wherever one of them is higher and halves where none is:
    // the top may be many short spans away.
    void climb(Summit& summit, Vec2 step) const
    {
        const Vec2 low(surface_.knotsU().domainStart(), surface_.knotsV().domainStart());
        const Vec2 high(surface_.knotsU().domainEnd(), surface_.knotsV().domainEnd());
        constexpr int kHalvings = 24;    // the height goes with the square of the distance
        constexpr int kMostLooks = 500;  // a bent ridge is followed that far
        int looks = 0;
        for (int halving = 0; halving < kHalvings && looks < kMostLooks; ++looks) {
            bool higher = false;
            for (const Vec2& side : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1), Vec2(1, 1),
                                     Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1)})
                higher |= offer(summit, glm::clamp(summit.at + side * step, low, high));
            step *= higher ? 2 : 0.5;
            halving += higher ? -1 : 1;
        }
    }

    const NurbsSurface& surface_;
    const Mat4& transform_;
    Direction direction_;
    double size_ = 0;  // of the control points' box in that direction
    Summit best_;
    int climbs_ = 0;
};

}  // namespace

Box surfaceBounds(const NurbsSurface& surface, const Mat4& transform)
{
    Box box;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            box.add(Climb(surface, transform, {axis, sign}).highest());
    return box;
}

}  // namespace knotspan
