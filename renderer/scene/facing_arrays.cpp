#include "renderer/scene/facing_arrays.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

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
                                                    FacingStrength strength, const ResidentChanges* log)
{
    const auto logged = log != nullptr ? log->since(seen_) : std::nullopt;
    bool all = strength != strength_ || origins != origins_ || held_.size() != residents.size();
    for (size_t k = 0; !all && !logged && k < residents.size(); ++k)
        all = !isSameShape(*held_[k].object, *residents[k].object);
    if (all) {
        clear();
        held_.resize(residents.size());
    }
    seen_ = log != nullptr ? log->now() : 0;
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
    std::vector<Task> work = tasks(residents, all ? std::nullopt : logged);
    tbb::parallel_for(size_t{0}, work.size(), [&](size_t k) {
        Task& task = work[k];
        const Resident& resident = residents[task.resident];
        plan(resident, held_[task.resident], task);
        if (!task.make.empty())
            make(resident, origins, task.make);
        for (const std::uint32_t number : task.forget)
            boxes_[resident.firstKsquad + number] = neverFacingAway();
    });
    moving_.clear();
    std::vector<Run> runs;
    for (const Task& task : work) {
        if (held_[task.resident].moved)
            moving_.push_back(task.resident);
        for (const std::uint32_t number : task.changed) {
            const std::uint32_t ksquad = residents[task.resident].firstKsquad + number;
            if (!runs.empty() && runs.back().first + runs.back().count == ksquad)
                ++runs.back().count;
            else
                runs.push_back({ksquad, 1});
        }
    }
    return runs;
}

// Of the residents that may be others, and those that moved last.
std::vector<FacingArrays::Task>
FacingArrays::tasks(const std::vector<Resident>& residents,
                    std::optional<std::span<const std::uint32_t>> logged) const
{
    std::set<std::uint32_t> looked(moving_.begin(), moving_.end());
    if (logged)
        for (const std::uint32_t k : *logged)
            looked.insert(k);
    std::vector<Task> all;
    const auto add = [&all](std::uint32_t resident) { all.push_back({resident, {}, {}, {}}); };
    if (logged)
        for (const std::uint32_t resident : looked)
            add(resident);
    else
        for (std::uint32_t resident = 0; resident < residents.size(); ++resident)
            add(resident);
    return all;
}

// What of it is made now, and what is only forgotten: the rest is left to when it rests.
void FacingArrays::plan(const Resident& resident, Held& held, Task& task) const
{
    const bool canWait = held.moved && strength_ == FacingStrength::box && isSame(held.frame, resident.frame);
    std::vector<std::uint32_t> stale = staleOf(resident, held);
    std::vector<std::uint32_t> either;
    std::set_union(stale.begin(), stale.end(), held.later.begin(), held.later.end(),
                   std::back_inserter(either));
    if (canWait && !stale.empty()) {
        std::set_difference(stale.begin(), stale.end(), held.later.begin(), held.later.end(),
                            std::back_inserter(task.forget));
        task.changed = task.forget;
        held.later = std::move(either);
    } else {
        task.make = task.changed = std::move(either);
        held.later.clear();
    }
    held.moved = held.object != nullptr && !stale.empty();
    held.object = resident.object;
    held.frame = resident.frame;
}

std::vector<std::uint32_t> FacingArrays::staleOf(const Resident& resident, const Held& held)
{
    std::vector<std::uint32_t> numbers;
    if (held.object == nullptr || !isSame(held.frame, resident.frame)) {
        numbers.resize(ksquadsOf(resident));
        std::iota(numbers.begin(), numbers.end(), 0U);
    } else if (held.object != resident.object) {
        numbers = touched(held.object->surface, resident.object->surface);
    }
    return numbers;
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
