// Which part of a surface its trim loops leave: exact pieces of the loops inside each KSQuad, and the
// reference in double for whether a point is inside. trim_index.h answers the same fast, in float.
//
// Pieces are the loops' own curves, rational where those are, of their own degree; nothing is approximated.
// Places within 1e-11 of the domain of a knot line are taken onto it.
#pragma once

#include "model/trimming/loop_reading.h"

namespace knotspan {

// A part of a loop inside one KSQuad: a rational Bézier curve whose control polygon is monotone in u and in
// v.
struct RegionPiece {
    std::uint32_t loop = 0;   // of the object's
    std::uint32_t curve = 0;  // of the loop's; kNoCurve: a line that closes a gap
    double from = 0;          // that curve's parameters; piece and curve agree at from + s (to - from)
    double to = 1;
    int a = 0;                      // the KSQuad: non-empty spans before it along u
    int b = 0;                      // and along v
    std::vector<TrimPoint> points;  // 0 to 1 across the KSQuad
};

class TrimRegion {
public:
    // Never fails: what is wrong with the loops is in the report, and they are left out where one is refused.
    TrimRegion(const std::vector<TrimLoop>& loops, const NurbsSurface& surface);

    // Whether there is anything to ask: else all is inside.
    [[nodiscard]] bool isTrimmed() const { return trimmed_; }
    // What was wrong and what was done about it; and as sentences, what had loops refused first.
    [[nodiscard]] const std::vector<LoopFinding>& findings() const { return findings_; }
    [[nodiscard]] std::vector<std::string> report() const;
    // Closed chains of pieces, cut off at the domain's border. Along it they run as lines.
    [[nodiscard]] const std::vector<std::vector<RegionPiece>>& chains() const { return chains_; }
    // Even-odd: whether the corner at both domain starts is inside, as far as no loop goes around it.
    [[nodiscard]] bool startsInside() const { return startsInside_; }

    [[nodiscard]] int countU() const { return static_cast<int>(lines_.places[0].size()) - 1; }
    [[nodiscard]] int countV() const { return static_cast<int>(lines_.places[1].size()) - 1; }

    // The reference: looks at all pieces. Parameters outside the domain count as those at its border. On a
    // loop either answer is right.
    [[nodiscard]] bool contains(double u, double v) const;
    // Where the point lies: KSQuad and place in it.
    struct Place {
        int a = 0;
        int b = 0;
        Vec2 t;
    };
    [[nodiscard]] Place placeOf(double u, double v) const;

private:
    void add(const LoopChain& chain);
    void addClamped(const LoopArc& part, std::vector<RegionPiece>& to) const;
    [[nodiscard]] RegionPiece pieceOf(const TrimArc& arc, const LoopArc& part) const;

    CuttingLines lines_;
    bool trimmed_ = false;
    bool startsInside_ = false;
    std::vector<LoopFinding> findings_;
    std::vector<std::vector<RegionPiece>> chains_;
};

// Whether a monotone piece's curve runs at u or to the left of it at the height v, which is between its ends.
[[nodiscard]] bool runsLeftOf(const std::vector<TrimPoint>& points, const Vec2& place);

}  // namespace knotspan
