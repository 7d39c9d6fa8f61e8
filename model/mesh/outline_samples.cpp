#include "model/mesh/outline_samples.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

constexpr double kUnknown = -1;
constexpr size_t kMostSamples = 20'000;  // of a seam

bool crossesAKnotLine(const OutlineArc& arc, size_t after)
{
    const RegionPiece& one = arc.pieces[after];
    const RegionPiece& next = arc.pieces[after + 1];
    return one.a != next.a || one.b != next.b;
}

}  // namespace

OutlineSamples::OutlineSamples(const std::vector<OutlinedFace>& faces, const OutlineWeld& weld, double same,
                               const std::vector<FaceErrors>& errors)
    : faces_(faces),
      weld_(weld),
      same_(same),
      errors_(errors),
      samples_(weld.seams.size()),
      positions_(weld.corners),
      gaps_(faces.size(), 0.0)
{
    // Two seams of one segment each between the same corners would be one edge.
    std::set<std::array<std::uint32_t, 2>> taken;
    for (std::uint32_t seam = 0; seam < weld.seams.size(); ++seam) {
        const auto [start, end] = std::minmax(stretch(seam, 0).start, stretch(seam, 0).end);
        const bool closed = start == end;
        sampleSeam(seam, weld.seams[seam].isPoint            ? 1
                         : closed                            ? 3
                         : taken.insert({start, end}).second ? 1
                                                             : 2);
    }
}

// Where a stretch crosses a knot line of its surface; ordered along the first, completed for all.
std::vector<OutlineSamples::Sample> OutlineSamples::forcedOn(std::uint32_t seam) const
{
    const OutlineSeam& of = weld_.seams[seam];
    const size_t members = of.stretches.size();
    const OutlineStretch& first = stretch(seam, 0);
    const auto blank = [&] { return Sample{kUnknownVertex, std::vector<double>(members, kUnknown)}; };
    std::vector<Sample> samples;
    for (size_t m = 0; m < members; ++m) {
        const OutlineStretch& along = stretch(seam, m);
        const OutlineArc& arc = faces_[along.face].arcs()[along.arc];
        for (double t = std::floor(along.from) + 1; t < along.to; ++t) {
            if (!crossesAKnotLine(arc, static_cast<size_t>(t) - 1))
                continue;
            Sample sample = blank();
            sample.t[m] = t;
            if (m > 0)
                sample.t[0] =
                    face(seam, 0)
                        .nearest(first.arc, first.from, first.to, faces_[along.face].pointOn(along.arc, t))
                        .t;
            samples.push_back(std::move(sample));
        }
    }
    std::sort(samples.begin(), samples.end(),
              [](const Sample& a, const Sample& b) { return a.t[0] < b.t[0]; });
    // Knot lines of several surfaces at one place.
    const double near = 1e-7 * (first.to - first.from);
    std::vector<Sample> merged;
    const auto isFree = [](const Sample& a, const Sample& b) {
        for (size_t m = 1; m < a.t.size(); ++m)
            if (a.t[m] != kUnknown && b.t[m] != kUnknown)
                return false;
        return true;
    };
    for (Sample& sample : samples) {
        if (!merged.empty() && sample.t[0] - merged.back().t[0] <= near && isFree(merged.back(), sample)) {
            Sample& last = merged.back();
            if (sample.t[0] == std::floor(sample.t[0]))
                last.t[0] = sample.t[0];
            for (size_t m = 1; m < members; ++m)
                if (sample.t[m] != kUnknown)
                    last.t[m] = sample.t[m];
            continue;
        }
        merged.push_back(std::move(sample));
    }
    Sample start = blank();
    Sample end = blank();
    for (size_t m = 0; m < members; ++m) {
        const OutlineStretch& along = stretch(seam, m);
        const bool turned = of.reversed[m] != 0;
        start.t[m] = turned ? along.to : along.from;
        end.t[m] = turned ? along.from : along.to;
    }
    merged.insert(merged.begin(), std::move(start));
    merged.push_back(std::move(end));
    if (!of.isPoint)
        dropNextToEnds(seam, merged);
    return merged;
}

// Curves overshoot a knot line by rounding where they end on it, or nearly end at it. Vertices so near to
// each other would be in the way of the edges beside them.
void OutlineSamples::dropNextToEnds(std::uint32_t seam, std::vector<Sample>& samples) const
{
    constexpr double kOfKsquad = 1e-6;
    const auto isNear = [&](const Sample& sample, const Sample& end) {
        const OutlineStretch& first = stretch(seam, 0);
        if (glm::distance(faces_[first.face].pointOn(first.arc, sample.t[0]),
                          faces_[first.face].pointOn(first.arc, end.t[0])) > same_)
            return false;
        for (size_t m = 0; m < sample.t.size(); ++m) {
            if (sample.t[m] == kUnknown)
                continue;
            const OutlineStretch& of = stretch(seam, m);
            const Vec2 away = faces_[of.face].arcs()[of.arc].sizeBetween(sample.t[m], end.t[m]);
            if (std::max(away.x, away.y) > kOfKsquad)
                return false;
        }
        return true;
    };
    const Sample front = samples.front();
    const Sample back = samples.back();
    samples.erase(
        std::remove_if(samples.begin() + 1, samples.end() - 1,
                       [&](const Sample& sample) { return isNear(sample, front) || isNear(sample, back); }),
        samples.end() - 1);
}

