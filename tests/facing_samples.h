// Whether a KSQuad shows a point to an eye, by dense sampling in double: the truth that facing tests are
// measured by.
#pragma once

#include <random>
#include <vector>

#include "model/geometry/ksquad.h"

namespace knotspan::testing {

// Of a KSQuad of one surface, its borders included.
class FacingSamples {
public:
    // (cells + 1)^2 points. The surface outlives it.
    FacingSamples(const NurbsSurface& surface, const KsQuad& quad, int cells);

    // Whether any sampled point that has a normal, S_u x S_v, turns it towards the eye: (e, 1) or (direction,
    // 0).
    [[nodiscard]] bool showTo(const Vec4& eye) const;

    // An eye from anywhere around `box`; or one in the tangent plane of one of the points, or nearly there:
    // where most of what a test may get wrong is. Some are directions.
    [[nodiscard]] Vec4 randomEye(std::mt19937& random, const Box& box) const;
    [[nodiscard]] Vec4 tangentEye(std::mt19937& random, const Box& box) const;

private:
    struct Sample {
        Vec3 position;
        Vec3 normal;  // not of length 1
    };
    std::vector<Sample> samples_;
    double longest_ = 0;  // of the normals
};

[[nodiscard]] Vec3 randomDirection(std::mt19937& random);

// A surface like a ball with bumps of this size, bicubic, spans x spans KSQuads.
[[nodiscard]] NurbsSurface bumpyBall(std::mt19937& random, int spans, double bumps, bool rational);

// How many KSQuad-views of about `views` a test looks at: ten times as many where KNOTSPAN_SOAK is set.
[[nodiscard]] int soakOf(int views);

// What a test of facing did in views of KSQuads.
struct FacingCount {
    long views = 0;
    long away = 0;    // showed no sample
    long culled = 0;  // of those
    long wrong = 0;   // culled, but showed something

    void add(bool shows, bool isCulled)
    {
        ++views;
        away += !shows;
        culled += isCulled && !shows;
        wrong += isCulled && shows;
    }
    [[nodiscard]] double share() const { return static_cast<double>(culled) / static_cast<double>(away); }
};

}  // namespace knotspan::testing
