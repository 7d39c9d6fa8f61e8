// An edge of a placed surface as Bézier pieces: the edge itself, and how the surface leaves it. This is all
// that matching and verdicts see of a surface.
#pragma once

#include <array>

#include "model/friends/edge_part.h"

namespace knotspan {

// Homogeneous points relative to the strip's origin, over t in [0, 1]: of the edge, and the first and second
// derivatives across it, into the surface, by a parameter of the piece's own.
struct EdgeRows {
    std::vector<Vec4> at;
    std::vector<Vec4> into;
    std::vector<Vec4> bend;
    bool rational = false;  // otherwise all weights are 1 and those of derivatives 0
    [[nodiscard]] bool operator==(const EdgeRows&) const = default;
};

// The same from parameter `start` to `end` of it; start > end: run through the other way.
[[nodiscard]] EdgeRows part(const EdgeRows& rows, double start, double end);
[[nodiscard]] std::vector<Vec4> part(std::vector<Vec4> row, double start, double end);
// With the parameter tau of t / (1 - t) = factor tau / (1 - tau), up to weights that all rows share.
void projective(std::vector<Vec4>& row, double factor);

// Of rows: that of a surface's side, or of one that a trim curve of degree 1 runs through.
constexpr int kMaxEdgeDegree = 2 * kMaxDegree;
constexpr size_t kEdgeSamples = 9;

struct EdgePiece {
    EdgeRows rows;
    double from = 0;  // as `edge` counts them
    double to = 1;
    // The rest is told by the rows.
    Box box;            // in model space
    double length = 0;  // of the control polygon, no less than the piece's own
    // Tangents are within `spread` radians of the axis; pi where they point all ways.
    Vec3 axis{0};
    double spread = 0;
    std::array<Vec3, kEdgeSamples> samples{};  // at t = 0, 1/8, ..., 1, relative to the origin

    [[nodiscard]] double parameterAt(double t) const { return t == 1.0 ? to : from + t * (to - from); }
};

// Weights scaled to 1 at most, and all that is told by the rows; `origin` is the strip's.
void complete(EdgePiece& piece, const Vec3& origin);

struct EdgeStrip {
    EdgePart edge;  // the whole of it
    Vec3 origin{0};
    double reach = 0;  // how far from (0, 0, 0) coordinates go, which is what they are rounded by
    double size = 0;   // the surface's diagonal
    // No point of the true edge is further from the piece's at the same parameter; 0 for a surface's sides.
    double deviation = 0;
    std::vector<EdgePiece> pieces;
    Box box;

    [[nodiscard]] double length() const;
    // Whether nothing of it has moved.
    [[nodiscard]] bool sameAs(const EdgeStrip& other) const;
};

// In the order of `Side`; of a trimmed surface, in the order of its loops and their curves. Trim curves may
// be replaced by others that deviate by no more than `deviation`.
[[nodiscard]] std::vector<EdgeStrip> edgeStrips(std::uint32_t index, const PlacedSurface& placed,
                                                double deviation);
[[nodiscard]] size_t edgeCount(const PlacedSurface& placed);

}  // namespace knotspan
