// Corners of outlines that become one: a union-find that knows whose faces they are.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "model/core/space.h"

namespace knotspan {

class OutlineCorners {
public:
    std::uint32_t add(const Vec3& at, std::uint32_t face)
    {
        const auto number = static_cast<std::uint32_t>(into_.size());
        into_.push_back(number);
        places_.push_back(at);
        reaches_.push_back(0);
        faces_.push_back({face});
        return number;
    }
    [[nodiscard]] std::uint32_t find(std::uint32_t corner) const
    {
        while (into_[corner] != corner)
            corner = into_[corner] = into_[into_[corner]];
        return corner;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        if (a == b)
            return;
        if (b < a)
            std::swap(a, b);
        into_[b] = a;
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
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(into_.size()); }

private:
    mutable std::vector<std::uint32_t> into_;
    std::vector<Vec3> places_;
    std::vector<double> reaches_;
    std::vector<std::vector<std::uint32_t>> faces_;
};

}  // namespace knotspan
