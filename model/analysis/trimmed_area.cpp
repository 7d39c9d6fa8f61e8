#include "model/analysis/trimmed_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "model/analysis/gauss_rule.h"
#include "model/geometry/evaluation.h"
#include "model/trimming/trim_region.h"

namespace knotspan {

namespace {

constexpr double kAccuracy = 1e-9;  // of the whole area
constexpr double kRounding = 1e-15;
constexpr int kMostHalvings = 24;
constexpr int kMostStepHalvings = 4;
constexpr double kTie = 1e-12;  // of a KSQuad: pieces nearer than that run along each other
constexpr double kEnd = 1e-6;   // of a piece: nearer to its ends crossings are not seen

struct PiecePoint {
    Vec2 at;
    double rise = 0;  // of v by t
};

PiecePoint pointOf(const std::vector<TrimPoint>& piece, double t)
{
    std::vector<TrimPoint> points = piece;
    while (points.size() > 2) {
        for (size_t k = 0; k + 1 < points.size(); ++k) {
            const double low = (1 - t) * points[k].weight;
            const double high = t * points[k + 1].weight;
            points[k] = {(low * points[k].position + high * points[k + 1].position) / (low + high),
                         low + high};
        }
        points.pop_back();
    }
    const auto& [a, wa] = points[0];
    const auto& [b, wb] = points[1];
    const double weight = (1 - t) * wa + t * wb;
    const double degree = static_cast<double>(piece.size()) - 1;
    return {((1 - t) * wa * a + t * wb * b) / weight, degree * wa * wb / (weight * weight) * (b.y - a.y)};
}

class CutArea {
public:
    CutArea(const NurbsSurface& surface, const TrimRegion& region, const Mat4& transform,
            const std::function<bool()>& isOff)
        : surface_(surface),
          region_(region),
          linear_(transform),
          isOff_(isOff),
          rows_(static_cast<size_t>(region.countV())),
          isCut_(static_cast<size_t>(region.countU() * region.countV()), false)
    {
        for (const auto& chain : region.chains())
            for (const RegionPiece& piece : chain) {
                rows_[static_cast<size_t>(piece.b)].push_back(&piece);
                isCut_[number(piece.a, piece.b)] = true;
            }
    }

    [[nodiscard]] Area run()
    {
        Area area = surfaceArea(surface_, Mat4(linear_), isOff_, [this](int a, int b) {
            return !isCut_[number(a, b)] && isInside(b, a, 0.5);
        });
        double whole = area.value;
        int cut = 0;
        for (int a = 0; a < region_.countU(); ++a)
            for (int b = 0; b < region_.countV(); ++b)
                if (isCut_[number(a, b)]) {
                    ++cut;
                    whole += roughArea(a, b);
                }
        allowed_ = std::max(kAccuracy * whole / (1 + 8 * cut), kRounding * whole);
        for (int a = 0; a < region_.countU(); ++a)
            for (int b = 0; b < region_.countV(); ++b) {
                if (isOff_())
                    return {0, std::numeric_limits<double>::infinity()};
                if (isCut_[number(a, b)])
                    addKsQuad(a, b, area);
            }
        area.value = std::max(0.0, area.value);
        area.error += kRounding * whole;
        return area;
    }

private:
    [[nodiscard]] size_t number(int a, int b) const { return static_cast<size_t>(a * region_.countV() + b); }

    // How much |S_u x S_v| is in a KSQuad's own parameters.
    [[nodiscard]] double stretch(double x, double y) const
    {
        const double lengthU = highU_ - lowU_;
        const double lengthV = highV_ - lowV_;
        const SurfacePoint point = evaluate(surface_, lowU_ + x * lengthU, lowV_ + y * lengthV);
        return glm::length(glm::cross(linear_ * point.du, linear_ * point.dv)) * lengthU * lengthV;
    }
    void goTo(int a, int b)
    {
        const KnotVector& u = surface_.knotsU();
        const KnotVector& v = surface_.knotsV();
        const int spanU = u.spans()[static_cast<size_t>(a)];
        const int spanV = v.spans()[static_cast<size_t>(b)];
        lowU_ = u[spanU];
        highU_ = u[spanU + 1];
        lowV_ = v[spanV];
        highV_ = v[spanV + 1];
    }
    [[nodiscard]] double roughArea(int a, int b)
    {
        goTo(a, b);
        const GaussRule& rule = coarseGauss();
        double sum = 0;
        for (size_t i = 0; i < rule.places.size(); ++i)
            for (size_t j = 0; j < rule.places.size(); ++j)
                sum += rule.weights[i] * rule.weights[j] * stretch(rule.places[i], rule.places[j]);
        return sum;
    }

    // From x to the KSQuad's end, in so many steps.
    [[nodiscard]] double across(double x, double y, const GaussRule& rule, int steps) const
    {
        const double step = (1 - x) / steps;
        if (step <= 0)
            return 0;
        double sum = 0;
        for (int part = 0; part < steps; ++part)
            for (size_t k = 0; k < rule.places.size(); ++k)
                sum += rule.weights[k] * stretch(x + step * (part + rule.places[k]), y);
        return sum * step;
    }

