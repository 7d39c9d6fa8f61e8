// A scene decomposed into Bezier patches, as renderers without NURBS on the device have it: each KSQuad a net
// of its own, made by the CPU at every edit.
#pragma once

#include "model/geometry/bezier_decomposition.h"
#include "renderer/scene/packed_scene.h"

namespace knotspan {

class BezierNets {
public:
    // What depends on the knots alone is made here.
    explicit BezierNets(const std::vector<Resident>& residents = {});

    // Where a resident's nets start, and how many points all have.
    [[nodiscard]] size_t firstPoint(size_t resident) const { return firsts_[resident]; }
    [[nodiscard]] size_t pointCount() const { return firsts_.back(); }
    [[nodiscard]] size_t residentCount() const { return decompositions_.size(); }

    // The nets of residents `first` .. `end` - 1, one behind the other, by all threads.
    void make(const std::vector<Resident>& residents, size_t first, size_t end,
              std::span<glm::vec4> to) const;

    [[nodiscard]] PackedTables<float> tables(const std::vector<Resident>& residents,
                                             Evaluator evaluator) const;

private:
    std::vector<BezierDecomposition> decompositions_;
    std::vector<size_t> firsts_;
};

}  // namespace knotspan
