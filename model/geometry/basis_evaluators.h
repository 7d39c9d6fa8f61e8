// The evaluators of basis functions as C++ sees them: made from shaders/shared/evaluator_list.h, so that a
// new one appears in the command line, the window and the measurements by its one line there.
//
// What an evaluator computes is shaders/shared/nurbs_basis.glsl, for shaders and, as
// gpu::evaluateBasis<evaluator, Real>(TableSource<Real>{...}, ...), for C++.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/geometry/knot_vector.h"
#include "shaders/shared/evaluator_list.h"

namespace knotspan {

// The values are those of the specialization constant; `automatic` is a wish, no evaluator.
enum class Evaluator : std::uint8_t {
#define KNOTSPAN_ONE(number, name, ...) name = number,
    KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_ONE)
#undef KNOTSPAN_ONE
        automatic
};

struct EvaluatorInfo {
    Evaluator id;
    std::string name;         // "triangular"
    std::string description;  // a sentence for a tooltip
};

// In the order that pickers show: `auto` first.
[[nodiscard]] const std::vector<EvaluatorInfo>& evaluators();
[[nodiscard]] const EvaluatorInfo& evaluatorInfo(Evaluator evaluator);
[[nodiscard]] std::optional<Evaluator> findEvaluator(std::string_view name);

// The number type of an evaluation.
enum class Precision : std::uint8_t { float32, float64 };

// The wish itself, or for `automatic` the fastest that is measured to be within 16 units (2^-24 in float,
// 2^-53 in double) of the local size at that degree, whatever the weights.
[[nodiscard]] Evaluator chosenEvaluator(Evaluator wish, int degree, Precision precision);

// The numbers that the evaluator, not `automatic`, reads for span i, one of knots.spans(): made with more
// digits than Real has, rounded last.
[[nodiscard]] size_t spanTableSize(Evaluator evaluator, int degree);
template <class Real>
void appendSpanTable(Evaluator evaluator, const KnotVector& knots, int span, std::vector<Real>& to);
extern template void appendSpanTable(Evaluator, const KnotVector&, int, std::vector<float>&);
extern template void appendSpanTable(Evaluator, const KnotVector&, int, std::vector<double>&);

// What the functions of nurbs_basis.glsl read tables from in C++.
template <class Real>
struct TableSource {
    const Real* numbers;

    [[nodiscard]] Real spanTable(std::uint32_t index) const { return numbers[index]; }
};

}  // namespace knotspan
