#include "renderer/scene/facing_arrays.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "model/core/check.h"

namespace knotspan {

namespace {

std::uint32_t wordsEach(const NurbsSurface& surface)
{
    return gpu::facingWordCount(static_cast<gpu::uint>(surface.degreeU()),
                                static_cast<gpu::uint>(surface.degreeV()));
}

std::uint32_t ksquadsOf(const Resident& resident)
{
    return static_cast<std::uint32_t>(ksQuadCount(resident.object->surface));
}

// As the device has it: of floats.
NurbsSurface rounded(const Resident& resident)
{
    const NurbsSurface& surface = resident.object->surface;
    std::vector<ControlPoint> points;
    for (const glm::vec4& point : packPoints<float>(resident.frame, surface.controlPoints()))
        points.push_back({Vec3(point) / double{point.w}, double{point.w}});
    auto made = NurbsSurface::create(surface.knotsU(), surface.knotsV(), std::move(points));
    check(made.has_value(), "a surface stays valid in float");
    return std::move(*made);
}

bool isSame(const PointFrame& a, const PointFrame& b)
{
    return a.origin == b.origin && a.weight == b.weight;
}

// Numbers, within the surface, of the KSQuads that control points with other values shape.
std::vector<std::uint32_t> touched(const NurbsSurface& before, const NurbsSurface& after)
{
    const auto& a = before.controlPoints();
    const auto& b = after.controlPoints();
    const auto quads = ksQuads(after);
    std::vector<std::uint32_t> numbers;
    for (size_t k = 0; k < quads.size(); ++k) {
        bool differs = false;
        for (int i = quads[k].spanU - after.degreeU(); i <= quads[k].spanU && !differs; ++i) {
            const auto row = static_cast<size_t>(i) * static_cast<size_t>(after.countV());
            const auto first =
                static_cast<std::ptrdiff_t>(row + static_cast<size_t>(quads[k].spanV - after.degreeV()));
            differs =
                !std::equal(a.begin() + first, a.begin() + first + after.degreeV() + 1, b.begin() + first);
        }
        if (differs)
            numbers.push_back(static_cast<std::uint32_t>(k));
    }
    return numbers;
}

}  // namespace

std::vector<FacingArrays::Run> FacingArrays::update(const std::vector<Resident>& residents, Origins origins,
                                                    FacingStrength strength)
{
    bool all = strength != strength_ || origins != origins_ || held_.size() != residents.size();
    for (size_t k = 0; !all && k < residents.size(); ++k)
        all = !isSameShape(held_[k].object->surface, residents[k].object->surface);
    if (all) {
        clear();
        held_.resize(residents.size());
    }
    strength_ = strength;
    origins_ = origins;
    if (strength == FacingStrength::none || residents.empty())
        return {};
    if (all) {
        const Resident& last = residents.back();
        boxes_.resize(last.firstKsquad + ksquadsOf(last));
        if (strength == FacingStrength::rays)
            words_.resize(last.firstFacingWord + ksquadsOf(last) * wordsEach(last.object->surface));
    }
    std::vector<std::vector<std::uint32_t>> numbers(residents.size());
    tbb::parallel_for(size_t{0}, residents.size(), [&](size_t k) {
        const Resident& resident = residents[k];
        Held& held = held_[k];
        if (held.object == nullptr || !isSame(held.frame, resident.frame)) {
            numbers[k].resize(ksquadsOf(resident));
            for (std::uint32_t number = 0; number < numbers[k].size(); ++number)
                numbers[k][number] = number;
        } else if (held.object != resident.object) {
            numbers[k] = touched(held.object->surface, resident.object->surface);
        }
        if (!numbers[k].empty())
            make(resident, origins, numbers[k]);
        held = {resident.object, resident.frame};
    });
    std::vector<Run> runs;
    for (size_t k = 0; k < residents.size(); ++k)
        for (const std::uint32_t number : numbers[k]) {
            const std::uint32_t ksquad = residents[k].firstKsquad + number;
            if (!runs.empty() && runs.back().first + runs.back().count == ksquad)
                ++runs.back().count;
            else
                runs.push_back({ksquad, 1});
        }
    return runs;
}

void FacingArrays::make(const Resident& resident, Origins origins, const std::vector<std::uint32_t>& numbers)
{
    const NurbsSurface surface = rounded(resident);
    const BezierConversion conversion(surface);
    const auto quads = ksQuads(surface);
    const std::uint32_t each = wordsEach(surface);
    tbb::parallel_for(size_t{0}, numbers.size(), [&](size_t index) {
        const std::uint32_t number = numbers[index];
        const KsQuad& quad = quads[number];
        const BezierNet net = conversion.net(quad);
        const int p = surface.degreeU();
        const int q = surface.degreeV();
        Vec3 origin = surface.controlPoint(quad.spanU - p + p / 2, quad.spanV - q + q / 2).position;
        if (origins == Origins::bezierNets) {
            const glm::vec4 middle(net.at(p / 2, q / 2));
            origin = Vec3(middle) / double{middle.w};
        }
        std::span<std::uint32_t> rays;
        if (strength_ == FacingStrength::rays)
            rays = std::span(words_).subspan(resident.firstFacingWord + number * each, each);
        boxes_[resident.firstKsquad + number] = makeFacingForms(net, origin, rays);
    });
}

FacingArrays::Run FacingArrays::wordsOf(const std::vector<Resident>& residents, const Run& ksquads) const
{
    const auto start = [&](std::uint32_t ksquad) {
        const auto next = std::upper_bound(
            residents.begin(), residents.end(), ksquad,
            [](std::uint32_t k, const Resident& resident) { return k < resident.firstKsquad; });
        const Resident& resident = *(next - 1);
        return resident.firstFacingWord +
               (ksquad - resident.firstKsquad) * wordsEach(resident.object->surface);
    };
    const std::uint32_t first = start(ksquads.first);
    return {first, start(ksquads.first + ksquads.count) - first};
}

}  // namespace knotspan
