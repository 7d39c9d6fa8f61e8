#include "model/trimming/seen_borders.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/trimming/projected_sheet.h"
#include "model/trimming/trim_region.h"

namespace knotspan {

namespace {

constexpr double kSame = 1e-9;       // share of a size that is nothing
constexpr double kWidestGap = 0.01;  // of a curve's size in the picture
constexpr double kThinnest = 1e-6;   // width of a curve in the picture by its length
constexpr int kSamples = 16;

using Curves = std::vector<TrimCurve>;

struct Borders {
    std::vector<Curves> loops;  // each counts
    std::vector<Curves> rings;  // around a closed surface: one counts
};

Vec2 startOf(const TrimCurve& curve)
{
    return curve.evaluate(curve.knots().domainStart());
}
Vec2 endOf(const TrimCurve& curve)
{
    return curve.evaluate(curve.knots().domainEnd());
}
// At s of 0 to 1.
Vec2 placeAt(const TrimCurve& curve, double s)
{
    return curve.evaluate(std::lerp(curve.knots().domainStart(), curve.knots().domainEnd(), s));
}

// Along their main axis they spread much further than across it.
bool isLine(const std::vector<Vec2>& places)
{
    Vec2 middle(0);
    for (const Vec2& at : places)
        middle += at / static_cast<double>(places.size());
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const Vec2& at : places) {
        const Vec2 off = at - middle;
        xx += off.x * off.x;
        xy += off.x * off.y;
        yy += off.y * off.y;
    }
    // The product of the two spreads against the square of their sum.
    return xx * yy - xy * xy <= kThinnest * kThinnest * (xx + yy) * (xx + yy);
}

class BorderFinding {
public:
    BorderFinding(const PlacedFace& face, const Sight& sight)
        : face_(face),
          sight_(sight),
          sheet_(
              std::make_shared<ProjectedSheet>(face.surface, PlaneProjection{sight.toPlane, face.transform})),
          size_(glm::length(transformed(face.surface.bounds(), face.transform).size()))
    {
    }

    [[nodiscard]] Result<std::vector<PlaneCurve>> run() const
    {
        Borders borders = trimmed();
        if (borders.loops.empty() && borders.rings.empty())
            borders = natural();
        if (!borders.rings.empty())
            borders.loops.push_back(nearest(borders.rings));
        if (borders.loops.empty())
            return failure("The surface is closed and has no border to trim by",
                           "Trim it first, or select another surface");
        std::vector<PlaneCurve> result;
        for (const Curves& loop : borders.loops) {
            auto curve = seen(loop);
            if (!curve)
                return tl::unexpected(curve.error());
            result.push_back(*std::move(curve));
        }
        return result;
    }

private:
    // A line along one side of the domain; nothing where the side is a point.
    void addSide(Curves& to, const Vec2& from, const Vec2& end) const
    {
        auto line = TrimCurve::create(KnotVector::clampedUniform(1, 1), {{from, 1}, {end, 1}});
        check(line.has_value(), "a side of the domain is a line");
        for (int k = 1; k <= kSamples; ++k)
            if (glm::distance(sheet_->position(from),
                              sheet_->position(glm::mix(from, end, static_cast<double>(k) / kSamples))) >
                kSame * size_) {
                to.push_back(*std::move(line));
                return;
            }
    }

    [[nodiscard]] Borders natural() const
    {
        const Vec2 low = sheet_->low();
        const Vec2 high = low + sheet_->size();
        const std::array<Vec2, 4> corners{low, {high.x, low.y}, high, {low.x, high.y}};
        const bool isClosedU = face_.surface.isClosedU();
        const bool isClosedV = face_.surface.isClosedV();
        Borders borders;
        Curves around;
        for (size_t k = 0; k < corners.size(); ++k) {
            const bool isAlongU = k % 2 == 0;
            if (isAlongU ? isClosedV : isClosedU)
                continue;  // a seam
            Curves side;
            addSide(side, corners[k], corners[(k + 1) % corners.size()]);
            if (side.empty())
                continue;
            if (isClosedU || isClosedV)
                borders.rings.push_back(side);
            else
                around.push_back(side.front());
        }
        if (!around.empty())
            borders.loops.push_back(around);
        return borders;
    }

    // Along a seam.
    [[nodiscard]] bool isOnSeam(const TrimCurve& curve) const
    {
        for (const int axis : {0, 1}) {
            if (!(axis == 0 ? face_.surface.isClosedU() : face_.surface.isClosedV()))
                continue;
            bool isOn = true;
            for (int k = 0; k <= kSamples && isOn; ++k) {
                const double share =
                    (placeAt(curve, static_cast<double>(k) / kSamples) - sheet_->low())[axis] /
                    sheet_->size()[axis];
                isOn = std::abs(share - std::round(share)) < kSame;
            }
            if (isOn)
                return true;
        }
        return false;
    }

    // A loop that goes along a seam and back is what lies between: rings.
    void addLoop(Borders& borders, Curves curves) const
    {
        const auto seam = std::find_if(curves.begin(), curves.end(),
                                       [&](const TrimCurve& curve) { return isOnSeam(curve); });
        if (seam == curves.end()) {
            const Vec2 way = (endOf(curves.back()) - startOf(curves.front())) / sheet_->size();
            (glm::length(way) > 0.5 ? borders.rings : borders.loops).push_back(std::move(curves));
            return;
        }
        std::rotate(curves.begin(), seam, curves.end());
        Curves ring;
        for (const TrimCurve& curve : curves)
            if (!isOnSeam(curve)) {
                ring.push_back(curve);
            } else if (!ring.empty()) {
                borders.rings.push_back(std::exchange(ring, {}));
            }
        if (!ring.empty())
            borders.rings.push_back(std::move(ring));
    }

