// Where chains of two sets cross.
#pragma once

#include "model/trimming/loop_reading.h"

namespace knotspan {

// A place on a chain: t of 0 to 1 of one of its arcs.
struct ChainPlace {
    size_t chain = 0;
    size_t arc = 0;
    double t = 0;
};
struct Meeting {
    ChainPlace a;
    ChainPlace b;
    Vec2 at;
};

// Each place once; `size` is the domain's. Fails, with a sentence, where chains run along each other.
[[nodiscard]] Result<std::vector<Meeting>> meetingsOf(const std::vector<LoopChain>& a,
                                                      const std::vector<LoopChain>& b, const Vec2& size);

}  // namespace knotspan
