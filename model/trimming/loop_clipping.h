// Loops cut off at a line of u or v: what a part of the surface gets of them.
#pragma once

#include <optional>

#include "model/trimming/loop_reading.h"

namespace knotspan {

// A half of the (u,v) plane.
struct HalfPlane {
    int axis = 0;  // 0: of u
    double at = 0;
    bool below = true;  // keeps what is not above `at`
};

// What is left of the chains there, closed by pieces of the line, which run between chains where those
// enclose the line's other side. Chains that lie in the half are kept to the bit. Lengths below `nothing`
// along the axis count as none.
[[nodiscard]] std::vector<LoopChain> clipped(const std::vector<LoopChain>& chains, const HalfPlane& half,
                                             double nothing);

// Why nothing comes of loops that were refused.
[[nodiscard]] Error cannotFollow(const LoopReading& reading);

// The loops of the part of a surface that lies between `low` and `high` of a direction, both of its
// domain. Nothing where the loops leave nothing of that part. Loops that lie inside it are
// kept to the bit; what is inside is the same everywhere. Fails, with a sentence, where the loops cannot be
// followed.
[[nodiscard]] Result<std::optional<std::vector<TrimLoop>>> loopsBetween(const std::vector<TrimLoop>& loops,
                                                                        const NurbsSurface& surface, int axis,
                                                                        double low, double high);

// The surface's chains as one even-odd set, cut off at its domain: the domain's border is one of them where
// it has to be. Those that reach beyond it by rounding alone do so still.
struct DomainChains {
    std::vector<LoopChain> chains;
    bool startsInside = false;  // only holes, none of which reaches the border
};
[[nodiscard]] DomainChains withinDomain(LoopReading reading, const NurbsSurface& surface, bool needsBorder);

// A chain along the domain's border, further out by `beyond` of its size; anticlockwise.
[[nodiscard]] LoopChain borderChain(const NurbsSurface& surface, double beyond);

// As loops: `startsInside` is told by outer and inner ones.
[[nodiscard]] std::vector<TrimLoop> loopsOf(const DomainChains& set, const std::vector<TrimLoop>& loops);

}  // namespace knotspan
