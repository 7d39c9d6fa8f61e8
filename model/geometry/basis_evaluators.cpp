#include "model/geometry/basis_evaluators.h"

#include <algorithm>
#include <type_traits>

#include "model/core/check.h"
#include "model/geometry/evaluator_tables.h"

namespace knotspan {

namespace {

#define KNOTSPAN_ONE(...) +1
static_assert(KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_ONE) == KNOTSPAN_EVALUATOR_COUNT,
              "the count goes with the list");
#undef KNOTSPAN_ONE

// Up to which degree each is the best, from docs/measurements.md: triangular is fast and reads the shortest
// table, bernstein keeps the most digits. The powers of t are not among them: they keep digits of the largest
// weight only, and weights 25 times apart are too much for them at degree 3.
struct Choice {
    int mostDegree;
    Evaluator evaluator;
};
constexpr Choice kFloatChoices[] = {{9, Evaluator::triangular}, {kMaxDegree, Evaluator::bernstein}};
constexpr Choice kDoubleChoices[] = {{kMaxDegree, Evaluator::bernstein}};

// Beyond so many spans the share of a neighbour is less than the number type can tell from nothing.
template <class Real>
constexpr double kMostSpans = sizeof(Real) == sizeof(float) ? 1e30 : 1e300;

// What tables are made in: more digits than they are kept with, so that only the last rounding is left.
template <class Real>
using Wide = std::conditional_t<sizeof(Real) == sizeof(float), double, long double>;

}  // namespace

const std::vector<EvaluatorInfo>& evaluators()
{
#define KNOTSPAN_ROW(number, name, values, both, bent, sentence) {Evaluator::name, #name, sentence},
    static const std::vector<EvaluatorInfo> infos = {
        {Evaluator::automatic, "auto",
         "The fastest that is exact at the model's degrees, whatever its weights"},
        KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_ROW)};
#undef KNOTSPAN_ROW
    return infos;
}

const EvaluatorInfo& evaluatorInfo(Evaluator evaluator)
{
    const auto& infos = evaluators();
    const auto found = std::find_if(infos.begin(), infos.end(),
                                    [&](const EvaluatorInfo& info) { return info.id == evaluator; });
    check(found != infos.end(), "every evaluator is in the list");
    return *found;
}

std::optional<Evaluator> findEvaluator(std::string_view name)
{
    for (const EvaluatorInfo& info : evaluators())
        if (info.name == name)
            return info.id;
    return std::nullopt;
}

Evaluator chosenEvaluator(Evaluator wish, int degree, Precision precision)
{
    if (wish != Evaluator::automatic)
        return wish;
    const Choice* choice = precision == Precision::float32 ? kFloatChoices : kDoubleChoices;
    while (choice->mostDegree < degree)
        ++choice;
    return choice->evaluator;
}

size_t spanTableSize(Evaluator evaluator, int degree)
{
    const auto p = static_cast<size_t>(degree);
    switch (evaluator) {
    case Evaluator::triangular:
        return 2 * p;
    case Evaluator::stair:
        return 2 * p + p * (p + 1) / 2;
    case Evaluator::power:
        return (p + 1) * (p + 1);
    case Evaluator::bernstein:
        return (p + 1) * (p + 1) + p * p;
    case Evaluator::automatic:
        break;
    }
    check(false, "an evaluator was chosen");
    return 0;
}

template <class Real>
void appendSpanTable(Evaluator evaluator, const KnotVector& knots, int span, std::vector<Real>& to)
{
    const auto differences = evaluator_tables::differences<Wide<Real>>(knots, span, kMostSpans<Real>);
    switch (evaluator) {
#define KNOTSPAN_ONE(number, name, ...)                                                    \
    case Evaluator::name:                                                                  \
        for (const Wide<Real> value : evaluator_tables::name(knots.degree(), differences)) \
            to.push_back(static_cast<Real>(value));                                        \
        return;
        KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_ONE)
#undef KNOTSPAN_ONE
    case Evaluator::automatic:
        break;
    }
    check(false, "an evaluator was chosen");
}

template void appendSpanTable(Evaluator, const KnotVector&, int, std::vector<float>&);
template void appendSpanTable(Evaluator, const KnotVector&, int, std::vector<double>&);

}  // namespace knotspan
