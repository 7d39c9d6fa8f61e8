#include "model/trimming/border_trimming.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "model/trimming/loop_crossings.h"
#include "model/trimming/projected_sheet.h"
#include "model/trimming/trim_region.h"

namespace knotspan {

namespace {

constexpr int kCellsPerSpan = 6;
constexpr double kNoSpecialPlace = 0.4142;  // of a curve
constexpr size_t kStarts = 64;  // places of a border to begin at that are looked at, or one for each piece

// Where points of the picture lie on a face: searched from every cell that may be there.
class SeenFace {
public:
    SeenFace(const PlacedFace& face, const Sight& sight)
        : sight_(sight),
          sheet_(face.surface, {sight.toPlane, face.transform}),
          region_(face.loops, face.surface)
    {
        const std::vector<double> u = places(face.surface.knotsU());
        const std::vector<double> v = places(face.surface.knotsV());
        std::vector<std::optional<Vec2>> seen;
        for (const double atU : u)
            for (const double atV : v) {
                const auto picture = sheet_.picture({atU, atV});
                seen.push_back(picture ? std::optional(picture->at) : std::nullopt);
            }
        for (size_t i = 0; i + 1 < u.size(); ++i)
            for (size_t j = 0; j + 1 < v.size(); ++j) {
                const size_t at = i * v.size() + j;
                addCell({(u[i] + u[i + 1]) / 2, (v[j] + v[j + 1]) / 2},
                        {seen[at], seen[at + 1], seen[at + v.size()], seen[at + v.size() + 1]});
            }
    }

    struct Place {
        Vec2 at;
        bool isLeft = false;  // not trimmed away
    };
    // The nearest to the eye, of what is left if there is some.
    [[nodiscard]] std::optional<Place> placeOf(const Vec2& point) const
    {
        std::optional<Place> best;
        double most = 0;
        for (const Cell& cell : cells_) {
            if (glm::any(glm::lessThan(point, cell.low)) || glm::any(glm::greaterThan(point, cell.high)))
                continue;
            const auto found = sheet_.placeOf(point, cell.middle);
            const auto at = found ? withinDomain(*found) : std::nullopt;
            if (!at)
                continue;
            const bool isLeft = !region_.isTrimmed() || region_.contains(at->x, at->y);
            const double nearness = sight_.nearness(sheet_.position(*at));
            if (!best || (isLeft != best->isLeft ? isLeft : nearness > most)) {
                best = Place{*at, isLeft};
                most = nearness;
            }
        }
        return best;
    }

private:
    struct Cell {
        Vec2 low;
        Vec2 high;
        Vec2 middle;  // u, v
    };

    static std::vector<double> places(const KnotVector& knots)
    {
        std::vector<double> result{knots.domainStart()};
        for (const int span : knots.spans())
            for (int k = 1; k <= kCellsPerSpan; ++k)
                result.push_back(
                    std::lerp(knots[span], knots[span + 1], static_cast<double>(k) / kCellsPerSpan));
        return result;
    }

    void addCell(const Vec2& middle, const std::array<std::optional<Vec2>, 4>& corners)
    {
        if (!std::all_of(corners.begin(), corners.end(), [](const auto& corner) { return corner; }))
            return;
        Cell cell{*corners[0], *corners[0], middle};
        for (const auto& corner : corners) {
            cell.low = glm::min(cell.low, *corner);
            cell.high = glm::max(cell.high, *corner);
        }
        const Vec2 margin = Vec2(std::max(cell.high.x - cell.low.x, cell.high.y - cell.low.y) / 2);
        cell.low -= margin;
        cell.high += margin;
        cells_.push_back(cell);
    }

    [[nodiscard]] std::optional<Vec2> withinDomain(Vec2 at) const
    {
        at = sheet_.acrossSeams(at);
        const Vec2 inside = glm::clamp(at, sheet_.low(), sheet_.low() + sheet_.size());
        return glm::all(glm::lessThan(glm::abs(at - inside), 1e-9 * sheet_.size())) ? std::optional(inside)
                                                                                    : std::nullopt;
    }