    [[nodiscard]] Borders trimmed() const
    {
        Borders borders;
        if (TrimRegion(face_.loops, face_.surface).isTrimmed())
            for (const TrimLoop& loop : face_.loops)
                if (loop.outer && !loop.curves.empty())
                    addLoop(borders, loop.curves);
        return borders;
    }

    [[nodiscard]] Curves nearest(const std::vector<Curves>& rings) const
    {
        const Curves* best = nullptr;
        double most = 0;
        double longest = 0;
        for (const Curves& ring : rings) {
            double nearness = 0;
            double length = 0;
            for (const TrimCurve& curve : ring)
                for (int k = 0; k < kSamples; ++k) {
                    const Vec3 at = sheet_->position(placeAt(curve, static_cast<double>(k) / kSamples));
                    const Vec3 next = sheet_->position(placeAt(curve, (k + 1.0) / kSamples));
                    nearness += sight_.nearness(at);
                    length += glm::distance(at, next);
                }
            nearness /= static_cast<double>(ring.size() * kSamples);
            const bool isAsNear = best != nullptr && std::abs(nearness - most) <= kSame * size_;
            if (best == nullptr || (isAsNear ? length > longest : nearness > most)) {
                best = &ring;
                most = nearness;
                longest = length;
            }
        }
        return *best;
    }

    // Where a surface's creases cut the curve, and at its own knots.
    [[nodiscard]] std::vector<double> breaksOf(const TrimCurve& curve) const
    {
        CuttingLines lines = CuttingLines::of(face_.surface.knotsU(), face_.surface.knotsV());
        for (const int axis : {0, 1}) {
            const KnotVector& knots = axis == 0 ? face_.surface.knotsU() : face_.surface.knotsV();
            std::vector<double>& places = lines.places[axis];
            const double start = places.front();
            const double end = places.back();
            const auto isSmooth = [&](double at) {
                return at != start && at != end &&
                       std::count(knots.values().begin(), knots.values().end(), at) < knots.degree();
            };
            places.erase(std::remove_if(places.begin(), places.end(), isSmooth), places.end());
        }
        const double start = curve.knots().domainStart();
        const double length = curve.knots().domainEnd() - start;
        std::vector<double> breaks;
        for (const TrimArc& arc : bezierArcs(curve))
            for (const TrimArc& part : cutArcs(arc, lines))
                if (const double s = (part.to - start) / length; s > kSame && s < 1 - kSame)
                    breaks.push_back(s);
        std::sort(breaks.begin(), breaks.end());
        breaks.erase(std::unique(breaks.begin(), breaks.end(),
                                 [](double a, double b) { return std::abs(a - b) < kSame; }),
                     breaks.end());
        return breaks;
    }

    [[nodiscard]] PlanePiece pieceOf(const TrimCurve& curve) const
    {
        PlanePiece piece;
        piece.at = [sheet = sheet_, curve](double s) {
            const auto picture = sheet->picture(placeAt(curve, s));
            return picture ? picture->at : Vec2(std::numeric_limits<double>::quiet_NaN());
        };
        piece.change = [sheet = sheet_, curve](double s) {
            const KnotVector& knots = curve.knots();
            const auto picture = sheet->picture(placeAt(curve, s));
            const Vec2 way = curve.derivative(std::lerp(knots.domainStart(), knots.domainEnd(), s)) *
                             (knots.domainEnd() - knots.domainStart());
            return picture ? way.x * picture->byU + way.y * picture->byV : Vec2(0);
        };
        piece.breaks = breaksOf(curve);
        return piece;
    }

    [[nodiscard]] Result<PlaneCurve> seen(const Curves& loop) const
    {
        PlaneCurve pieces;
        Box box;
        std::vector<Vec2> places;
        for (const TrimCurve& curve : loop) {
            pieces.push_back(pieceOf(curve));
            for (int k = 0; k <= kSamples; ++k) {
                const Vec2 at = pieces.back().at(static_cast<double>(k) / kSamples);
                if (std::isnan(at.x))
                    return failure("The border reaches behind the eye",
                                   "Turn or move the view so that all of it is before you");
                box.add(Vec3(at, 0));
                places.push_back(at);
            }
        }
        if (isLine(places))
            return failure("The border is seen edge-on, as a line",
                           "Turn the view so that it encloses something");
        PlaneCurve result;
        for (size_t k = 0; k < pieces.size(); ++k) {
            result.push_back(pieces[k]);
            const Vec2 from = pieces[k].at(1);
            const Vec2 to = pieces[(k + 1) % pieces.size()].at(0);
            const double gap = glm::distance(from, to);
            if (gap > kWidestGap * box.diagonal())
                return failure("The border is not closed", "Select a surface with a closed border");
            if (gap > kSame * box.diagonal())
                result.push_back(
                    {[=](double t) { return glm::mix(from, to, t); }, [=](double) { return to - from; }, {}});
        }
        return result;
    }

    const PlacedFace& face_;
    const Sight& sight_;
    std::shared_ptr<const ProjectedSheet> sheet_;
    double size_;
};

}  // namespace

double Sight::nearness(const Vec3& point) const
{
    return eye.w == 0 ? glm::dot(Vec3(eye), point) : -glm::distance(Vec3(eye) / eye.w, point);
}

Result<std::vector<PlaneCurve>> seenBorders(const PlacedFace& face, const Sight& sight)
{
    return BorderFinding(face, sight).run();
}

}  // namespace knotspan
