#include "model/geometry/grid_evaluation.h"

#include <algorithm>
#include <bit>

#include <tbb/parallel_for.h>

#include "model/core/check.h"
#include "model/geometry/prepared_surface.h"

namespace knotspan {

using kernels::kGroupLanes;

namespace {

// The basis functions along v of all columns, in groups of lanes. The last group's spare lanes repeat the
// last column.
template <class Real>
struct Columns {
    std::vector<kernels::LaneGroup<Real>> groups;
    std::vector<Real> storage;
};

template <class Real>
Columns<Real> columnsOf(const PreparedSurface<Real>& prepared, std::span<const SpanParameter> v)
{
    constexpr size_t kLanes = static_cast<size_t>(kGroupLanes<Real>);
    const SpanTables& tables = prepared.basisV;
    const int order = prepared.order;
    const int q = tables.degree();
    Columns<Real> columns;
    columns.groups.resize((v.size() + kLanes - 1) / kLanes);
    const auto lanesOf = [&](size_t g) {
        return v.subspan(g * kLanes, std::min(kLanes, v.size() - g * kLanes));
    };
    size_t size = order >= 1 ? columns.groups.size() * kLanes : 0;  // for `shortest`
    for (size_t g = 0; g < columns.groups.size(); ++g) {
        kernels::LaneGroup<Real>& group = columns.groups[g];
        const auto [low, high] = std::ranges::minmax(lanesOf(g), {}, &SpanParameter::span);
        group.first = low.span - q;
        for (int b = 0; b <= order; ++b) {
            group.terms[b] = std::max(high.span - low.span + q + 1 - b, 0);
            size += static_cast<size_t>(group.terms[b]) * kLanes;
        }
    }
    columns.storage.resize(size + kLanes);
    // The kernels load whole groups of lanes: 64 bytes from an aligned start.
    Real* to = columns.storage.data();
    to += (kLanes - reinterpret_cast<std::uintptr_t>(to) / sizeof(Real) % kLanes) % kLanes;
    kernels::BasisLanes lanes;
    for (size_t g = 0; g < columns.groups.size(); ++g) {
        kernels::LaneGroup<Real>& group = columns.groups[g];
        Real* starts[3] = {};
        for (int b = 0; b <= order; ++b) {
            group.weights[b] = starts[b] = to;
            to += static_cast<size_t>(group.terms[b]) * kLanes;
        }
        Real* const shortest = to;
        if (order >= 1) {
            group.shortest = shortest;
            to += kLanes;
        }
        const auto parameters = lanesOf(g);
        for (size_t l = 0; l < kLanes; ++l) {
            const size_t inLanes = l % kernels::kBasisLanes;
            if (inLanes == 0)
                tables.basis(parameters.subspan(std::min(l, parameters.size() - 1)), order, lanes);
            const int span = parameters[std::min(l, parameters.size() - 1)].span;
            if (order >= 1)
                shortest[l] = prepared.shortestV[static_cast<size_t>(span)];
            const size_t skipped = static_cast<size_t>(span - q - group.first);
            for (int b = 0; b <= order; ++b)
                for (int k = 0; k <= q - b; ++k)
                    starts[b][(skipped + static_cast<size_t>(k)) * kLanes + l] =
                        static_cast<Real>(lanes.rows[b][k][inLanes]);
        }
    }
    return columns;
}

template <class Real>
std::vector<kernels::RowBasis<Real>> rowsOf(const PreparedSurface<Real>& prepared,
                                            std::span<const SpanParameter> u)
{
    const SpanTables& tables = prepared.basisU;
    const int order = prepared.order;
    std::vector<kernels::RowBasis<Real>> rows(u.size());
    kernels::BasisLanes lanes;
    for (size_t r = 0; r < u.size(); ++r) {
        const size_t inLanes = r % kernels::kBasisLanes;
        if (inLanes == 0)
            tables.basis(u.subspan(r), order, lanes);
        rows[r].first = u[r].span - tables.degree();
        if (order >= 1)
            rows[r].shortest = prepared.shortestU[static_cast<size_t>(u[r].span)];
        for (int a = 0; a <= order; ++a)
            for (int k = 0; k <= tables.degree() - a; ++k)
                rows[r].weights[a][k] = static_cast<Real>(lanes.rows[a][k][inLanes]);
    }
    return rows;
}

}  // namespace

// A rectangle of the grid: some rows and some groups of columns.
template <class Real>
class GridTask {
public:
    GridTask(const PreparedSurface<Real>& prepared, std::span<const SpanParameter> u,
             std::span<const SpanParameter> v, GridSamples<Real>& samples)
        : prepared_(prepared),
          u_(u),
          v_(v),
          samples_(samples),
          rows_(rowsOf(prepared, u)),
          columns_(columnsOf(prepared, v)),
          // What one row of control points leaves behind for each group, so that all of it stays in the first
          // cache.
          perGroup_(kernels::scratchSize<Real>(prepared.basisU.degree(),
                                               static_cast<int>(prepared.nets.nets.size()),
                                               prepared.nets.components, 1)),
          groupsInBlock_(std::clamp(kScratch / perGroup_, size_t{1}, size_t{8}))
    {
    }

