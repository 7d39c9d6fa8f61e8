// Corners of outlines that become one: a union-find that knows whose faces they are.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "model/core/joined_sets.h"
#include "model/core/space.h"

namespace knotspan {

class OutlineCorners {
public:
    std::uint32_t add(const Vec3& at, std::uint32_t face)
    {
        const std::uint32_t number = sets_.add();
        places_.push_back(at);
        reaches_.push_back(0);
        faces_.push_back({face});
        return number;
    }
    [[nodiscard]] std::uint32_t find(std::uint32_t corner) const { return sets_.find(corner); }
    void join(std::uint32_t one, std::uint32_t other)
    {
        const auto joined = sets_.join(one, other);
        if (!joined)
            return;
        const auto [a, b] = *joined;
        reaches_[a] = reachOfBoth(a, b);
        for (const std::uint32_t face : faces_[b])
            addFace(a, face);
        faces_[b].clear();
    }
    // How far from its place anything would be that became the corner of both.
    [[nodiscard]] double reachOfBoth(std::uint32_t a, std::uint32_t b) const
    {
        a = find(a);
        b = find(b);
        if (b < a)
            std::swap(a, b);
        return a == b ? reaches_[a]
                      : std::max(reaches_[a], glm::distance(places_[a], places_[b]) + reaches_[b]);
    }
    void addFace(std::uint32_t corner, std::uint32_t face)
    {
        if (!isOf(corner, face))
            faces_[find(corner)].push_back(face);
    }
    [[nodiscard]] bool isOf(std::uint32_t corner, std::uint32_t face) const
    {
        const auto& faces = faces_[find(corner)];
        return std::find(faces.begin(), faces.end(), face) != faces.end();
    }
    [[nodiscard]] bool shareAFace(std::uint32_t a, std::uint32_t b) const
    {
        const auto& faces = faces_[find(a)];
        return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t face) { return isOf(b, face); });
    }
    [[nodiscard]] const Vec3& at(std::uint32_t corner) const { return places_[find(corner)]; }
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(places_.size()); }

private:
    JoinedSets sets_;
    std::vector<Vec3> places_;
    std::vector<double> reaches_;
    std::vector<std::vector<std::uint32_t>> faces_;
};

}  // namespace knotspan
