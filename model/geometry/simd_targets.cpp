#include "model/geometry/simd_targets.h"

#include <algorithm>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/geometry/simd_targets.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace knotspan::HWY_NAMESPACE {
namespace {

// Which of the kernels' versions runs is told by the one that does.
std::int64_t RunningTarget()
{
    return HWY_TARGET;
}

}  // namespace
}  // namespace knotspan::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace knotspan {

namespace {

HWY_EXPORT(RunningTarget);

// One bit each, the best one lowest.
const std::vector<std::int64_t>& targetBits()
{
    static const std::vector<std::int64_t> bits = [] {
        std::vector<std::int64_t> found;
        for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1)
            found.push_back(rest & -rest);
        return found;
    }();
    return bits;
}

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
    return hwy::TargetName(HWY_DYNAMIC_DISPATCH(RunningTarget)());
}

void useSimdTarget(const std::string& name)
{
    const auto& bits = targetBits();
    const auto found = std::find_if(bits.begin(), bits.end(),
                                    [&](std::int64_t bit) { return hwy::TargetName(bit) == name; });
    hwy::GetChosenTarget().Update(found == bits.end() ? hwy::SupportedTargets() : *found);
}

}  // namespace knotspan
#endif
