// Where the borders of surfaces run together: edges that are the same curve in space under an affine map of
// their parameters, as a whole or in part, and corners that are one point. Degree, direction and knots may
// differ; a surface may meet itself.
//
// Decided from coefficients, never from samples, to a tolerance of 2^-21 (4.8e-7, a few units of float's
// rounding) of a surface's size: half the largest side of its box, rounded down to a power of two; of two
// surfaces the larger tolerance counts. Parts below 1/1024 of a side are not told apart: where a corner lies
// that near to the end of another side without being one point with it, the sides stay open. Borders are
// numbered as in border_curves.h.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "model/analysis/border_curves.h"
#include "model/analysis/corner_groups.h"
#include "model/analysis/edge_forming.h"
#include "model/core/totals.h"

namespace knotspan {

class CoincidentEdges {
public:
    explicit CoincidentEdges(const std::vector<PlacedSurface>& surfaces = {});

    using Change = SurfaceChange;  // of as many KSQuads each way
    // Looks again only at borders that moved and at what they met or meet now. The result is as if all were
    // made anew, to the bit. False: no border moved.
    bool update(const std::vector<Change>& changes);
    // Another one after each update that moved a border; no other edges have the same.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    // What that update may have changed.
    struct Touched {
        bool all = true;
        std::vector<std::uint32_t> sides;    // the edges along them, or that they are poles
        std::vector<std::uint32_t> corners;  // who owns them, or where they are
    };
    [[nodiscard]] const Touched& touched() const { return touched_; }
    // Where since that revision borders moved and all sides and corners are joined as they were: the surfaces
    // at whose borders something moved, perhaps several times each. Nothing: joined otherwise, or nobody
    // knows.
    [[nodiscard]] std::optional<std::vector<std::uint32_t>> onlyMovedSince(std::uint64_t revision) const;

    [[nodiscard]] const std::vector<BorderNumbers>& numbers() const { return numbers_; }
    [[nodiscard]] std::uint32_t sideCount() const { return static_cast<std::uint32_t>(sides_.size()); }
    [[nodiscard]] const CornerGroups& corners() const { return corners_; }

    // All its points are one, that of its corners: a pole.
    [[nodiscard]] bool isCollapsed(std::uint32_t side) const { return sides_[side].collapsed; }
    // Null where nobody else lies along any part of the side.
    [[nodiscard]] const CoincidentEdge* edgeAlong(std::uint32_t side) const { return edges_[side].get(); }

private:
    struct BorderSide {
        BezierNet curve;
        Box box;
        std::uint32_t surface = 0;
        std::array<std::uint32_t, 2> corners{};
        bool collapsed = false;
        bool inGrid = false;
    };
    // A corner within a side, not at its ends.
    struct Hit {
        std::uint32_t corner = 0;
        double t = 0;
    };
    struct OnSide {
        std::uint32_t owner = 0;  // of the group of corners there
        double t = 0;
    };
    struct Moved {
        std::vector<std::uint32_t> sides;
        CornerGroups::Moves corners;
        bool poles = false;  // some side is one now, or is one no more
    };

    void setSurface(std::uint32_t index, const PlacedSurface& placed, Moved& moved);
    void findAll();
    void moveAll(const Moved& moved, double widest);
    void placeInGrid(const std::vector<std::uint32_t>& sides);
    void dropHits(const std::vector<std::uint32_t>& sides, const std::vector<std::uint32_t>& corners);
    void findHits(const std::vector<std::uint32_t>& sides, const std::vector<std::uint32_t>& corners);
    void lookFor(std::uint32_t corner, std::uint32_t side);
    void dropOverlaps(const std::vector<std::uint32_t>& sides);
    void findOverlaps(const std::vector<std::uint32_t>& sides);
    void compare(std::uint32_t a, std::uint32_t b);
    // False: all are joined as they were.
    bool joinEdges(const std::vector<std::uint32_t>& sides);
    [[nodiscard]] Box boxOfCorner(std::uint32_t corner) const;

    [[nodiscard]] Box reachOf(std::uint32_t side) const;
    [[nodiscard]] std::vector<OnSide> cornersOn(std::uint32_t side) const;
    [[nodiscard]] std::vector<std::uint32_t> besides(std::uint32_t side) const;
    [[nodiscard]] std::vector<std::uint32_t> sidesAt(const std::vector<std::uint32_t>& corners) const;
    [[nodiscard]] std::vector<std::uint32_t> connected(std::vector<std::uint32_t> sides) const;

    // An update that joined nothing otherwise.
    struct Move {
        std::uint64_t before = 0;  // the revision
        std::vector<std::uint32_t> surfaces;
    };

    void noteMove(std::uint64_t before, const std::vector<std::uint32_t>& sides);

    std::uint64_t revision_ = 0;
    Touched touched_;
    std::deque<Move> moves_;
    Totals<Box> cornerBoxes_;
    std::vector<BorderNumbers> numbers_;
    std::vector<double> tolerances_;  // by surface
    double widest_ = 0;               // of them
    std::vector<BorderSide> sides_;
    std::vector<std::array<std::uint32_t, 2>> sidesOfCorner_;
    CornerGroups corners_;
    BoxHash grid_;                                        // of sides
    std::vector<std::vector<Hit>> hits_;                  // by side
    std::vector<std::vector<std::uint32_t>> sidesHitBy_;  // by corner
    std::vector<SideOverlaps> overlaps_;                  // by side
    std::vector<std::shared_ptr<const CoincidentEdge>> edges_;
};

}  // namespace knotspan
