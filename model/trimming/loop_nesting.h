// How closed loops lie in each other: what is there twice, and holes that lie in no outline.
#pragma once

#include "model/trimming/loop_reading.h"

namespace knotspan {

class LoopNesting {
public:
    void add(const LoopChain& chain, std::uint32_t loop, bool outer);
    // Loops that are there twice, the second of each pair; holes around an outline, and others outside of
    // all. Nothing is said of holes where there is no outline.
    [[nodiscard]] std::vector<LoopFinding> findings() const;

private:
    struct Member {
        LoopChain chain;
        std::uint32_t loop = 0;
        bool outer = true;
        double area = 0;  // without its sign
        Vec2 low{};
        Vec2 high{};
        Vec2 middle{};
    };
    [[nodiscard]] static bool areOne(const Member& a, const Member& b);

    std::vector<Member> members_;
};

// Roughly what the chain encloses by even-odd, from samples; nil for one that runs back on itself, not for a
// figure eight.
[[nodiscard]] double evenOddArea(const LoopChain& chain);

}  // namespace knotspan
