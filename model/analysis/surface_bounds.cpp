#include "model/analysis/surface_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "model/geometry/evaluation.h"
#include "model/trimming/face_outline.h"

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

// What is left of a surface, and the box of that in its parameters.
struct Left {
    const TrimRegion& region;
    Vec2 low{};
    Vec2 high{};
};

// Looks for the highest point of a surface in one direction, or of what is left of it, where `best` is the
// highest of its outline.
class Climb {
public:
    Climb(const NurbsSurface& surface, const Mat4& transform, const Direction& direction,
          const Left* left = nullptr, const Summit& best = {})
        : surface_(surface),
          transform_(transform),
          direction_(direction),
          left_(left),
          best_(best)
    {
    }

    // No KSQuad reaches above its control points: those whose control points all lie below what has been
    // found elsewhere are not looked at. The rest are, the most promising first.
    [[nodiscard]] Summit highest()
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
        return best_;
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
        Vec2 low(surface_.knotsU()[spanU], surface_.knotsV()[spanV]);
        Vec2 high(surface_.knotsU()[spanU + 1], surface_.knotsV()[spanV + 1]);
        if (left_ != nullptr) {
            low = glm::max(low, left_->low);
            high = glm::min(high, left_->high);
        }
        if (low.x > high.x || low.y > high.y)
            return;
        const Vec2 cell = (high - low) / double{kCellsPerSpan};
        Summit summit;
        for (int i = 0; i <= kCellsPerSpan; ++i)
            for (int j = 0; j <= kCellsPerSpan; ++j)
                offer(summit, low + Vec2(i, j) * cell);
        // Of many peaks of about the same height, only so many are climbed.
        constexpr int kMostClimbs = 64;
        const bool mayBeHigher = (summit.height + ceiling) / 2 > best_.height && climbs_ < kMostClimbs;
        if (std::isfinite(summit.height) && (summit.height > best_.height || mayBeHigher)) {
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
        if (!(height > summit.height) || (left_ != nullptr && !left_->region.contains(at.x, at.y)))
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
    const Left* left_;
    double size_ = 0;  // of the control points' box in that direction
    Summit best_;
    int climbs_ = 0;
};

// The highest points of the outline of what loops leave.
class OutlineHeights {
public:
    OutlineHeights(const NurbsSurface& surface, const Mat4& transform, const TrimRegion& region)
        : surface_(surface),
          transform_(transform)
    {
        for (OutlineArc& arc : outlineOf(region))
            for (RegionPiece& piece : arc.pieces) {
                Sampled sampled{std::move(piece), {}};
                for (int k = 0; k <= kSamples; ++k)
                    sampled.points[static_cast<size_t>(k)] = pointAt(sampled.piece, at(k));
                pieces_.push_back(std::move(sampled));
            }
    }

    // Of what lies within it.
    [[nodiscard]] Left left(const TrimRegion& region) const
    {
        Left left{region, Vec2(std::numeric_limits<double>::infinity()), {}};
        left.high = -left.low;
        for (const Sampled& sampled : pieces_)
            for (const double s : {0.0, 1.0}) {
                left.low = glm::min(left.low, parametersAt(sampled.piece, s));
                left.high = glm::max(left.high, parametersAt(sampled.piece, s));
            }
        return left;
    }

    [[nodiscard]] Summit highest(const Direction& direction) const
    {
        Summit best;
        const auto offer = [&](const Vec3& point) {
            if (direction.heightOf(point) > best.height)
                best = {direction.heightOf(point), {}, point};
        };
        for (const Sampled& sampled : pieces_)
            for (const Vec3& point : sampled.points)
                offer(point);
        for (const Sampled& sampled : pieces_)
            for (int k = 0; k <= kSamples; ++k) {
                const auto height = [&](int n) {
                    return direction.heightOf(sampled.points[static_cast<size_t>(n)]);
                };
                const int before = std::max(k - 1, 0);
                const int after = std::min(k + 1, kSamples);
                const int middle = std::clamp(k, 1, kSamples - 1);
                const double bend = std::abs(2 * height(middle) - height(middle - 1) - height(middle + 1));
                if (height(k) >= height(before) && height(k) >= height(after) &&
                    height(k) + bend > best.height)
                    offer(highestBetween(sampled.piece, at(before), at(after), direction));
            }
        return best;
    }

private:
    static constexpr int kSamples = 8;
    struct Sampled {
        RegionPiece piece;
        std::array<Vec3, kSamples + 1> points;
    };

    static double at(int k) { return static_cast<double>(k) / kSamples; }

    [[nodiscard]] Vec2 parametersAt(const RegionPiece& piece, double s) const
    {
        const Vec2 t = placeOf(piece.points, s);
        const auto parameter = [](const KnotVector& knots, int number, double part) {
            const int span = knots.spans()[static_cast<size_t>(number)];
            return std::lerp(knots[span], knots[span + 1], part);
        };
        return {parameter(surface_.knotsU(), piece.a, t.x), parameter(surface_.knotsV(), piece.b, t.y)};
    }
    [[nodiscard]] Vec3 pointAt(const RegionPiece& piece, double s) const
    {
        const Vec2 at = parametersAt(piece, s);
        return transformed(evaluate(surface_, at.x, at.y).position, transform_);
    }

    // Golden sections of a stretch with one top.
    [[nodiscard]] Vec3 highestBetween(const RegionPiece& piece, double from, double to,
                                      const Direction& direction) const
    {
        constexpr double kGolden = 0.6180339887498949;
        constexpr int kRounds = 40;
        double low = to - kGolden * (to - from);
        double high = from + kGolden * (to - from);
        Vec3 atLow = pointAt(piece, low);
        Vec3 atHigh = pointAt(piece, high);
        for (int round = 0; round < kRounds; ++round)
            if (direction.heightOf(atLow) < direction.heightOf(atHigh)) {
                from = std::exchange(low, high);
                atLow = atHigh;
                high = from + kGolden * (to - from);
                atHigh = pointAt(piece, high);
            } else {
                to = std::exchange(high, low);
                atHigh = atLow;
                low = to - kGolden * (to - from);
                atLow = pointAt(piece, low);
            }
        return atLow;
    }

    const NurbsSurface& surface_;
    const Mat4& transform_;
    std::vector<Sampled> pieces_;
};

constexpr std::array<Direction, 6> kDirections{{{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}}};

}  // namespace

Box surfaceBounds(const NurbsSurface& surface, const Mat4& transform)
{
    Box box;
    for (const Direction& direction : kDirections)
        box.add(Climb(surface, transform, direction).highest().point);
    return box;
}

Box trimmedBounds(const NurbsSurface& surface, const std::vector<TrimLoop>& loops, const Mat4& transform)
{
    const TrimRegion region(loops, surface);
    if (loops.empty() || !region.isTrimmed())
        return surfaceBounds(surface, transform);
    const OutlineHeights outline(surface, transform, region);
    const Left left = outline.left(region);
    Box box;
    for (const Direction& direction : kDirections) {
        const Summit highest =
            Climb(surface, transform, direction, &left, outline.highest(direction)).highest();
        if (std::isfinite(highest.height))
            box.add(highest.point);
    }
    return box;
}

}  // namespace knotspan
