#include "app/evaluator_measurement.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "model/core/spread.h"

namespace knotspan::app {
namespace {

constexpr int kRepeats = 7;

class ErrorFigures {
public:
    // `offset` is from the surface's origin. A KSQuad without size has no errors.
    template <class Vector>
    void add(const Vector& offset, const ExactPoint& exact)
    {
        if (!(exact.size > 0))
            return;
        const double error =
            static_cast<double>(glm::length(ExactVec3(offset) - exact.position)) / exact.size;
        finite_ = finite_ && std::isfinite(error);
        largest_ = std::max(largest_, error);
        sum_ += error;
        ++count_;
    }

    void fill(EvaluatorRow& row) const
    {
        if (!finite_)
            row.unavailable = "The model's figures are beyond the range of this number type";
        row.errorMax = largest_;
        row.errorMean = count_ == 0 ? 0 : sum_ / static_cast<double>(count_);
    }

private:
    bool finite_ = true;
    double largest_ = 0;
    double sum_ = 0;
    size_t count_ = 0;
};

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double secondsOf(const std::function<void()>& work)
{
    const auto start = Clock::now();
    work();
    return secondsSince(start);
}

// The median of `seconds()`, called a few times, or less often where that takes long.
double medianOf(const std::function<double()>& seconds)
{
    constexpr double kPatience = 1;
    std::vector<double> values;
    const auto start = Clock::now();
    while (values.size() < kRepeats && (values.empty() || secondsSince(start) < kPatience))
        values.push_back(seconds());
    return spreadOf(std::move(values)).median;
}

void fillSpeed(EvaluatorRow& row, size_t points, double seconds)
{
    if (seconds > 0)
        row.millionPointsPerSecond = static_cast<double>(points) / seconds * 1e-6;
    else
        row.unavailable = row.processor == Processor::gpu
                              ? "The device has no clock"
                              : "The points are too few for so many surfaces; ask for more by --points";
}

// The rows of the CPU in one number type.
template <class Real>
class CpuMeasurement {
public:
    explicit CpuMeasurement(const MeasuredPoints& points) : points_(points)
    {
        for (const MeasuredSurface& surface : points.surfaces)
            evaluators_.emplace_back(surface.object->surface,
                                     SampleFields{.derivatives = 1, .normals = true});
    }

    void scattered(Evaluator evaluator, EvaluatorRow& row)
    {
        const auto evaluate = [&](const GridEvaluator<Real>& surface, const MeasuredSurface& at) {
            surface.evaluateScatteredBy(evaluator, at.scattered.u, at.scattered.v, samples_, Threads::one);
        };
        // What a call does without points: the tables of all spans, which the GPU gets ready-made.
        const auto makeTables = [&](const GridEvaluator<Real>& surface, const MeasuredSurface&) {
            surface.evaluateScatteredBy(evaluator, {}, {}, noSamples_, Threads::one);
        };
        fillErrors(row, evaluate, &MeasuredSurface::scattered);
        fillSpeed(row, points_.scattered, medianOf([&] {
                      return secondsOf([&] { forAll(evaluate); }) - secondsOf([&] { forAll(makeTables); });
                  }));
    }

    void grid(EvaluatorRow& row)
    {
        const auto evaluate = [&](const GridEvaluator<Real>& surface, const MeasuredSurface& at) {
            surface.evaluate(at.grid.u, at.grid.v, samples_, Threads::one);
        };
        fillErrors(row, evaluate, &MeasuredSurface::grid);
        fillSpeed(row, points_.grid, medianOf([&] { return secondsOf([&] { forAll(evaluate); }); }));
    }

private:
    template <class Work>
    void forAll(const Work& work)
    {
        for (size_t k = 0; k < evaluators_.size(); ++k)
            work(evaluators_[k], points_.surfaces[k]);
    }

