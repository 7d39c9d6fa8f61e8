#include "model/mesh/outline_weld.h"

#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "model/friends/box_tree.h"
#include "model/mesh/outline_corners.h"
#include "model/mesh/weld_reach.h"

namespace knotspan {

namespace {

class Welding {
public:
    Welding(const std::vector<OutlinedFace>& faces, const WeldReach& reach)
        : faces_(faces),
          reach_(reach),
          gaps_(faces.size(), 0.0)
    {
        for (double step = reach.same; step > 0 && step < reach.tiny; step *= 10)
            tolerances_.push_back(step);
        tolerances_.push_back(reach.tiny);
    }

    OutlineWeld make()
    {
        addArcs();
        for (pass_ = 0; pass_ < tolerances_.size(); ++pass_) {
            joinCorners();
            splitStretches();
            findPoints();
            joinStretches();
        }
        --pass_;
        if (collapseShort())
            joinStretches();
        while (tolerance() < reach_.edges) {
            tolerances_.push_back(std::min(10 * tolerance(), reach_.edges));
            ++pass_;
            joinCorners();
            splitStretches();
            joinStretches();
        }
        return taken();
    }

private:
    [[nodiscard]] double tolerance() const { return tolerances_[pass_]; }
    [[nodiscard]] bool isAlone(std::uint32_t stretch) const { return seamOf_[stretch] == kNone; }

    void addArcs()
    {
        for (std::uint32_t f = 0; f < faces_.size(); ++f)
            for (std::uint32_t arc = 0; arc < faces_[f].arcs().size(); ++arc) {
                const auto& samples = faces_[f].samples(arc);
                const std::uint32_t start = corners_.add(samples.front().point, f);
                const std::uint32_t end = corners_.add(samples.back().point, f);
                addStretch({f, arc, 0, faces_[f].arcs()[arc].end(), start, end});
                if (faces_[f].arcs()[arc].isBridge && extent(stretches_.back()) <= reach_.tiny)
                    corners_.join(start, end);
            }
    }
    void addStretch(const OutlineStretch& stretch)
    {
        stretches_.push_back(stretch);
        seamOf_.push_back(kNone);
    }

    // The largest distance from its start.
    [[nodiscard]] double extent(const OutlineStretch& stretch) const
    {
        const Vec3 from = corners_.at(stretch.start);
        double largest = glm::distance(from, corners_.at(stretch.end));
        for (const auto& sample : faces_[stretch.face].samples(stretch.arc))
            if (sample.t >= stretch.from && sample.t <= stretch.to)
                largest = std::max(largest, glm::distance(from, sample.point));
        return largest;
    }

    // Those at the ends of what is still alone.
    [[nodiscard]] std::vector<std::uint32_t> openCorners() const
    {
        std::vector<char> is(corners_.count(), 0);
        std::vector<std::uint32_t> open;
        for (std::uint32_t k = 0; k < stretches_.size(); ++k)
            for (const std::uint32_t end : {stretches_[k].start, stretches_[k].end})
                if (const std::uint32_t corner = corners_.find(end); isAlone(k) && is[corner] == 0) {
                    is[corner] = 1;
                    open.push_back(corner);
                }
        return open;
    }

    static Box around(const Vec3& point, double reach) { return {point - Vec3(reach), point + Vec3(reach)}; }

    void joinCorners()
    {
        const std::vector<std::uint32_t> open = openCorners();
        std::vector<Box> boxes;
        for (const std::uint32_t corner : open)
            boxes.push_back(around(corners_.at(corner), tolerance()));
        const BoxTree tree(boxes);
        struct Pair {
            double distance;
            std::uint32_t a, b;
        };
        std::vector<Pair> pairs;
        for (const std::uint32_t a : open)
            tree.touching(around(corners_.at(a), 0), [&](std::uint32_t k) {
                if (const double distance = glm::distance(corners_.at(a), corners_.at(open[k]));
                    a < open[k] && distance <= tolerance())
                    pairs.push_back({distance, a, open[k]});
            });
        std::sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) {
            return std::tie(x.distance, x.a, x.b) < std::tie(y.distance, y.a, y.b);
        });
        for (const Pair& pair : pairs)
            if (corners_.find(pair.a) != corners_.find(pair.b) && mayJoin(pair.a, pair.b))
                corners_.join(pair.a, pair.b);
    }

    // Beyond rounding no chain of corners becomes one that is longer than a few steps.
    [[nodiscard]] bool mayJoin(std::uint32_t a, std::uint32_t b) const
    {
        constexpr double kChain = 2;
        return pass_ == 0 ||
               (!corners_.shareAFace(a, b) && corners_.reachOfBoth(a, b) <= kChain * tolerance());
    }

