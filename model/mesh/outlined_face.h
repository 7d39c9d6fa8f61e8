// A face of a model with its outline in space: what welding needs to know of it.
#pragma once

#include <memory>

#include "model/analysis/border_curves.h"
#include "model/geometry/grid_evaluation.h"
#include "model/trimming/face_outline.h"

namespace knotspan {

class OutlinedFace {
public:
    // The surface has to stay.
    OutlinedFace(const PlacedSurface& placed, const TrimRegion& region);

    [[nodiscard]] const NurbsSurface& surface() const { return *surface_; }
    [[nodiscard]] bool isTrimmed() const { return trimmed_; }
    [[nodiscard]] const std::vector<OutlineArc>& arcs() const { return arcs_; }
    [[nodiscard]] std::array<SpanParameter, 2> parametersAt(const OutlinePlace& place) const;
    // In model space. Not from two threads at once.
    [[nodiscard]] Vec3 pointAt(const OutlinePlace& place) const;
    [[nodiscard]] Vec3 pointOn(std::uint32_t arc, double t) const { return pointAt(arcs_[arc].placeAt(t)); }

    // Points along an arc, close enough together to start a search from.
    struct Sample {
        double t = 0;
        Vec3 point;
    };
    [[nodiscard]] const std::vector<Sample>& samples(std::uint32_t arc) const { return samples_[arc]; }

    struct Nearest {
        double t = 0;
        double distance = 0;
    };
    // Of the arc between two of its parameters, from the best of the samples or from `guess` on.
    [[nodiscard]] Nearest nearest(std::uint32_t arc, double from, double to, const Vec3& point) const;
    [[nodiscard]] Nearest nearestFrom(std::uint32_t arc, double from, double to, double guess,
                                      const Vec3& point) const;

private:
    [[nodiscard]] Nearest descended(std::uint32_t arc, double from, double to, double guess,
                                    const Vec3& point, bool& settled) const;
    [[nodiscard]] Nearest lookedThrough(std::uint32_t arc, double from, double to, const Vec3& point,
                                        Nearest best) const;

    const NurbsSurface* surface_;
    Mat4 transform_;
    bool trimmed_;
    std::vector<OutlineArc> arcs_;
    std::vector<std::vector<Sample>> samples_;
    std::unique_ptr<GridEvaluator<double>> evaluator_;
    std::unique_ptr<GridSamples<double>> found_;
};

}  // namespace knotspan
