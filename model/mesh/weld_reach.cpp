#include "model/mesh/weld_reach.h"

#include <algorithm>

namespace knotspan {

WeldReach weldReach(const std::vector<OutlinedFace>& faces, double deviation)
{
    constexpr double kOfDeviation = 0.5;
    // Of the size.
    constexpr double kSame = 1e-7;
    constexpr double kLeast = 1e-5;
    constexpr double kMost = 1e-3;
    constexpr double kEdges = 1e-4;
    Box box;
    for (const OutlinedFace& face : faces)
        for (std::uint32_t arc = 0; arc < face.arcs().size(); ++arc)
            for (const auto& sample : face.samples(arc))
                box.add(sample.point);
    const double size = box.diagonal();
    const double tiny = std::clamp(kOfDeviation * deviation, kLeast * size, kMost * size);
    return {kSame * size, tiny, std::max(tiny, kEdges * size)};
}

std::optional<RunningTogether> runningTogether(const std::vector<OutlinedFace>& faces,
                                               const OutlineStretch& one, const OutlineStretch& other,
                                               double most)
{
    std::array<double, 3> places{};
    double gap = 0;
    for (size_t k = 0; k < 3; ++k) {
        const double t = one.from + (one.to - one.from) * static_cast<double>(k + 1) / 4;
        const auto found =
            faces[other.face].nearest(other.arc, other.from, other.to, faces[one.face].pointOn(one.arc, t));
        gap = std::max(gap, found.distance);
        if (gap > most)
            return std::nullopt;
        places[k] = found.t;
    }
    const auto back = faces[one.face].nearest(
        one.arc, one.from, one.to, faces[other.face].pointOn(other.arc, (other.from + other.to) / 2));
    gap = std::max(gap, back.distance);
    if (gap > most)
        return std::nullopt;
    return RunningTogether{gap, places[2] < places[0]};
}

}  // namespace knotspan
