// Chains of arcs (loop_reading.h) turned round, asked for what they enclose, and made into trim loops again.
#pragma once

#include "model/trimming/loop_reading.h"

namespace knotspan {

[[nodiscard]] LoopArc lineArc(const Vec2& from, const Vec2& to);
[[nodiscard]] LoopArc reversed(LoopArc part);
[[nodiscard]] LoopChain reversed(LoopChain chain);

// Above zero: anticlockwise. From a few samples of each arc, so only near to it.
[[nodiscard]] double signedArea(const LoopChain& chain);

// Even-odd over the whole plane, of any number of closed chains.
class ChainParity {
public:
    explicit ChainParity(const std::vector<LoopChain>& chains);
    // On a chain either answer is right.
    [[nodiscard]] bool contains(const Vec2& place) const;

private:
    std::vector<TrimArc> arcs_;  // monotone
};

// The chain as a loop: arcs of one curve that follow each other become one curve again, and a curve that is
// there as a whole stays what it is in `loops`, which is what the chain was read from.
[[nodiscard]] TrimLoop loopOf(const LoopChain& chain, const std::vector<TrimLoop>& loops, bool outer);

// Lines along u or v that follow each other on one line become one; what runs back on itself goes.
void straightenLines(LoopChain& chain);

}  // namespace knotspan
