// The fast evaluation of a surface at many parameters at once, in float or double: with SIMD for whatever the
// processor has, and on several threads where there is enough to do. What draws on the CPU, exports and
// analyses uses this; evaluation.h is the reference that it is measured against.
//
// A grid takes a two-stage contraction: the control points of each row are contracted along v once for each
// v, then along u for each point. Derivatives are B-splines of differences of control points (The NURBS Book,
// eq. 3.4), so that nothing cancels where spans are short.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/geometry/basis_evaluators.h"
#include "model/geometry/nurbs_surface.h"
#include "model/geometry/span_parameter.h"

namespace knotspan {

// What to compute beside positions. Normals need the first derivatives and bring them along.
struct SampleFields {
    int derivatives = 0;   // the highest order, 0 .. 2
    bool normals = false;  // unit, as evaluateNormal() gives them where tangents vanish
};

// Samples in rows of one u each (or in one row, for scattered parameters). Each component is a plane of its
// own, so that what reads them can use SIMD too. Kept between evaluations its memory is used again: getting
// fresh memory from the system takes longer than filling it.
template <class Real>
class GridSamples {
public:
    using Vector = glm::vec<3, Real>;

    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] int columns() const { return columns_; }
    // From one row to the next in a plane, at least columns(); what lies behind the last column means
    // nothing.
    [[nodiscard]] size_t stride() const { return stride_; }

    // Positions are relative to this, the surface's own origin, so that float keeps its digits.
    [[nodiscard]] const Vec3& origin() const { return origin_; }

    [[nodiscard]] Vector position(int row, int column) const { return at(kPosition, row, column); }
    // In model units per unit of the parameters.
    [[nodiscard]] Vector du(int row, int column) const { return at(kDu, row, column); }
    [[nodiscard]] Vector dv(int row, int column) const { return at(kDv, row, column); }
    [[nodiscard]] Vector duu(int row, int column) const { return at(kDuu, row, column); }
    [[nodiscard]] Vector duv(int row, int column) const { return at(kDuv, row, column); }
    [[nodiscard]] Vector dvv(int row, int column) const { return at(kDvv, row, column); }
    [[nodiscard]] Vector normal(int row, int column) const { return at(kNormal, row, column); }

    enum Field : std::uint8_t { kPosition, kDu, kDv, kDuu, kDuv, kDvv, kNormal, kFieldCount };
    [[nodiscard]] bool has(Field field) const { return planes_[field] >= 0; }
    // Component 0 .. 2 of a field: rows() * stride() numbers.
    [[nodiscard]] std::span<const Real> plane(Field field, int component) const;
    [[nodiscard]] std::span<Real> plane(Field field, int component);

    [[nodiscard]] size_t bytes() const
    {
        return planeSize() * static_cast<size_t>(planeCount_) * sizeof(Real);
    }

    // Makes room; what was there is lost.
    void resize(int rows, int columns, SampleFields fields, const Vec3& origin);

private:
    [[nodiscard]] Vector at(Field field, int row, int column) const
    {
        const size_t index = static_cast<size_t>(row) * stride_ + static_cast<size_t>(column);
        return {plane(field, 0)[index], plane(field, 1)[index], plane(field, 2)[index]};
    }

    // An odd number of cache lines, so that the planes' rows fall into different parts of the cache.
    [[nodiscard]] size_t planeSize() const
    {
        constexpr size_t kLine = 64 / sizeof(Real);
        return (static_cast<size_t>(rows_) * stride_ / kLine | 1) * kLine;
    }

    int rows_ = 0;
    int columns_ = 0;
    size_t stride_ = 0;
    Vec3 origin_{};
    int planeCount_ = 0;
    int planes_[kFieldCount] = {-1, -1, -1, -1, -1, -1, -1};
    struct Release {
        void operator()(Real* memory) const;
    };
    std::unique_ptr<Real[], Release> memory_;
    size_t capacity_ = 0;
};

enum class Threads : std::uint8_t { one, all };

template <class Real>
struct PreparedSurface;

// A surface made ready for evaluation: its control points and their differences. Costs about as much as
// evaluating as many points; keep it while the surface stays the same. Float only takes spans and weights
// whose figures are within its range of 1e±38.
template <class Real>
class GridEvaluator {
public:
    GridEvaluator(const NurbsSurface& surface, SampleFields fields);
    ~GridEvaluator();
    GridEvaluator(GridEvaluator&&) noexcept;
    GridEvaluator& operator=(GridEvaluator&&) noexcept;

    [[nodiscard]] const Vec3& origin() const;

    // Every u with every v. Any order is right, parameters that grow are fastest: neighbouring v that are
    // many spans apart cost time and memory for all the spans between.
    void evaluate(std::span<const SpanParameter> u, std::span<const SpanParameter> v,
                  GridSamples<Real>& samples, Threads threads = Threads::all) const;

    // The k-th u with the k-th v: one row of samples.
    void evaluateScattered(std::span<const SpanParameter> u, std::span<const SpanParameter> v,
                           GridSamples<Real>& samples, Threads threads = Threads::all) const;

    // The same as a shader does it: basis functions and their slopes by one of its evaluators, in Real. For
    // measurements; for fields up to first derivatives and normals.
    void evaluateScatteredBy(Evaluator evaluator, std::span<const SpanParameter> u,
                             std::span<const SpanParameter> v, GridSamples<Real>& samples,
                             Threads threads = Threads::all) const;

private:
    std::unique_ptr<PreparedSurface<Real>> prepared_;
};

}  // namespace knotspan