    // Where the end of another one lies within a stretch.
    void splitStretches()
    {
        std::vector<std::uint32_t> alone;
        std::vector<Box> boxes;
        for (std::uint32_t k = 0; k < stretches_.size(); ++k) {
            if (!isAlone(k))
                continue;
            const OutlineStretch& stretch = stretches_[k];
            alone.push_back(k);
            boxes.push_back(around(corners_.at(stretch.start), 2 * tolerance()));
            boxes.back().add(around(corners_.at(stretch.end), 2 * tolerance()));
            const auto& samples = faces_[stretch.face].samples(stretch.arc);
            for (size_t i = 0; i < samples.size(); ++i) {
                if (samples[i].t < stretch.from || samples[i].t > stretch.to)
                    continue;
                const double step = i > 0 ? glm::distance(samples[i].point, samples[i - 1].point) : 0;
                boxes.back().add(around(samples[i].point, 0.2 * step + 2 * tolerance()));
            }
        }
        const BoxTree tree(std::move(boxes));
        std::map<std::uint32_t, std::vector<std::pair<double, std::uint32_t>>> cuts;
        for (const std::uint32_t corner : openCorners())
            tree.touching(around(corners_.at(corner), 0), [&](std::uint32_t k) {
                if (const auto at = placeWithin(stretches_[alone[k]], corner))
                    cuts[alone[k]].emplace_back(*at, corner);
            });
        for (auto& [stretch, places] : cuts)
            split(stretch, places);
    }

    [[nodiscard]] std::optional<double> placeWithin(const OutlineStretch& stretch, std::uint32_t corner) const
    {
        if (corners_.find(stretch.start) == corner || corners_.find(stretch.end) == corner ||
            (pass_ > 0 && corners_.isOf(corner, stretch.face)))
            return std::nullopt;
        const Vec3& at = corners_.at(corner);
        if (std::min(glm::distance(at, corners_.at(stretch.start)),
                     glm::distance(at, corners_.at(stretch.end))) <= tolerance())
            return std::nullopt;
        const auto found = faces_[stretch.face].nearest(stretch.arc, stretch.from, stretch.to, at);
        if (found.distance > tolerance() || found.t <= stretch.from || found.t >= stretch.to)
            return std::nullopt;
        return found.t;
    }

    void split(std::uint32_t number, std::vector<std::pair<double, std::uint32_t>>& places)
    {
        std::sort(places.begin(), places.end());
        const std::uint32_t last = stretches_[number].end;
        const double to = stretches_[number].to;
        std::uint32_t at = number;
        for (const auto& [t, corner] : places) {
            if (t <= stretches_[at].from || corners_.find(corner) == corners_.find(stretches_[at].start))
                continue;
            stretches_[at].to = t;
            stretches_[at].end = corner;
            corners_.addFace(corner, stretches_[at].face);
            addStretch({stretches_[at].face, stretches_[at].arc, t, to, corner, last});
            at = static_cast<std::uint32_t>(stretches_.size() - 1);
        }
    }

    void findPoints()
    {
        for (std::uint32_t k = 0; k < stretches_.size(); ++k)
            if (isAlone(k) && corners_.find(stretches_[k].start) == corners_.find(stretches_[k].end) &&
                extent(stretches_[k]) <= tolerance())
                addSeam({{k}, {0}, true});
    }

    void addSeam(const OutlineSeam& seam)
    {
        for (const std::uint32_t stretch : seam.stretches)
            seamOf_[stretch] = static_cast<std::uint32_t>(seams_.size());
        seams_.push_back(seam);
    }

    struct Meeting {
        double gap;
        std::uint32_t a, b;
        bool reversed;
    };

    void joinStretches()
    {
        std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> byCorners;
        for (std::uint32_t k = 0; k < stretches_.size(); ++k)
            if (isAlone(k)) {
                const std::uint32_t start = corners_.find(stretches_[k].start);
                const std::uint32_t end = corners_.find(stretches_[k].end);
                byCorners[{std::min(start, end), std::max(start, end)}].push_back(k);
            }
        std::vector<Meeting> meetings;
        for (const auto& [corners, among] : byCorners)
            for (size_t i = 0; i < among.size(); ++i)
                for (size_t j = i + 1; j < among.size(); ++j)
                    if (const auto meeting = meetingOf(among[i], among[j]))
                        meetings.push_back(*meeting);
        std::sort(meetings.begin(), meetings.end(), [](const Meeting& x, const Meeting& y) {
            return std::tie(x.gap, x.a, x.b) < std::tie(y.gap, y.a, y.b);
        });
        for (const Meeting& meeting : meetings)
            join(meeting);
    }

