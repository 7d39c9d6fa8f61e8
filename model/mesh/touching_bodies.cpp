#include "model/mesh/touching_bodies.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "model/core/joined_sets.h"

namespace knotspan {

namespace {

class Bodies {
public:
    Bodies(std::uint32_t faces, const OutlineWeld& weld) : sets_(faces), sizes_(faces, 1), last_(faces)
    {
        std::iota(last_.begin(), last_.end(), 0U);
        for (const OutlineSeam& seam : weld.seams) {
            if (seam.isPoint || seam.stretches.size() < 2)
                continue;
            std::vector<std::uint32_t> of;
            for (const std::uint32_t stretch : seam.stretches)
                of.push_back(weld.stretches[stretch].face);
            if (of.size() == 2)
                join(of[0], of[1]);
            else
                shared_.push_back(std::move(of));
        }
    }

    std::vector<std::uint32_t> numbered()
    {
        while (joinOneThatIsOpen()) {
        }
        joinWhatCannotBeTold();
        return coloured();
    }

private:
    [[nodiscard]] std::uint32_t find(std::uint32_t face) const { return sets_.find(face); }
    void join(std::uint32_t one, std::uint32_t other)
    {
        const auto joined = sets_.join(one, other);
        if (!joined)
            return;
        const auto [a, b] = *joined;
        sizes_[a] += sizes_[b];
        last_[a] = std::max(last_[a], last_[b]);
    }

    // How many faces of each body meet at an edge.
    std::map<std::uint32_t, int> at(const std::vector<std::uint32_t>& edge)
    {
        std::map<std::uint32_t, int> counts;
        for (const std::uint32_t face : edge)
            ++counts[find(face)];
        return counts;
    }

    // A face all of whose edges others share, such as where two boxes touch, belongs to one of those whose
    // edges it closes: to the one with which it closes the most, rather to much of a body than to another
    // such face, rather to what is near it in the file. Where two such faces are alike it does not matter
    // which is whose.
    bool joinOneThatIsOpen()
    {
        struct Pair {
            int closed = 0;
            bool never = false;  // more than two would meet
        };
        std::map<std::array<std::uint32_t, 2>, Pair> pairs;
        for (const auto& edge : shared_) {
            const auto counts = at(edge);
            for (const auto& [a, ofA] : counts)
                for (const auto& [b, ofB] : counts)
                    if (a < b) {
                        Pair& pair = pairs[{a, b}];
                        pair.closed += ofA == 1 && ofB == 1 ? 1 : 0;
                        pair.never = pair.never || ofA + ofB > 2;
                    }
        }
        const auto rank = [&](const std::array<std::uint32_t, 2>& of, const Pair& pair) {
            const auto [small, large] = std::minmax(sizes_[of[0]], sizes_[of[1]]);
            const std::uint32_t between = of[1] > last_[of[0]] ? of[1] - last_[of[0]] : 0;
            return std::tuple(-static_cast<double>(large) / small, -pair.closed, between, of);
        };
        const auto best = std::min_element(pairs.begin(), pairs.end(), [&](const auto& x, const auto& y) {
            const bool isX = x.second.closed > 0 && !x.second.never;
            const bool isY = y.second.closed > 0 && !y.second.never;
            return isX != isY ? isX : rank(x.first, x.second) < rank(y.first, y.second);
        });
        if (best == pairs.end() || best->second.closed == 0 || best->second.never)
            return false;
        join(best->first[0], best->first[1]);
        return true;
    }

    void joinWhatCannotBeTold()
    {
        for (bool more = true; more;) {
            more = false;
            for (const auto& edge : shared_) {
                const auto counts = at(edge);
                if (counts.size() < 2 || std::all_of(counts.begin(), counts.end(),
                                                     [](const auto& body) { return body.second == 2; }))
                    continue;
                for (const auto& body : counts)
                    join(counts.begin()->first, body.first);
                more = true;
            }
        }
    }

    std::vector<std::uint32_t> coloured()
    {
        std::map<std::uint32_t, std::vector<std::uint32_t>> beside;
        for (const auto& edge : shared_)
            for (const auto& [a, ofA] : at(edge))
                for (const auto& [b, ofB] : at(edge))
                    if (a != b)
                        beside[a].push_back(b);
        std::map<std::uint32_t, std::uint32_t> colours;
        for (const auto& [body, others] : beside) {
            std::vector<char> taken(others.size() + 1, 0);
            for (const std::uint32_t other : others)
                if (const auto found = colours.find(other);
                    found != colours.end() && found->second < taken.size())
                    taken[found->second] = 1;
            colours[body] =
                static_cast<std::uint32_t>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
        }
        std::vector<std::uint32_t> result(sizes_.size(), 0);
        for (std::uint32_t face = 0; face < result.size(); ++face)
            if (const auto found = colours.find(find(face)); found != colours.end())
                result[face] = found->second;
        return result;
    }

    JoinedSets sets_;
    std::vector<std::uint32_t> sizes_;  // in faces
    std::vector<std::uint32_t> last_;
    std::vector<std::vector<std::uint32_t>> shared_;  // faces at an edge that has more than two
};

}  // namespace

std::vector<std::uint32_t> touchingBodies(std::uint32_t faces, const OutlineWeld& weld)
{
    return Bodies(faces, weld).numbered();
}

}  // namespace knotspan