    template <class Evaluate>
    void fillErrors(EvaluatorRow& row, const Evaluate& evaluate, Places MeasuredSurface::*places)
    {
        ErrorFigures errors;
        forAll([&](const GridEvaluator<Real>& surface, const MeasuredSurface& at) {
            evaluate(surface, at);
            const auto columns = static_cast<size_t>(samples_.columns());
            for (const ExactPoint& point : (at.*places).exact)
                errors.add(samples_.position(static_cast<int>(point.index / columns),
                                             static_cast<int>(point.index % columns)),
                           point);
        });
        errors.fill(row);
    }

    const MeasuredPoints& points_;
    std::vector<GridEvaluator<Real>> evaluators_;
    GridSamples<Real> samples_;
    GridSamples<Real> noSamples_;
};

// The rows of the GPU.
class GpuMeasurement {
public:
    explicit GpuMeasurement(const EvaluatorRequest& request) : request_(request)
    {
        if (request.renderer == nullptr)
            return;
        places_.reserve(request.points.scattered);
        for (const MeasuredSurface& at : request.points.surfaces)
            for (size_t k = 0; k < at.scattered.u.size(); ++k) {
                const SpanParameter& u = at.scattered.u[k];
                const SpanParameter& v = at.scattered.v[k];
                places_.push_back({at.id, u.span, v.span, u.t, v.t});
            }
    }

    void scattered(Evaluator evaluator, EvaluatorRow& row) const
    {
        row.unavailable = request_.renderer == nullptr ? request_.whyNoRenderer
                                                       : request_.renderer->whyUnavailable(row.precision);
        if (!row.unavailable.empty())
            return;
        const auto evaluated = request_.renderer->evaluate(places_, {evaluator, row.precision, kRepeats});
        if (!evaluated) {
            row.unavailable = evaluated.error().sentence();
            return;
        }
        ErrorFigures errors;
        size_t first = 0;
        for (const MeasuredSurface& at : request_.points.surfaces) {
            for (const ExactPoint& point : at.scattered.exact)
                errors.add(evaluated->points[first + point.index].position, point);
            first += at.scattered.u.size();
        }
        errors.fill(row);
        fillSpeed(row, places_.size(), evaluated->gpuMs * 1e-3);
    }

private:
    const EvaluatorRequest& request_;
    std::vector<EvaluationPoint> places_;
};

// Without figures: in each number type the CPU's, the grid, then the GPU's.
std::vector<EvaluatorRow> emptyRows(int degree)
{
    std::vector<EvaluatorRow> rows;
    for (const Precision precision : {Precision::float32, Precision::float64})
        for (const Processor processor : {Processor::cpu, Processor::gpu}) {
            for (const EvaluatorInfo& info : evaluators())
                if (info.id != Evaluator::automatic)
                    rows.push_back({info.name, precision, processor,
                                    info.id == chosenEvaluator(Evaluator::automatic, degree, precision)});
            if (processor == Processor::cpu)
                rows.push_back({"grid", precision, processor});
        }
    return rows;
}

}  // namespace

double nanosecondsPerPoint(const EvaluatorRow& row)
{
    return 1e3 / row.millionPointsPerSecond;
}

double inUnits(const EvaluatorRow& row, double error)
{
    return error * (row.precision == Precision::float32 ? 0x1p24 : 0x1p53);
}

std::vector<EvaluatorRow> measureEvaluators(const EvaluatorRequest& request)
{
    std::vector<EvaluatorRow> rows = emptyRows(request.degree);
    const GpuMeasurement gpu(request);
    size_t done = 0;
    const auto measureIn = [&](Precision precision, auto cpu) {
        for (EvaluatorRow& row : rows) {
            if (row.precision != precision)
                continue;
            request.progress(done++, rows.size());
            const auto evaluator = findEvaluator(row.evaluator);
            if (!evaluator)
                cpu.grid(row);
            else if (row.processor == Processor::cpu)
                cpu.scattered(*evaluator, row);
            else
                gpu.scattered(*evaluator, row);
        }
    };
    measureIn(Precision::float32, CpuMeasurement<float>(request.points));
    measureIn(Precision::float64, CpuMeasurement<double>(request.points));
    return rows;
}

}  // namespace knotspan::app
