#include "model/trimming/trim_region.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace knotspan {

TrimRegion::TrimRegion(const std::vector<TrimLoop>& loops, const NurbsSurface& surface)
    : lines_(CuttingLines::of(surface.knotsU(), surface.knotsV()))
{
    if (loops.empty())
        return;
    LoopReading reading = readLoops(loops, surface);
    findings_ = std::move(reading.findings);
    trimmed_ = !reading.refused;
    startsInside_ = reading.startsInside;
    for (const LoopChain& chain : reading.chains)
        add(chain);
}

std::vector<std::string> TrimRegion::report() const
{
    std::vector<std::string> sentences;
    for (const bool refuses : {true, false})
        for (const LoopFinding& finding : findings_)
            if ((finding.trouble == LoopTrouble::open) == refuses)
                sentences.push_back(sentenceOf(finding));
    return sentences;
}

void TrimRegion::add(const LoopChain& chain)
{
    std::vector<RegionPiece> pieces;
    for (const LoopArc& part : chain)
        addClamped(part, pieces);
    if (!pieces.empty())
        chains_.push_back(std::move(pieces));
}

// What lies beyond the domain becomes its own shadow on the border: lines there, so that chains stay closed.
void TrimRegion::addClamped(const LoopArc& part, std::vector<RegionPiece>& to) const
{
    const Vec2 low = lines_.low();
    const Vec2 high = lines_.high();
    for (TrimArc arc : cutArcs(part.arc, lines_)) {
        const Vec2 middle = 0.5 * (arc.start() + arc.end());
        if (middle != glm::clamp(middle, low, high)) {
            const Vec2 start = glm::clamp(arc.start(), low, high);
            const Vec2 end = glm::clamp(arc.end(), low, high);
            LoopArc shadow{{{{start, 1}, {end, 1}}, arc.from, arc.to}, part.loop, kNoCurve};
            for (const TrimArc& line : cutArcs(shadow.arc, lines_))
                to.push_back(pieceOf(line, shadow));
            continue;
        }
        to.push_back(pieceOf(arc, part));
    }
}

TrimRegion::Place TrimRegion::placeOf(double u, double v) const
{
    Place place;
    const Vec2 at(u, v);
    for (const int axis : {0, 1}) {
        const std::vector<double>& places = lines_.places[axis];
        const double inside = std::clamp(at[axis], places.front(), places.back());
        const auto next = std::upper_bound(places.begin() + 1, places.end() - 1, inside);
        (axis == 0 ? place.a : place.b) = static_cast<int>(next - places.begin()) - 1;
        place.t[axis] = (inside - next[-1]) / (next[0] - next[-1]);
    }
    return place;
}

RegionPiece TrimRegion::pieceOf(const TrimArc& arc, const LoopArc& part) const
{
    const Vec2 middle = 0.5 * (arc.start() + arc.end());
    const Place place = placeOf(middle.x, middle.y);
    RegionPiece piece{part.loop, part.curve, arc.from, arc.to, place.a, place.b, arc.points};
    const Vec2 low(lines_.places[0][static_cast<size_t>(place.a)],
                   lines_.places[1][static_cast<size_t>(place.b)]);
    const Vec2 high(lines_.places[0][static_cast<size_t>(place.a) + 1],
                    lines_.places[1][static_cast<size_t>(place.b) + 1]);
    for (TrimPoint& point : piece.points)
        point.position = glm::clamp((point.position - low) / (high - low), Vec2(0.0), Vec2(1.0));
    return piece;
}

bool runsLeftOf(const std::vector<TrimPoint>& points, const Vec2& place)
{
    const bool rises = points.front().position.y <= points.back().position.y;
    Vec2 low = points.front().position;
    Vec2 high = points.back().position;
    if (!rises)
        std::swap(low, high);
    if (place.x >= std::max(low.x, high.x))
        return true;
    if (place.x < std::min(low.x, high.x))
        return false;
    double below = rises ? 0 : 1;
    double above = 1 - below;
    for (int step = 0; step < 54; ++step) {
        const double t = (below + above) / 2;
        const Vec2 at = placeOf(points, t);
        (at.y <= place.y ? low : high) = at;
        (at.y <= place.y ? below : above) = t;
        if (place.x >= std::max(low.x, high.x))
            return true;
        if (place.x < std::min(low.x, high.x))
            return false;
    }
    return place.x >= low.x;
}

bool TrimRegion::contains(double u, double v) const
{
    if (!trimmed_)
        return true;
    Place place = placeOf(u, v);
    place.t.y = std::min(place.t.y, 1 - 1e-15);  // the upper border belongs to the surface
    bool inside = startsInside_;
    for (const std::vector<RegionPiece>& chain : chains_)
        for (const RegionPiece& piece : chain) {
            const double start = piece.points.front().position.y;
            const double end = piece.points.back().position.y;
            if (piece.b != place.b || piece.a > place.a || place.t.y < std::min(start, end) ||
                place.t.y >= std::max(start, end))
                continue;
            const bool onTheLastBorder = piece.a + 1 == countU() && piece.points.front().position.x == 1 &&
                                         piece.points.back().position.x == 1;
            if (!onTheLastBorder && (piece.a < place.a || runsLeftOf(piece.points, place.t)))
                inside = !inside;
        }
    return inside;
}

}  // namespace knotspan