    // Whether the place at the left side of a KSQuad is inside, as far as what lies left of the KSQuad says.
    [[nodiscard]] bool isInside(int b, int a, double y) const
    {
        bool inside = region_.startsInside();
        for (const RegionPiece* piece : rows_[static_cast<size_t>(b)])
            if (piece->a < a && isAtHeight(*piece, y))
                inside = !inside;
        return inside;
    }
    static bool isAtHeight(const RegionPiece& piece, double y)
    {
        const double start = piece.points.front().position.y;
        const double end = piece.points.back().position.y;
        return y >= std::min(start, end) && y < std::max(start, end);
    }
    // 1 where what lies to the right of the piece is inside, -1 where it is not. Of pieces that run along
    // each other the first is the left one.
    [[nodiscard]] int sideOf(const RegionPiece& piece, const Vec2& at) const
    {
        bool inside = isInside(piece.b, piece.a, at.y);
        double shift = kTie;
        for (const RegionPiece* other : rows_[static_cast<size_t>(piece.b)]) {
            if (other == &piece)
                shift = -kTie;
            else if (other->a == piece.a && isAtHeight(*other, at.y) &&
                     runsLeftOf(other->points, {at.x + shift, at.y}))
                inside = !inside;
        }
        return inside ? -1 : 1;
    }

    struct Part {
        const std::vector<TrimPoint>* points;
        double from = 0;
        double to = 1;
        int born = 0;  // after so many halvings
    };
    [[nodiscard]] double along(const Part& part, const GaussRule& rule, int steps) const
    {
        double sum = 0;
        for (size_t k = 0; k < rule.places.size(); ++k) {
            const PiecePoint point =
                pointOf(*part.points, part.from + (part.to - part.from) * rule.places[k]);
            sum += rule.weights[k] * std::abs(point.rise) * across(point.at.x, point.at.y, rule, steps);
        }
        return sum * (part.to - part.from);
    }
    void add(const Part& part, int sign, int halvings, Area& area) const
    {
        const int steps = 1 << std::min(halvings - part.born, kMostStepHalvings);
        const double fine = along(part, narrowGauss(), steps);
        const double difference = std::abs(fine - along(part, fineGauss(), steps));
        if (difference <= allowed_ || halvings >= kMostHalvings || isOff_()) {
            area.value += sign * fine;
            area.error += difference;
            return;
        }
        const double middle = (part.from + part.to) / 2;
        add({part.points, part.from, middle, part.born}, sign, halvings + 1, area);
        add({part.points, middle, part.to, part.born}, sign, halvings + 1, area);
    }

    // In parts of which each has one side, where loops cross.
    void addPiece(const RegionPiece& piece, const Part& part, int halvings, Area& area) const
    {
        const double rough = std::abs(along(part, coarseGauss(), 1));
        if (rough <= allowed_) {  // too small to tell its sides apart
            area.error += rough;
            return;
        }
        std::array<int, 3> sides{};
        for (size_t k = 0; k < 3; ++k)
            sides[k] = sideOf(piece, pointOf(piece.points, part.from + (part.to - part.from) *
                                                                           std::array{kEnd, 0.5, 1 - kEnd}[k])
                                         .at);
        if ((sides[0] == sides[1] && sides[1] == sides[2]) || halvings == kMostHalvings) {
            if (halvings > 0)
                area.error += 2 * kEnd * rough;
            return add({part.points, part.from, part.to, halvings}, sides[1], halvings, area);
        }
        const double middle = (part.from + part.to) / 2;
        addPiece(piece, {part.points, part.from, middle}, halvings + 1, area);
        addPiece(piece, {part.points, middle, part.to}, halvings + 1, area);
    }

    void addKsQuad(int a, int b, Area& area)
    {
        goTo(a, b);
        std::vector<double> heights{0, 1};
        for (const RegionPiece* piece : rows_[static_cast<size_t>(b)]) {
            const auto& points = piece->points;
            for (const TrimPoint* end : {&points.front(), &points.back()})
                if ((piece->a == a - 1 && end->position.x == 1) || (piece->a == a && end->position.x == 0))
                    heights.push_back(end->position.y);
            if (piece->a == a && points.front().position.y != points.back().position.y)
                addPiece(*piece, {&points}, 0, area);
        }
        std::sort(heights.begin(), heights.end());
        for (size_t k = 0; k + 1 < heights.size(); ++k)
            if (heights[k] < heights[k + 1] && isInside(b, a, (heights[k] + heights[k + 1]) / 2)) {
                const std::vector<TrimPoint> line{{{0, heights[k]}, 1}, {{0, heights[k + 1]}, 1}};
                add({&line}, 1, 0, area);
            }
    }

    const NurbsSurface& surface_;
    const TrimRegion& region_;
    glm::dmat3 linear_;
    const std::function<bool()>& isOff_;
    std::vector<std::vector<const RegionPiece*>> rows_;
    std::vector<bool> isCut_;
    double allowed_ = 0;
    double lowU_ = 0;
    double highU_ = 1;
    double lowV_ = 0;
    double highV_ = 1;
};

}  // namespace

Area trimmedArea(const NurbsSurface& surface, const std::vector<TrimLoop>& loops, const Mat4& transform,
                 const std::function<bool()>& isOff)
{
    const TrimRegion region(loops, surface);
    if (!region.isTrimmed())
        return surfaceArea(surface, transform, isOff);
    return CutArea(surface, region, transform, isOff).run();
}

}  // namespace knotspan
