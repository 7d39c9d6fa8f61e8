// The inner loops of grid evaluation, compiled once for each instruction set and chosen while running.
//
// Lanes stand for parameters v; a group of them fills 64 bytes on every machine, so that what is prepared for
// the kernels does not depend on the instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

namespace knotspan::kernels {

constexpr int kGroupBytes = 64;
template <class Real>
constexpr int kGroupLanes = kGroupBytes / static_cast<int>(sizeof(Real));

constexpr int kMaxFields = 6;

// A net to contract: DifferenceNet without its owner.
template <class Real>
struct Net {
    const Real* numbers = nullptr;
    int countU = 0;
    int countV = 0;
    int orderU = 0;
    int orderV = 0;
};

// The basis functions along v of one group of lanes: lane l of weights[b][k * kGroupLanes + l] is what
// control point first + k of a net of order b counts there, 0 where it is none of the lane's.
template <class Real>
struct LaneGroup {
    int first = 0;
    int terms[3] = {};  // for order 0, 1, 2
    const Real* weights[3] = {};
    const Real* shortest = nullptr;  // of each lane: see Block::unsure
};

// A row's basis functions along u: weights[a][k] for control point first + k of a net of order a.
template <class Real>
struct RowBasis {
    int first = 0;
    Real weights[3][16] = {};
    Real shortest = 0;  // see Block::unsure
};

template <class Real>
struct Block {
    const Net<Real>* nets = nullptr;  // 1, 3 or 6
    int netCount = 1;
    int components = 3;
    int degreeU = 1;

    const LaneGroup<Real>* groups = nullptr;
    int groupCount = 0;
    const RowBasis<Real>* rows = nullptr;
    int rowCount = 0;

    Real* scratch = nullptr;  // scratchSize() numbers, aligned to kGroupBytes

    // planes[3 * field + c]: where the block's first sample of the plane goes; null where it is not asked
    // for. Rows are `stride` apart. Fields: position, du, dv, duu, duv, dvv, normal.
    Real* planes[21] = {};
    size_t stride = 0;
    // Writes samples to memory without fetching what was there first: twice as fast where they outgrow the
    // cache.
    bool pastTheCache = false;

    // Normals: a tangent S_u shorter than the row's `shortest` over the weight, or S_v than the lane's, may
    // be nothing but rounding. Bit l of unsure[row * groupCount + g] says that the normal of lane l is to be
    // found in another way.
    std::uint32_t* unsure = nullptr;
};

template <class Real>
[[nodiscard]] constexpr size_t scratchSize(int degreeU, int netCount, int components, int groupCount)
{
    return static_cast<size_t>(degreeU + 1) * static_cast<size_t>(netCount * components * groupCount) *
           static_cast<size_t>(kGroupLanes<Real>);
}

void evaluate(const Block<float>& block);
void evaluate(const Block<double>& block);

// Points anywhere. Each has its own basis functions: weights[order][k], 0 behind the last one.
template <class Real>
struct ScatteredPoint {
    int firstU = 0;
    int firstV = 0;
    Real u[3][16] = {};
    Real v[3][16] = {};
    Real shortestU = 0;  // see Block::unsure
    Real shortestV = 0;
};

// Evaluates points[0 .. count - 1], count <= kGroupLanes, as a block of one row and one group of lanes: its
// groups, rows and scratch are not read, and `termsU` replaces the degree: for net n that many of
// u[nets[n].orderU] count.
template <class Real>
struct ScatteredPoints {
    const ScatteredPoint<Real>* points = nullptr;
    int count = 0;
    int termsU[kMaxFields] = {};
    int mostTermsV = 0;
};
void evaluate(const Block<float>& block, const ScatteredPoints<float>& points);
void evaluate(const Block<double>& block, const ScatteredPoints<double>& points);

}  // namespace knotspan::kernels
