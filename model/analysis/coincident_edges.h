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

#include <memory>

#include "model/analysis/border_curves.h"
#include "model/analysis/corner_groups.h"
#include "model/analysis/edge_forming.h"

namespace knotspan {

class CoincidentEdges {
public:
    explicit CoincidentEdges(const std::vector<PlacedSurface>& surfaces = {});

    using Change = SurfaceChange;  // of as many KSQuads each way
    // Looks again only at borders that moved and at what they met or meet now. The result is as if all were
    // made anew, to the bit. False: no border moved.
    bool update(const std::vector<Change>& changes);

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
    void joinEdges(const std::vector<std::uint32_t>& sides);

    [[nodiscard]] Box reachOf(std::uint32_t side) const;
    [[nodiscard]] std::vector<OnSide> cornersOn(std::uint32_t side) const;
    [[nodiscard]] std::vector<std::uint32_t> besides(std::uint32_t side) const;
    [[nodiscard]] std::vector<std::uint32_t> sidesAt(const std::vector<std::uint32_t>& corners) const;
    [[nodiscard]] std::vector<std::uint32_t> connected(std::vector<std::uint32_t> sides) const;

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
