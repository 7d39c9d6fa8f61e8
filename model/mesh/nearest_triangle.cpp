#include "model/mesh/nearest_triangle.h"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/mesh/deviation_measuring.h"

namespace knotspan {

namespace {

constexpr std::uint32_t kLeaf = 4;

double squaredDistance(const Vec3& point, const Box& box)
{
    const Vec3 outside = glm::max(glm::max(box.low - point, point - box.high), Vec3(0));
    return glm::dot(outside, outside);
}

}  // namespace

NearestTriangle::NearestTriangle(const TriangleMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size())
{
    check(!mesh.triangles.empty(), "there is a triangle to be near to");
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    std::vector<Vec3> centres;
    centres.reserve(order_.size());
    for (size_t k = 0; k < order_.size(); ++k) {
        const auto [a, b, c] = corners(k);
        centres.push_back(glm::min(glm::min(a, b), c) + glm::max(glm::max(a, b), c));
    }
    nodes_.reserve(order_.size());
    build(0, static_cast<std::uint32_t>(order_.size()), centres);
}

// Halves by number, along the longest side of the box.
void NearestTriangle::build(std::uint32_t first, std::uint32_t end, const std::vector<Vec3>& centres)
{
    const size_t number = nodes_.size();
    Node node{{}, first, end, 0};
    for (std::uint32_t k = first; k < end; ++k)
        for (const Vec3& corner : corners(order_[k]))
            node.box.add(corner);
    nodes_.push_back(node);
    if (end - first <= kLeaf)
        return;
    const Vec3 size = node.box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = first + (end - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return centres[a][axis] < centres[b][axis]; });
    build(first, middle, centres);
    nodes_[number].second = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end, centres);
}

NearestTriangle::Found NearestTriangle::to(const Vec3& point, size_t guess) const
{
    Found found{guess, distanceToTriangle(point, corners(guess))};
    struct Open {
        std::uint32_t node = 0;
        double squared = 0;
    };
    std::array<Open, 64> open;  // halving by number is never deeper than 32
    size_t count = 0;
    open[count++] = {0, squaredDistance(point, nodes_[0].box)};
    while (count > 0) {
        const Open next = open[--count];
        if (next.squared >= found.distance * found.distance)
            continue;
        const Node& node = nodes_[next.node];
        if (node.second == 0) {
            for (std::uint32_t k = node.first; k < node.end; ++k)
                if (const double distance = distanceToTriangle(point, corners(order_[k]));
                    distance < found.distance)
                    found = {order_[k], distance};
            continue;
        }
        Open near{next.node + 1, squaredDistance(point, nodes_[next.node + 1].box)};
        Open far{node.second, squaredDistance(point, nodes_[node.second].box)};
        if (far.squared < near.squared)
            std::swap(near, far);
        open[count++] = far;
        open[count++] = near;
    }
    return found;
}

std::array<Vec3, 3> NearestTriangle::corners(size_t triangle) const
{
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return {mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]};
}

}  // namespace knotspan
