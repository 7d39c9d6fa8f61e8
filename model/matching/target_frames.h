// What a side is to look like along its edge so that it continues its partner.
#pragma once

#include <optional>

#include "model/matching/edge_frame.h"
#include "model/matching/partner.h"

namespace knotspan {

class TargetFrames {
public:
    // The partner's own frames, turned to lead into the side; with `halfway`, the side as it was, the mean of
    // both. Only of `edge`, the side with its edge where it is to be, they take the direction along it.
    TargetFrames(NurbsSurface edge, NurbsSurface partner, Partnering partnering,
                 std::optional<NurbsSurface> halfway);

    [[nodiscard]] EdgeFrame at(double v) const;

private:
    NurbsSurface edge_;
    NurbsSurface partner_;
    Partnering partnering_;
    std::optional<NurbsSurface> halfway_;
};

}  // namespace knotspan
