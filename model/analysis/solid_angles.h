// How often a closed mesh winds round a point: the sum of the solid angles of its triangles.
//
// Van Oosterom and Strackee, The solid angle of a plane triangle (1983). The angles are summed as products of
// complex numbers with a count of whole turns, so no arc tangent is taken.
#pragma once

#include <complex>
#include <optional>

#include "model/core/space.h"

namespace knotspan {

class SolidAngles {
public:
    explicit SolidAngles(const Vec3& eye) : eye_(eye) {}

    // From here on triangles count as if they were wound the other way, or again as they are.
    void turn(bool turned) { sign_ = turned ? -1 : 1; }

    // A polygon, fanned from its first corner, corner by corner.
    void beginPolygon() { corners_ = 0; }
    void addCorner(const Vec3& corner);

    void addTriangle(const Vec3& a, const Vec3& b, const Vec3& c);

    // Their sum, in whole turns round the point: of a closed mesh an integer up to rounding, positive where
    // triangles that wind counterclockwise seen from far outside enclose it. Nothing where the point lies on
    // a triangle.
    [[nodiscard]] std::optional<double> turns() const;
    // The integer that so many turns are; nothing where they are none: the mesh was not closed.
    [[nodiscard]] static std::optional<int> wholeTurns(double turns);
    [[nodiscard]] std::optional<int> windings() const
    {
        const auto around = turns();
        return around ? wholeTurns(*around) : std::nullopt;
    }

private:
    // Relative to the eye.
    struct Corner {
        Vec3 at{};
        double distance = 0;
    };
    void add(const Corner& a, const Corner& b, const Corner& c);

    Vec3 eye_;
    int corners_ = 0;
    Corner first_;
    Corner last_;
    std::complex<double> direction_{1, 0};  // of the sum of half angles
    int turns_ = 0;
    double sign_ = 1;
    bool certain_ = true;
};

}  // namespace knotspan
