#include "model/analysis/coincident_edges.h"

#include <atomic>
#include <numeric>
#include <utility>

#include "model/analysis/bezier_curves.h"
#include "model/core/check.h"

namespace knotspan {

namespace {

using Indices = std::vector<std::uint32_t>;

void sortUnique(Indices& indices)
{
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

Indices upTo(size_t count)
{
    Indices indices(count);
    std::iota(indices.begin(), indices.end(), 0U);
    return indices;
}

double toleranceOf(const PlacedSurface& placed)
{
    const Vec3 size = transformed(placed.surface->bounds(), placed.transform).size();
    const double extent = std::max({size.x, size.y, size.z}) / 2;
    if (!(extent > 0.0 && std::isfinite(extent)))
        return 0.0;
    return std::ldexp(1.0, std::ilogb(extent) - 21);
}

std::uint64_t newRevision()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

bool isPoint(const BezierNet& curve, double tolerance)
{
    const Vec3 first = pointOf(curve.points[0]);
    return std::all_of(curve.points.begin(), curve.points.end(),
                       [&](const Vec4& point) { return glm::distance(pointOf(point), first) <= tolerance; });
}

}  // namespace

CoincidentEdges::CoincidentEdges(const std::vector<PlacedSurface>& surfaces)
    : revision_(newRevision()),
      numbers_(borderNumbers(surfaces)),
      tolerances_(surfaces.size(), -1.0)
{
    const size_t count = numbers_.empty() ? 0 : numbers_.back().firstBorder + numbers_.back().borderCount();
    sides_.resize(count);
    sidesOfCorner_.resize(count);
    Indices names(count);
    Indices met(count, 0);
    for (std::uint32_t index = 0; index < numbers_.size(); ++index) {
        const BorderNumbers& numbers = numbers_[index];
        for (std::uint32_t k = 0; k < numbers.borderCount(); ++k) {
            BorderSide& side = sides_[numbers.firstBorder + k];
            side.surface = index;
            side.corners = numbers.cornersOf(k);
            for (const std::uint32_t corner : side.corners)
                sidesOfCorner_[corner][met[corner]++] = numbers.firstBorder + k;
        }
        for (std::uint32_t i = 0; i <= numbers.spansU; ++i)
            for (std::uint32_t j = 0; j <= numbers.spansV; j += i % numbers.spansU == 0 ? 1 : numbers.spansV)
                names[numbers.corner(i, j)] = numbers.cornerName(i, j);
    }
    Moved moved;
    for (std::uint32_t index = 0; index < surfaces.size(); ++index)
        setSurface(index, surfaces[index], moved);
    std::vector<CornerPlace> places(count);
    for (const auto& [corner, place] : moved.corners)
        places[corner] = place;
    if (!tolerances_.empty())
        widest_ = *std::max_element(tolerances_.begin(), tolerances_.end());
    corners_ = CornerGroups(std::move(names), places, widest_);
    findAll();
}

// Grid and groups stay as they are.
void CoincidentEdges::setSurface(std::uint32_t index, const PlacedSurface& placed, Moved& moved)
{
    const BorderNumbers& numbers = numbers_[index];
    const double tolerance = toleranceOf(placed);
    const bool sameTolerance = tolerance == tolerances_[index];
    std::vector<BezierNet> curves = borderCurves(placed);
    check(curves.size() == numbers.borderCount(), "a changed surface has as many KSQuads as before");
    for (std::uint32_t k = 0; k < curves.size(); ++k) {
        const std::uint32_t number = numbers.firstBorder + k;
        BorderSide& side = sides_[number];
        if (sameTolerance && side.curve == curves[k])
            continue;
        moved.sides.push_back(number);
        side.curve = std::move(curves[k]);
        const bool collapsed = isPoint(side.curve, tolerance);
        const bool wasCollapsed = std::exchange(side.collapsed, collapsed);
        moved.poles = moved.poles || collapsed != wasCollapsed;
    }
    tolerances_[index] = tolerance;
    // Of the two sides at a corner the first one says where it is.
    for (std::uint32_t corner = numbers.firstBorder; corner < numbers.firstBorder + numbers.borderCount();
         ++corner) {
        const BorderSide& side = sides_[sidesOfCorner_[corner][0]];
        const Vec4& end = side.corners[0] == corner ? side.curve.points.front() : side.curve.points.back();
        const CornerPlace place{pointOf(end), tolerance};
        if (corner >= corners_.count() || !(place == corners_.place(corner)))
            moved.corners.emplace_back(corner, place);
    }
}

void CoincidentEdges::findAll()
{
    grid_ = {};
    hits_.assign(sides_.size(), {});
    sidesHitBy_.assign(sides_.size(), {});
    overlaps_.assign(sides_.size(), {});
    edges_.assign(sides_.size(), nullptr);
    const Indices all = upTo(sides_.size());
    for (BorderSide& side : sides_)
        side.inGrid = false;
    placeInGrid(all);
    std::vector<Box> boxes;
    for (const std::uint32_t corner : all)
        boxes.push_back(boxOfCorner(corner));
    cornerBoxes_ = Totals<Box>(boxes);
    findHits({}, all);
    findOverlaps(all);
    joinEdges(all);
}

bool CoincidentEdges::update(const std::vector<Change>& changes)
{
    Moved moved;
    for (const Change& change : changes)
        setSurface(change.index, change.placed, moved);
    if (moved.sides.empty() && moved.corners.empty())
        return false;
    const std::uint64_t before = std::exchange(revision_, newRevision());
    const double widest = *std::max_element(tolerances_.begin(), tolerances_.end());
    if (widest != widest_ || moved.sides.size() > sides_.size() / 4) {
        moves_.clear();
        touched_ = {};
        moveAll(moved, widest);
        return true;
    }
    placeInGrid(moved.sides);
    const Indices corners = corners_.move(moved.corners);
    for (const auto& [corner, place] : moved.corners)
        cornerBoxes_.set(corner, boxOfCorner(corner));
    sortUnique(moved.sides);
    Indices sides = moved.sides;
    const auto include = [&](const Indices& more) { sides.insert(sides.end(), more.begin(), more.end()); };
    include(sidesAt(corners));
    dropHits(moved.sides, corners);
    findHits(moved.sides, corners);
    include(sidesAt(corners));
    sortUnique(sides);
    Indices affected = connected(sides);
    dropOverlaps(sides);
    findOverlaps(sides);
    affected = connected(std::move(affected));
    const bool joined = joinEdges(affected);
    touched_ = {false, std::move(affected), corners};
    if (joined || moved.poles)
        moves_.clear();
    else
        noteMove(before, touched_.sides);
    return true;
}

void CoincidentEdges::noteMove(std::uint64_t before, const Indices& sides)
{
    constexpr size_t kMost = 64;
    if (moves_.size() == kMost)
        moves_.pop_front();
    Indices surfaces;
    for (const std::uint32_t side : sides)
        surfaces.push_back(sides_[side].surface);
    sortUnique(surfaces);
    moves_.push_back({before, std::move(surfaces)});
}

std::optional<Indices> CoincidentEdges::onlyMovedSince(std::uint64_t revision) const
{
    Indices surfaces;
    if (revision == revision_)
        return surfaces;
    for (auto move = moves_.rbegin(); move != moves_.rend(); ++move) {
        surfaces.insert(surfaces.end(), move->surfaces.begin(), move->surfaces.end());
        if (move->before == revision)
            return surfaces;
    }
    return std::nullopt;
}

void CoincidentEdges::moveAll(const Moved& moved, double widest)
{
    widest_ = widest;
    Indices names;
    std::vector<CornerPlace> places;
    for (std::uint32_t corner = 0; corner < corners_.count(); ++corner) {
        names.push_back(corners_.nameOf(corner));
        places.push_back(corners_.place(corner));
    }
    for (const auto& [corner, place] : moved.corners)
        places[corner] = place;
    corners_ = CornerGroups(std::move(names), places, widest_);
    findAll();
}

void CoincidentEdges::placeInGrid(const Indices& sides)
{
    for (const std::uint32_t number : sides) {
        BorderSide& side = sides_[number];
        if (side.inGrid)
            grid_.erase(number, reachOf(number));
        side.box = boundsOf(side.curve);
        side.inGrid = !side.collapsed;
        if (side.inGrid)
            grid_.insert(number, reachOf(number));
    }
}

// Where corners are looked for: each within the larger tolerance of both.
Box CoincidentEdges::reachOf(std::uint32_t side) const
{
    return {sides_[side].box.low - Vec3(widest_), sides_[side].box.high + Vec3(widest_)};
}

void CoincidentEdges::dropHits(const Indices& sides, const Indices& corners)
{
    const auto drop = [this](std::uint32_t side, std::uint32_t corner) {
        std::erase_if(hits_[side], [corner](const Hit& hit) { return hit.corner == corner; });
        std::erase(sidesHitBy_[corner], side);
    };
    for (const std::uint32_t side : sides)
        for (const Hit& hit : std::vector<Hit>(hits_[side]))
            drop(side, hit.corner);
    for (const std::uint32_t corner : corners)
        for (const std::uint32_t side : Indices(sidesHitBy_[corner]))
            drop(side, corner);
}

void CoincidentEdges::findHits(const Indices& sides, const Indices& corners)
{
    for (const std::uint32_t corner : corners)
        grid_.near(corners_.place(corner).at, [&](std::uint32_t side) { lookFor(corner, side); });
    for (const std::uint32_t side : sides) {
        const Box reach = reachOf(side);
        const auto meets = [&](const Box& box) {
            for (int axis = 0; axis < 3; ++axis)
                if (box.low[axis] > reach.high[axis] || box.high[axis] < reach.low[axis])
                    return false;
            return true;
        };
        cornerBoxes_.visitWhere(meets, [&](size_t index) {
            const auto corner = static_cast<std::uint32_t>(index);
            if (index < corners_.count() && !std::binary_search(corners.begin(), corners.end(), corner))
                lookFor(corner, side);
        });
    }
}

// Both it and a side's reach are as wide as any tolerance, so that rounding leaves nobody out.
Box CoincidentEdges::boxOfCorner(std::uint32_t corner) const
{
    const Vec3& at = corners_.place(corner).at;
    return {at - Vec3(widest_), at + Vec3(widest_)};
}

// Notes where the corner lies on the side, if it does and is not one of its ends.
void CoincidentEdges::lookFor(std::uint32_t corner, std::uint32_t side)
{
    const BorderSide& along = sides_[side];
    const CornerPlace& place = corners_.place(corner);
    const double tolerance = std::max(place.tolerance, tolerances_[along.surface]);
    for (int axis = 0; axis < 3; ++axis)
        if (!(place.at[axis] >= along.box.low[axis] - tolerance &&
              place.at[axis] <= along.box.high[axis] + tolerance))
            return;
    const std::uint32_t owner = corners_.ownerOf(corner);
    if (along.collapsed || owner == corners_.ownerOf(along.corners[0]) ||
        owner == corners_.ownerOf(along.corners[1]))
        return;
    for (const double t : parametersAt(along.curve, place.at, tolerance)) {
        if (t < kShortestPart || t > 1 - kShortestPart)
            continue;
        hits_[side].push_back({corner, t});
        if (sidesHitBy_[corner].empty() || sidesHitBy_[corner].back() != side)
            sidesHitBy_[corner].push_back(side);
    }
}

// The sides that end at the corners or that they lie on.
Indices CoincidentEdges::sidesAt(const Indices& corners) const
{
    Indices sides;
    for (const std::uint32_t corner : corners) {
        sides.insert(sides.end(), sidesOfCorner_[corner].begin(), sidesOfCorner_[corner].end());
        sides.insert(sides.end(), sidesHitBy_[corner].begin(), sidesHitBy_[corner].end());
    }
    return sides;
}

}  // namespace knotspan
