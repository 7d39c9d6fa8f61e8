// Parts of KSQuads, and whether they keep apart: by slabs around their Bezier nets in thirteen directions, by
// planes across either of them, and cut into four where that is not enough (shell_crossings.h).
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "model/geometry/bezier_conversion.h"

namespace knotspan {

// How far a net reaches in each of thirteen directions, both ways.
class Slabs {
public:
    explicit Slabs(const BezierNet& net);

    // False where some number is none.
    [[nodiscard]] bool areApart(const Slabs& other) const
    {
        for (size_t k = 0; k < kCount; ++k)
            if (low_[k] > other.high_[k] || other.low_[k] > high_[k])
                return true;
        return false;
    }
    [[nodiscard]] double size() const
    {
        return high_[0] - low_[0] + (high_[1] - low_[1]) + (high_[2] - low_[2]);
    }

private:
    static constexpr size_t kCount = 13;
    std::array<double, kCount> low_{};
    std::array<double, kCount> high_{};
};

// A part of a KSQuad; its quarters are made when they are asked for.
class Piece {
public:
    explicit Piece(BezierNet of);

    [[nodiscard]] const Slabs& slabs() const { return slabs_; }
    [[nodiscard]] const std::vector<Piece>& quarters();
    // Slabs, or a plane along one of both, keep them apart.
    [[nodiscard]] bool isApartFrom(const Piece& other) const;
    // To within the margin.
    [[nodiscard]] bool sharesCorner(const Piece& other, double margin) const;

private:
    [[nodiscard]] Vec3 across() const;  // its diagonals
    [[nodiscard]] std::pair<double, double> reach(const Vec3& direction) const;

    BezierNet net_;
    Slabs slabs_;
    std::array<Vec3, 4> corners_{};
    std::vector<Piece> quarters_;
};

// False where that could not be shown with some cuts.
[[nodiscard]] bool areApart(const Piece& a, const Piece& b);

// Of KSQuads beside each other, or of one KSQuad alone: all quarters that have no corner in common.
[[nodiscard]] bool areApartButForCorners(Piece& a, Piece& b, double margin);

}  // namespace knotspan
