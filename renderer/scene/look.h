// What the shadings are told by which a surface is judged (renderer/scene/render_lists.h), with the lists to
// choose from.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/analysis/curvature.h"
#include "model/core/space.h"

namespace knotspan {

// Numbers at the ends of a ramp of colours; low < high.
struct NumberRange {
    double low = -1;
    double high = 1;

    [[nodiscard]] bool operator==(const NumberRange&) const = default;
};

enum class Matcap : int { clay, chrome, pearl };

// What a checker's squares are equal in: shares of the domain, or lengths.
enum class CheckerBy : int { parameter, length };

struct Look {
    // zebra, reflection, isophotes: stripes over half a turn, from an axis in the picture's plane, this far
    // from upright, counter-clockwise.
    int stripes = 12;
    double stripesTurnedDegrees = 0;

    Matcap matcap = Matcap::clay;

    CurvatureKind curvature = CurvatureKind::mean;
    std::optional<NumberRange> curvatureRange;  // 1 per model unit (gauss: its square); nothing: by the model

    std::optional<NumberRange> deviationRange;  // model units; nothing: from 0 to the largest distance

    CheckerBy checker = CheckerBy::parameter;
    int checkerCells = 16;                // by parameter: along each
    std::optional<double> checkerLength;  // by length: of a square, above 0; nothing: by the model

    Vec3 pull{0, 0, 1};       // in which a mould is pulled, model space; not zero
    double draftDegrees = 5;  // full colour from there on; above 0

    [[nodiscard]] bool operator==(const Look&) const = default;
};

constexpr int kMostStripes = 500;
constexpr int kMostCheckerCells = 1000;

// A round length, so that some dozens of squares go along a model of that size.
[[nodiscard]] double checkerLengthFor(double size);

// Names as the command line has them.
struct CurvatureKindInfo {
    CurvatureKind id;
    std::string name;
    std::string description;
};
[[nodiscard]] const std::vector<CurvatureKindInfo>& curvatureKinds();
[[nodiscard]] std::optional<CurvatureKind> findCurvatureKind(std::string_view name);

struct MatcapInfo {
    Matcap id;
    std::string name;
    std::string description;
};
[[nodiscard]] const std::vector<MatcapInfo>& matcaps();
[[nodiscard]] std::optional<Matcap> findMatcap(std::string_view name);

struct CheckerByInfo {
    CheckerBy id;
    std::string name;
    std::string description;
};
[[nodiscard]] const std::vector<CheckerByInfo>& checkers();
[[nodiscard]] std::optional<CheckerBy> findChecker(std::string_view name);

// The ramp's colour at a place from 0 to 1, for legends: sRGB, encoded.
[[nodiscard]] Vec3 colourOnRamp(double place);

}  // namespace knotspan