    const Sight& sight_;
    ProjectedSheet sheet_;
    TrimRegion region_;
    std::vector<Cell> cells_;
};

struct Start {
    size_t piece = 0;
    double t = 0;
    SeenFace::Place place;
};

// Where the curve first lies over what is left of the face, else over its surface.
std::optional<Start> startOn(const SeenFace& face, const PlaneCurve& curve)
{
    std::optional<Start> result;
    const size_t each = std::max<size_t>(1, kStarts / curve.size());
    for (size_t piece = 0; piece < curve.size(); ++piece)
        for (size_t k = 0; k < each; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(each);
            const auto place = face.placeOf(curve[piece].at(t));
            if (place && (!result || place->isLeft))
                result = Start{piece, t, *place};
            if (result && result->place.isLeft)
                return result;
        }
    return result;
}

PlanePiece partOf(const PlanePiece& piece, double from, double to)
{
    PlanePiece part;
    part.at = [=](double t) { return piece.at(std::lerp(from, to, t)); };
    part.change = [=](double t) { return (to - from) * piece.change(std::lerp(from, to, t)); };
    for (const double at : piece.breaks)
        if (at > from && at < to)
            part.breaks.push_back((at - from) / (to - from));
    return part;
}

PlaneCurve begunAt(PlaneCurve curve, const Start& start)
{
    std::rotate(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(start.piece), curve.end());
    if (start.t > 0) {
        const PlanePiece whole = curve.front();
        curve.front() = partOf(whole, start.t, 1);
        curve.push_back(partOf(whole, 0, start.t));
    }
    return curve;
}

}  // namespace

Result<BorderTrim> trimmedByBorder(const PlacedFace& face, const PlacedFace& cutter, const Sight& sight,
                                   double tolerance, KeptSide side)
{
    const auto borders = seenBorders(cutter, sight);
    if (!borders)
        return tl::unexpected(borders.error());
    const SeenFace seen(face, sight);
    BorderTrim result{face.loops, 0};
    std::vector<std::vector<TrimLoop>> parts;
    for (const PlaneCurve& border : *borders) {
        const auto start = startOn(seen, border);
        if (!start)
            return failure("As seen from here the border does not meet the surface",
                           "Turn the view, or move one of the surfaces");
        const auto curve = projectedOnto(face.surface, {sight.toPlane, face.transform},
                                         begunAt(border, *start), start->place.at, tolerance);
        if (!curve)
            return failure("The border comes to where the surface is seen edge-on or turns away",
                           "Turn the view so that the surface faces you where the border lies over it");
        const bool isInside = side == KeptSide::inside;
        auto loops = trimmedBy(curve->curves, isInside ? face.loops : result.loops, face.surface, side);
        if (!loops)
            return tl::unexpected(loops.error());
        if (isInside)
            parts.push_back(*std::move(loops));
        else
            result.loops = *std::move(loops);
        result.error = std::max(result.error, curve->error);
    }
    if (parts.empty())
        return result;
    auto joined = joinedParts(parts, face.surface);
    if (!joined)
        return tl::unexpected(joined.error());
    result.loops = *std::move(joined);
    return result;
}

Result<std::vector<TrimLoop>> joinedParts(const std::vector<std::vector<TrimLoop>>& parts,
                                          const NurbsSurface& surface)
{
    std::vector<TrimLoop> all;
    for (const std::vector<TrimLoop>& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    if (parts.size() < 2)
        return all;
    bool overlap = !crossingsOf(TrimRegion(all, surface)).empty();
    for (const std::vector<TrimLoop>& part : parts) {
        const TrimRegion region(part, surface);
        for (const std::vector<TrimLoop>& other : parts)
            if (&other != &part && !other.empty() && !other.front().curves.empty()) {
                const TrimCurve& curve = other.front().curves.front();
                const Vec2 at = curve.evaluate(
                    std::lerp(curve.knots().domainStart(), curve.knots().domainEnd(), kNoSpecialPlace));
                overlap = overlap || region.contains(at.x, at.y);
            }
    }
    if (overlap)
        return failure("The borders overlap each other on the surface",
                       "Take one of them; for what several share keep the inside of one after the other");
    return all;
}

}  // namespace knotspan
