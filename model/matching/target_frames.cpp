#include "model/matching/target_frames.h"

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

// `across` is made to stand at right angles to `along` again.
EdgeFrame withAlong(EdgeFrame frame, const Vec3& along)
{
    frame.along = along;
    frame.across = glm::normalize(frame.across - glm::dot(frame.across, along) * along);
    frame.normal = glm::cross(frame.along, frame.across);
    return frame;
}

EdgeFrame meanOf(const EdgeFrame& first, const EdgeFrame& second)
{
    EdgeFrame mean = first;
    mean.across = first.across + second.across;
    mean.acrossAcross = 0.5 * (first.acrossAcross + second.acrossAcross);
    return mean;
}

}  // namespace

TargetFrames::TargetFrames(NurbsSurface edge, NurbsSurface partner, Partnering partnering,
                           std::optional<NurbsSurface> halfway)
    : edge_(std::move(edge)),
      partner_(std::move(partner)),
      partnering_(std::move(partnering)),
      halfway_(std::move(halfway))
{
}

EdgeFrame TargetFrames::at(double v) const
{
    EdgeFrame frame = turned(frameInto(partner_, partnering_(v)));
    if (halfway_)
        frame = meanOf(frame, frameInto(*halfway_, v));
    const SurfacePoint edge = evaluate(edge_, edge_.knotsU().domainStart(), v);
    frame.point = edge.position;
    return withAlong(frame, glm::normalize(edge.dv));
}

}  // namespace knotspan