// Places that only some members know are found on the others, between those they know.
void OutlineSamples::complete(std::uint32_t seam, std::vector<Sample>& samples) const
{
    for (size_t m = 1; m < weld_.seams[seam].stretches.size(); ++m)
        for (size_t k = 1; k + 1 < samples.size(); ++k) {
            if (samples[k].t[m] != kUnknown)
                continue;
            size_t next = k + 1;
            while (samples[next].t[m] == kUnknown)
                ++next;
            const double share =
                (samples[k].t[0] - samples[k - 1].t[0]) / (samples[next].t[0] - samples[k - 1].t[0]);
            const double from = samples[k - 1].t[m];
            const double to = samples[next].t[m];
            const OutlineStretch& first = stretch(seam, 0);
            const auto found =
                face(seam, m).nearestFrom(stretch(seam, m).arc, std::min(from, to), std::max(from, to),
                                          from + std::clamp(share, 0.0, 1.0) * (to - from),
                                          face(seam, 0).pointOn(first.arc, samples[k].t[0]));
            samples[k].t[m] = found.t;
        }
}

OutlineSamples::Sample OutlineSamples::between(std::uint32_t seam, const Sample& a, const Sample& b,
                                               double t) const
{
    std::vector<Sample> three{a, {kUnknownVertex, std::vector<double>(a.t.size(), kUnknown)}, b};
    three[1].t[0] = t;
    complete(seam, three);
    return three[1];
}

void OutlineSamples::place(std::uint32_t seam, Sample& sample)
{
    if (weld_.seams[seam].isPoint) {
        sample.vertex = stretch(seam, 0).start;
    } else if (sample.vertex == kUnknownVertex) {
        sample.vertex = static_cast<std::uint32_t>(positions_.size());
        Box all;
        for (size_t m = 0; m < sample.t.size(); ++m)
            all.add(face(seam, m).pointOn(stretch(seam, m).arc, sample.t[m]));
        positions_.push_back(all.centre());
    }
    for (size_t m = 0; m < sample.t.size(); ++m) {
        const OutlineStretch& of = stretch(seam, m);
        const Vec3 own = faces_[of.face].pointOn(of.arc, sample.t[m]);
        gaps_[of.face] = std::max(gaps_[of.face], glm::distance(own, positions_[sample.vertex]));
    }
}

bool OutlineSamples::isFine(std::uint32_t seam, size_t segment) const
{
    const Sample& a = samples_[seam][segment];
    const Sample& b = samples_[seam][segment + 1];
    for (size_t m = 0; m < a.t.size(); ++m) {
        const OutlineStretch& of = stretch(seam, m);
        const auto [from, to] = std::minmax(a.t[m], b.t[m]);
        if (from < to && !errors_[of.face].isFine(faces_[of.face].arcs()[of.arc], from, to))
            return false;
    }
    return true;
}

bool OutlineSamples::split(std::uint32_t seam, size_t segment)
{
    std::vector<Sample>& samples = samples_[seam];
    const Sample& a = samples[segment];
    const Sample& b = samples[segment + 1];
    if (samples.size() >= kMostSamples ||
        b.t[0] - a.t[0] < 1e-9 * (samples.back().t[0] - samples.front().t[0]))
        return false;
    const auto t = middleOf(seam, a.t[0], b.t[0]);
    if (!t)
        return false;
    Sample sample = between(seam, a, b, *t);
    for (size_t m = 0; m < sample.t.size(); ++m)
        if (sample.t[m] == a.t[m] || sample.t[m] == b.t[m])
            return false;
    place(seam, sample);
    samples.insert(samples.begin() + static_cast<std::ptrdiff_t>(segment) + 1, std::move(sample));
    return true;
}

// In space: pieces of one curve may differ in length by any factor. Nothing where there is no room.
std::optional<double> OutlineSamples::middleOf(std::uint32_t seam, double from, double to) const
{
    constexpr int kSteps = 40;
    constexpr double kUneven = 8;
    double t = (from + to) / 2;
    if (weld_.seams[seam].isPoint)
        return t;
    const auto pointAt = [&](double at) { return face(seam, 0).pointOn(stretch(seam, 0).arc, at); };
    const Vec3 start = pointAt(from);
    const Vec3 end = pointAt(to);
    for (int k = 0; k < kSteps; ++k, t = (from + to) / 2) {
        const Vec3 point = pointAt(t);
        const double before = glm::distance(start, point);
        const double after = glm::distance(point, end);
        if (before * kUneven < after)
            from = t;
        else if (after * kUneven < before)
            to = t;
        else
            return std::min(before, after) > same_ ? std::optional(t) : std::nullopt;
    }
    return std::nullopt;
}

void OutlineSamples::sampleSeam(std::uint32_t seam, size_t fewest)
{
    std::vector<Sample>& samples = samples_[seam];
    samples = forcedOn(seam);
    complete(seam, samples);
    const OutlineStretch& first = stretch(seam, 0);
    samples.front().vertex = first.start;
    samples.back().vertex = first.end;
    for (Sample& sample : samples)
        place(seam, sample);
    for (size_t k = 0; k + 1 < samples.size();)
        if (isFine(seam, k) || !split(seam, k))
            ++k;
    while (samples.size() <= fewest) {
        size_t widest = 0;
        for (size_t k = 1; k + 1 < samples.size(); ++k)
            if (samples[k + 1].t[0] - samples[k].t[0] > samples[widest + 1].t[0] - samples[widest].t[0])
                widest = k;
        if (!split(seam, widest))
            break;
    }
}

}  // namespace knotspan
