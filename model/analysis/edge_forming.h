// Joins border sides that run together in pairs into edges, each with one parameter for all its sides.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace knotspan {

// Where the end of some side lies.
struct EdgeCut {
    double at = 0;             // the edge's parameter
    std::uint32_t corner = 0;  // that owns the group which lies there

    [[nodiscard]] bool operator==(const EdgeCut&) const = default;
};

// A side along an edge: the edge's parameter at the side's own start and end, each of them a cut's, to the
// bit.
struct EdgeMember {
    std::uint32_t side = 0;
    double start = 0;
    double end = 0;  // below start: it runs the other way

    // Whether it lies along all between two parameters, or has one strictly between its ends.
    [[nodiscard]] bool covers(double low, double high) const
    {
        return std::min(start, end) <= low && high <= std::max(start, end);
    }
    [[nodiscard]] bool isWithin(double at) const
    {
        return std::min(start, end) < at && at < std::max(start, end);
    }
    [[nodiscard]] bool operator==(const EdgeMember&) const = default;
};

// Two or more border sides along one curve, each along the whole or a part of it. Of those that overlap, the
// edge's parameter is an affine function of each one's own.
struct CoincidentEdge {
    std::vector<EdgeMember> members;  // by side
    std::vector<EdgeCut> cuts;        // by parameter

    [[nodiscard]] bool operator==(const CoincidentEdge&) const = default;
};

// The least part of a side, in its parameter, that others may share or that may be left between cuts.
constexpr double kShortestPart = 1.0 / 1024;

// Of a side and another: the parts of both that are one curve.
struct SideOverlap {
    std::uint32_t other = 0;
    double start = 0;  // on the side itself, start < end
    double end = 0;
    double otherStart = 0;
    double otherEnd = 0;
};

struct SideOverlaps {
    std::array<std::uint32_t, 2> ends{};  // the corners that own the groups at start and end
    std::vector<SideOverlap> overlaps;    // by other side
};

// Of sides, increasing, that overlap nobody but each other; `overlaps` is indexed by side. A side that would
// cut another, or be cut, into parts below kShortestPart stays out.
[[nodiscard]] std::vector<CoincidentEdge> formEdges(const std::vector<std::uint32_t>& sides,
                                                    const std::vector<SideOverlaps>& overlaps);

}  // namespace knotspan