    // At first as many as there are; what comes later joins what is alone.
    void join(const Meeting& meeting)
    {
        const bool aloneA = isAlone(meeting.a);
        const bool aloneB = isAlone(meeting.b);
        if (aloneA && aloneB) {
            addSeam({{meeting.a, meeting.b}, {0, meeting.reversed ? char{1} : char{0}}, false});
        } else if (pass_ == 0 && aloneA != aloneB) {
            const std::uint32_t placed = aloneA ? meeting.b : meeting.a;
            const std::uint32_t added = aloneA ? meeting.a : meeting.b;
            OutlineSeam& seam = seams_[seamOf_[placed]];
            const auto at = std::find(seam.stretches.begin(), seam.stretches.end(), placed);
            const bool turned = seam.reversed[static_cast<size_t>(at - seam.stretches.begin())] != 0;
            seam.stretches.push_back(added);
            seam.reversed.push_back(turned != meeting.reversed ? 1 : 0);
            seamOf_[added] = seamOf_[placed];
        } else {
            return;
        }
        for (const std::uint32_t stretch : {meeting.a, meeting.b}) {
            double& gap = gaps_[stretches_[stretch].face];
            gap = std::max(gap, meeting.gap / 2);
        }
    }

    [[nodiscard]] std::optional<Meeting> meetingOf(std::uint32_t a, std::uint32_t b) const
    {
        constexpr double kAlong = 3;  // curves that stand for an edge are further off between their ends
        const auto way = runningTogether(faces_, stretches_[a], stretches_[b], kAlong * tolerance());
        return way ? std::optional(Meeting{way->gap, a, b, way->reversed}) : std::nullopt;
    }

    // Edges that only one of two faces has, and that are as good as a point.
    bool collapseShort()
    {
        bool any = false;
        for (std::uint32_t k = 0; k < stretches_.size(); ++k)
            if (isAlone(k) && extent(stretches_[k]) <= tolerance()) {
                corners_.join(stretches_[k].start, stretches_[k].end);
                addSeam({{k}, {0}, true});
                any = true;
            }
        return any;
    }

    OutlineWeld taken()
    {
        OutlineWeld weld;
        std::vector<std::uint32_t> number(corners_.count(), kNone);
        std::vector<Box> ends;
        const auto numbered = [&](std::uint32_t corner, const Vec3& end) {
            corner = corners_.find(corner);
            if (number[corner] == kNone) {
                number[corner] = static_cast<std::uint32_t>(ends.size());
                ends.emplace_back();
            }
            ends[number[corner]].add(end);
            return number[corner];
        };
        const auto pointOn = [&](const OutlineStretch& stretch, double t) {
            return faces_[stretch.face].pointOn(stretch.arc, t);
        };
        for (std::uint32_t k = 0; k < stretches_.size(); ++k) {
            if (isAlone(k))
                addSeam({{k}, {0}, false});
            OutlineStretch& stretch = stretches_[k];
            stretch.start = numbered(stretch.start, pointOn(stretch, stretch.from));
            stretch.end = numbered(stretch.end, pointOn(stretch, stretch.to));
        }
        for (const Box& box : ends)
            weld.corners.push_back(box.centre());
        for (const OutlineStretch& stretch : stretches_) {
            double& gap = gaps_[stretch.face];
            gap = std::max({gap, glm::distance(weld.corners[stretch.start], pointOn(stretch, stretch.from)),
                            glm::distance(weld.corners[stretch.end], pointOn(stretch, stretch.to))});
        }
        weld.gaps = std::move(gaps_);
        weld.stretches = std::move(stretches_);
        weld.seams = std::move(seams_);
        return weld;
    }

    static constexpr std::uint32_t kNone = 0xffffffffU;
    const std::vector<OutlinedFace>& faces_;
    WeldReach reach_;
    std::vector<double> gaps_;  // by face
    std::vector<double> tolerances_;
    size_t pass_ = 0;
    OutlineCorners corners_;
    std::vector<OutlineStretch> stretches_;
    std::vector<std::uint32_t> seamOf_;  // by stretch
    std::vector<OutlineSeam> seams_;
};

}  // namespace

OutlineWeld weldOutlines(const std::vector<OutlinedFace>& faces, const WeldReach& reach)
{
    return Welding(faces, reach).make();
}

}  // namespace knotspan
