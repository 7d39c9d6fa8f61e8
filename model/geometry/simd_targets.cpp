#include "model/geometry/simd_targets.h"

#include <cstdint>

#include <hwy/highway.h>

namespace knotspan {

namespace {

// One bit each, the best one lowest.
std::vector<std::int64_t> targetBits()
{
    hwy::SetSupportedTargetsForTest(0);
    std::vector<std::int64_t> bits;
    for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1)
        bits.push_back(rest & -rest);
    return bits;
}

std::int64_t bitInUse = 0;  // 0: not chosen by hand

}  // namespace

std::vector<std::string> simdTargets()
{
    std::vector<std::string> names;
    for (const std::int64_t bit : targetBits())
        names.emplace_back(hwy::TargetName(bit));
    return names;
}

std::string simdTargetInUse()
{
    return hwy::TargetName(bitInUse != 0 ? bitInUse : targetBits().front());
}

void useSimdTarget(const std::string& name)
{
    bitInUse = 0;
    for (const std::int64_t bit : targetBits())
        if (hwy::TargetName(bit) == name)
            bitInUse = bit;
    hwy::GetChosenTarget().Update(bitInUse != 0 ? bitInUse : hwy::SupportedTargets());
}

}  // namespace knotspan
