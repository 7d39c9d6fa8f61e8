// Which of very many boxes touch a box: a binary tree of boxes, kept while some of them move.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/core/space.h"

namespace knotspan {

[[nodiscard]] inline bool touch(const Box& a, const Box& b)
{
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
}

class BoxTree {
public:
    // Box k is number k. Empty ones are found by nobody until they are moved.
    explicit BoxTree(std::vector<Box> boxes = {}) : boxes_(std::move(boxes)), leafOf_(boxes_.size(), 0)
    {
        std::vector<std::uint32_t> order(boxes_.size());
        for (std::uint32_t k = 0; k < order.size(); ++k)
            order[k] = k;
        nodes_.reserve(2 * order.size());
        if (!order.empty())
            build(order, 0, order.size(), kNone);
    }

    void move(std::uint32_t number, const Box& box)
    {
        boxes_[number] = box;
        for (std::uint32_t node = leafOf_[number]; node != kNone; node = nodes_[node].parent)
            nodes_[node].box = nodes_[node].second == kNone ? box : joined(nodes_[node]);
    }

    // visit(number) for all whose boxes touch it, in no order that means anything.
    template <class Visit>
    void touching(const Box& box, const Visit& visit) const
    {
        std::vector<std::uint32_t> open;
        if (!nodes_.empty())
            open.push_back(0);
        while (!open.empty()) {
            const Node& node = nodes_[open.back()];
            open.pop_back();
            if (!touch(node.box, box))
                continue;
            if (node.second == kNone)
                visit(node.first);
            else
                open.insert(open.end(), {node.first, node.second});
        }
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffU;
    struct Node {
        Box box;
        std::uint32_t parent = kNone;
        std::uint32_t first = 0;       // a node; a box's number in a leaf
        std::uint32_t second = kNone;  // none in a leaf
    };

    [[nodiscard]] Box joined(const Node& node) const
    {
        Box box = nodes_[node.first].box;
        box.add(nodes_[node.second].box);
        return box;
    }

    std::uint32_t build(std::vector<std::uint32_t>& order, size_t from, size_t to, std::uint32_t parent)
    {
        const auto name = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({{}, parent, order[from], kNone});
        if (to - from == 1) {
            nodes_[name].box = boxes_[order[from]];
            leafOf_[order[from]] = name;
            return name;
        }
        Box box;
        for (size_t k = from; k < to; ++k)
            box.add(boxes_[order[k]]);
        const Vec3 size = box.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto key = [&](std::uint32_t k) {
            return boxes_[k].isEmpty() ? 0.0 : boxes_[k].low[axis] + boxes_[k].high[axis];
        };
        const size_t middle = from + (to - from) / 2;
        std::nth_element(order.begin() + static_cast<std::ptrdiff_t>(from),
                         order.begin() + static_cast<std::ptrdiff_t>(middle),
                         order.begin() + static_cast<std::ptrdiff_t>(to),
                         [&](std::uint32_t x, std::uint32_t y) { return key(x) < key(y); });
        const std::uint32_t first = build(order, from, middle, name);
        const std::uint32_t second = build(order, middle, to, name);
        nodes_[name].box = box;
        nodes_[name].first = first;
        nodes_[name].second = second;
        return name;
    }

    std::vector<Box> boxes_;
    std::vector<std::uint32_t> leafOf_;
    std::vector<Node> nodes_;
};

}  // namespace knotspan