    [[nodiscard]] size_t blockCount() const
    {
        return (columns_.groups.size() + groupsInBlock_ - 1) / groupsInBlock_;
    }

    void run(size_t block, size_t firstRow, size_t lastRow) const
    {
        alignas(kernels::kGroupBytes) Real scratch[kScratch];
        const size_t firstGroup = block * groupsInBlock_;
        const size_t groups = std::min(groupsInBlock_, columns_.groups.size() - firstGroup);
        kernels::Block<Real> task;
        task.groups = columns_.groups.data() + firstGroup;
        task.groupCount = static_cast<int>(groups);
        task.rows = rows_.data() + firstRow;
        task.rowCount = static_cast<int>(lastRow - firstRow);
        task.scratch = scratch;
        prepared_.aim(task, samples_,
                      firstRow * samples_.stride() + firstGroup * static_cast<size_t>(kGroupLanes<Real>));
        std::vector<std::uint32_t> unsure;
        if (prepared_.fields.normals) {
            unsure.resize((lastRow - firstRow) * groups);
            task.unsure = unsure.data();
        }
        kernels::evaluate(task);
        typename PreparedSurface<Real>::Unsure found;
        for (size_t k = 0; k < unsure.size(); ++k)
            if (unsure[k] != 0)
                collect(firstRow + k / groups, firstGroup + k % groups, unsure[k], found);
        prepared_.settleNormals(samples_, found);
    }

private:
    // At least what one group needs at the highest degree.
    static constexpr size_t kScratch =
        std::max(16384 / sizeof(Real), kernels::scratchSize<Real>(kMaxDegree, kernels::kMaxFields, 4, 1));

    void collect(size_t row, size_t group, std::uint32_t unsure,
                 typename PreparedSurface<Real>::Unsure& found) const
    {
        for (; unsure != 0; unsure &= unsure - 1) {
            const size_t column = group * static_cast<size_t>(kGroupLanes<Real>) +
                                  static_cast<size_t>(std::countr_zero(unsure));
            if (column >= v_.size())
                return;
            found.at.push_back(row * samples_.stride() + column);
            found.u.push_back(u_[row]);
            found.v.push_back(v_[column]);
        }
    }

    const PreparedSurface<Real>& prepared_;
    std::span<const SpanParameter> u_;
    std::span<const SpanParameter> v_;
    GridSamples<Real>& samples_;
    std::vector<kernels::RowBasis<Real>> rows_;
    Columns<Real> columns_;
    size_t perGroup_;
    size_t groupsInBlock_;
};

template <class Real>
GridEvaluator<Real>::GridEvaluator(const NurbsSurface& surface, SampleFields fields)
    : prepared_(std::make_unique<PreparedSurface<Real>>(surface, fields))
{
}

template <class Real>
GridEvaluator<Real>::~GridEvaluator() = default;
template <class Real>
GridEvaluator<Real>::GridEvaluator(GridEvaluator&&) noexcept = default;
template <class Real>
GridEvaluator<Real>& GridEvaluator<Real>::operator=(GridEvaluator&&) noexcept = default;

template <class Real>
const Vec3& GridEvaluator<Real>::origin() const
{
    return prepared_->nets.origin;
}

template <class Real>
void GridEvaluator<Real>::evaluate(std::span<const SpanParameter> u, std::span<const SpanParameter> v,
                                   GridSamples<Real>& samples, Threads threads) const
{
    // Fewer points than this are done before another thread has started.
    constexpr size_t kWorthThreads = 16384;
    samples.resize(static_cast<int>(u.size()), static_cast<int>(v.size()), prepared_->fields, origin());
    if (u.empty() || v.empty())
        return;
    const GridTask<Real> task(*prepared_, u, v, samples);
    const bool manyThreads = threads == Threads::all && u.size() * v.size() >= kWorthThreads;
    const size_t rowsInTask = manyThreads ? std::max<size_t>(16, kWorthThreads / v.size()) : u.size();
    const size_t chunks = (u.size() + rowsInTask - 1) / rowsInTask;
    const auto run = [&](size_t k) {
        const size_t firstRow = k % chunks * rowsInTask;
        task.run(k / chunks, firstRow, std::min(firstRow + rowsInTask, u.size()));
    };
    if (manyThreads)
        tbb::parallel_for(size_t{0}, task.blockCount() * chunks, run);
    else
        for (size_t k = 0; k < task.blockCount(); ++k)
            run(k);
}

// Their scattered evaluation: scattered_evaluation.cpp.
template class GridEvaluator<float>;
template class GridEvaluator<double>;

}  // namespace knotspan
