// Whether two surfaces whose tangent planes agree along an edge bend alike across it.
//
// Along an edge that two surfaces share with its tangent planes, their second fundamental forms agree where
// the normal curvatures in one direction that is not the edge's do. Pegna and Wolter, Geometrical criteria to
// guarantee curvature continuity of blend surfaces, J. Mech. Des. 114 (1992).
#pragma once

#include <functional>
#include <optional>

#include "model/friends/bernstein_products.h"

namespace knotspan {

struct CurvatureLimits {
    double share = 0.01;  // of the larger normal curvature
    double least = 0;     // curvatures below count as this large
    double angle = 0;     // no larger one is between the normals, radians
};

struct CurvatureAgreement {
    bool certain = false;   // nowhere do the curvatures differ by more than allowed
    double difference = 0;  // the largest that was met
    size_t part = 0;        // where it is largest against what is allowed there
    double tau = 0;
};

// curvatureForm() of a matched part from one tau to another. Made anew for each piece: where edges' speeds
// and normals vary much, small figures of a whole part would drown in the rounding of large ones.
using CurvatureForms = std::function<std::optional<Form>(size_t part, double from, double to)>;

// Of so many parts. Nothing where one of them has no form.
[[nodiscard]] std::optional<CurvatureAgreement> curvatureAgreement(size_t parts, const CurvatureForms& formOf,
                                                                   const CurvatureLimits& limits);

}  // namespace knotspan
