#include "model/friends/meeting_forms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "model/analysis/bezier_curves.h"

namespace knotspan {

namespace {

Vectors vectorsOf(const std::vector<Vec4>& row)
{
    Vectors result(row.size());
    for (size_t k = 0; k < row.size(); ++k)
        result[k] = Vec3(row[k]);
    return scaledOf(std::move(result));
}

Scalars weightsOf(const std::vector<Vec4>& row)
{
    Scalars result(row.size());
    for (size_t k = 0; k < row.size(); ++k)
        result[k] = row[k].w;
    return scaledOf(std::move(result));
}

std::vector<Vec4> derivative(const std::vector<Vec4>& row)
{
    const size_t degree = row.size() - 1;
    if (degree == 0)
        return {Vec4(0)};
    std::vector<Vec4> result(degree);
    for (size_t k = 0; k < degree; ++k)
        result[k] = static_cast<double>(degree) * (row[k + 1] - row[k]);
    return result;
}

bool hasUnitWeights(const std::vector<Vec4>& row)
{
    return std::all_of(row.begin(), row.end(), [](const Vec4& point) { return point.w == 1.0; });
}

Form formOf(const Vectors& vectors, const Scalars& scalars)
{
    const size_t degree = std::max(vectors.size(), scalars.size()) - 1;
    const Vectors v = raised(vectors, degree);
    const Scalars s = raised(scalars, degree);
    const auto& factors = binomials(static_cast<int>(degree));
    Form form(degree + 1);
    for (size_t k = 0; k <= degree; ++k)
        form[k] = Vec4(v[k], s[k]) / factors[k];
    return form;
}

// The plane through the edge and the direction into the surface at each point: n . q + offset q.w = 0.
struct Plane {
    Vectors normal;
    Scalars offset;  // only where rational
};

Plane planeOf(const EdgeRows& rows)
{
    const Vectors at = vectorsOf(rows.at);
    const std::vector<Vec4> changes = derivative(rows.at);
    const Vectors change = vectorsOf(changes);
    const Vectors into = vectorsOf(rows.into);
    const Vectors straight = cross(change, into);
    if (!rows.rational)
        return {straight, {}};
    // The spatial part of X ^ X' ^ Y.
    Plane plane;
    plane.normal = difference(weightsOf(rows.at) * straight, weightsOf(rows.into) * cross(change, at));
    plane.normal = difference(plane.normal, weightsOf(changes) * cross(at, into));
    plane.offset = dot(straight, at);
    for (double& value : plane.offset)
        value = -value;
    return plane;
}

Scalars height(const Plane& plane, const std::vector<Vec4>& row)
{
    const Scalars straight = dot(plane.normal, vectorsOf(row));
    return plane.offset.empty() ? straight : sum(straight, plane.offset * weightsOf(row));
}

// w^2 times the tangent of rows.at: of one degree less than the quotient rule has it, as its first terms
// cancel.
Vectors tangentOf(const std::vector<Vec4>& at, bool rational)
{
    if (!rational)
        return vectorsOf(derivative(at));
    const std::vector<Vec4> low(at.begin(), at.end() - 1);
    const std::vector<Vec4> high(at.begin() + 1, at.end());
    Vectors result = difference(weightsOf(low) * vectorsOf(high), weightsOf(high) * vectorsOf(low));
    for (Vec3& value : result)
        value *= static_cast<double>(low.size());
    return result;
}

// w^2 times the derivative into the surface.
Vectors intoOf(const EdgeRows& rows)
{
    if (!rows.rational)
        return vectorsOf(rows.into);
    return difference(weightsOf(rows.at) * vectorsOf(rows.into), weightsOf(rows.into) * vectorsOf(rows.at));
}

double largest(const std::vector<Vec4>& row)
{
    double size = 0;
    for (const Vec4& point : row)
        size = std::max(size, glm::length(Vec3(point)));
    return size;
}

// How many of the first and of the last coefficients are no more than `least`, in the Bernstein basis.
struct Vanishing {
    size_t first = 0;
    size_t last = 0;
};

template <class T, class Size>
Vanishing vanishing(const Poly<T>& poly, double least, const Size& size)
{
    const auto& factors = binomials(static_cast<int>(poly.size()) - 1);
    const auto vanishes = [&](size_t k) { return size(poly[k]) / factors[k] <= least; };
    Vanishing result;
    while (result.first < poly.size() && vanishes(result.first))
        ++result.first;
    while (result.first + result.last < poly.size() && vanishes(poly.size() - 1 - result.last))
        ++result.last;
    return result;
}

// Divided by t^first (1 - t)^last: in scaled coefficients, to leave them out.
template <class T>
Poly<T> divided(const Poly<T>& poly, const Vanishing& ends)
{
    return {poly.begin() + static_cast<std::ptrdiff_t>(ends.first),
            poly.end() - static_cast<std::ptrdiff_t>(ends.last)};
}

// Where the normal itself is no more than rounding.
Vanishing vanishingNormal(const EdgeRows& rows, const Vectors& normal, double noise)
{
    const double change = largest(derivative(rows.at));
    const double into = largest(rows.into);
    const double least = 1e-12 * change * into + noise * (change + into);
    return vanishing(normal, least, [](const Vec3& value) { return glm::length(value); });
}

// The normal curvature perpendicular to the edge is bend / (speed |n|^3).
struct Across {
    Vectors normal;
    Scalars square;  // |n|^2
    Scalars speed;   // |C'|^2
    Scalars bend;
};

// Nothing where curvature has no limit at an end where the normal vanishes.
std::optional<Across> acrossOf(const EdgeRows& rows, double noise)
{
    const Plane plane = planeOf(rows);
    const Vectors tangent = tangentOf(rows.at, rows.rational);
    const std::vector<Vec4> change = derivative(rows.at);
    Across result;
    result.speed = dot(tangent, tangent);
    const Scalars& e = result.speed;
    const Scalars f = dot(tangent, intoOf(rows));
    // The second fundamental form (L, M, N) on e S_s - f S_t, which is perpendicular to the edge.
    const Scalars l = height(plane, derivative(change));
    const Scalars m = height(plane, derivative(rows.into));
    const Scalars n = height(plane, rows.bend);
    const Scalars inner = sum(f * l, e * m, -2);
    result.bend = sum(f * inner, e * (e * n));
    if (rows.rational)
        result.bend = weightsOf(rows.at) * result.bend;
    // Of a limit, the bend has the normal's zeros three times.
    const Vanishing ends = vanishingNormal(rows, plane.normal, noise);
    const auto size = [](double value) { return std::abs(value); };
    const Scalars values = bernsteinOf(result.bend);
    const double most = std::abs(*std::max_element(
        values.begin(), values.end(), [](double x, double y) { return std::abs(x) < std::abs(y); }));
    const Vanishing zeros = vanishing(result.bend, 1e-10 * most, size);
    if (most > 0 && (zeros.first < 3 * ends.first || zeros.last < 3 * ends.last))
        return std::nullopt;
    if (ends.first + ends.last >= plane.normal.size())
        return std::nullopt;
    result.normal = divided(plane.normal, ends);
    result.square = dot(result.normal, result.normal);
    result.bend = divided(result.bend, {3 * ends.first, 3 * ends.last});
    return result;
}

}  // namespace

Form gapForm(const std::vector<Vec4>& a, const std::vector<Vec4>& b)
{
    if (hasUnitWeights(a) && hasUnitWeights(b))
        return formOf(difference(vectorsOf(b), vectorsOf(a)), Scalars{1.0});
    const Scalars weightA = weightsOf(a);
    const Scalars weightB = weightsOf(b);
    return formOf(difference(weightA * vectorsOf(b), weightB * vectorsOf(a)), weightA * weightB);
}

double gapBound(const Form& form)
{
    double bound = 0;
    for (const Vec4& figures : form)
        bound = std::max(bound, glm::length(Vec3(figures)) / figures.w);
    return bound;
}

// Along the way in the middle.
double leastGap(const Form& form)
{
    const Vec3 way = Vec3(form.front()) + Vec3(form[form.size() / 2]) + Vec3(form.back());
    const double size = glm::length(way);
    double least = std::numeric_limits<double>::infinity();
    for (const Vec4& figures : form)
        least = std::min(least, size > 0 ? glm::dot(Vec3(figures), way) / size / figures.w : 0.0);
    return least;
}

double slipBound(const std::vector<Vec4>& a, const std::vector<Vec4>& b)
{
    const bool rational = !hasUnitWeights(a) || !hasUnitWeights(b);
    const Vectors tangent = tangentOf(b, rational);
    const Vec3 axis = pointOf(b.back()) - pointOf(b.front());
    const Vectors way = rational ? difference(weightsOf(a) * vectorsOf(b), weightsOf(b) * vectorsOf(a))
                                 : difference(vectorsOf(b), vectorsOf(a));
    const Scalars along = dot(way, tangent);
    Scalars speed = dot(Vectors{axis / glm::length(axis)}, tangent);
    if (rational)
        speed = (weightsOf(a) * weightsOf(b)) * speed;
    const size_t degree = std::max(along.size(), speed.size()) - 1;
    const Scalars numerator = raised(along, degree);
    const Scalars denominator = raised(speed, degree);
    double bound = 0;
    for (size_t k = 0; k <= degree; ++k) {
        if (!(denominator[k] > 0))
            return std::numeric_limits<double>::infinity();
        bound = std::max(bound, std::abs(numerator[k]) / denominator[k]);
    }
    return bound;
}

Vectors normalForm(const EdgeRows& rows, const EdgeEnds& ends, double noise)
{
    const Vectors normal = planeOf(rows).normal;
    const Vanishing zeros = vanishingNormal(rows, normal, noise);
    if ((zeros.first > 0 && !ends.first) || (zeros.last > 0 && !ends.last))
        return {};
    Vectors result = divided(normal, zeros);
    double size = 0;
    for (const Vec3& value : result)
        size = std::max({size, std::abs(value.x), std::abs(value.y), std::abs(value.z)});
    if (!(size > 0) || !std::isfinite(size))
        return {};
    // So that products of tiny or huge ones stay in the range of double.
    for (Vec3& value : result)
        value /= size;
    return result;
}

Form angleForm(const Vectors& a, const Vectors& b)
{
    Form form = formOf(cross(a, b), dot(a, b));
    double size = 0;
    for (const Vec4& figures : form)
        size = std::max(size, glm::length(figures));
    for (Vec4& figures : form)
        figures /= -size;
    return form;
}

double angleAt(const Vec4& figures)
{
    constexpr double kRounding = 1e-13;
    if (!(glm::length(figures) > kRounding))
        return 0;
    return std::atan2(glm::length(Vec3(figures)), figures.w);
}

double angleBound(const Form& form)
{
    double tangent = 0;
    bool acute = true;
    for (const Vec4& figures : form) {
        acute = acute && figures.w > 0;
        tangent = std::max(tangent, glm::length(Vec3(figures)) / figures.w);
    }
    if (acute)
        return std::atan(tangent);
    // Obtuse: the cotangent is no less than that of the angle as seen along one axis.
    const Vec3 axis = Vec3(form.front()) + Vec3(form[form.size() / 2]) + Vec3(form.back());
    const double size = glm::length(axis);
    double cotangent = 0;
    for (const Vec4& figures : form) {
        const double sine = glm::dot(Vec3(figures), axis);
        if (!(sine > 0))
            return std::numbers::pi;
        cotangent = std::min(cotangent, figures.w * size / sine);
    }
    return std::atan2(1.0, cotangent);
}

std::optional<Form> curvatureForm(const EdgeRows& a, const EdgeRows& b, double noise)
{
    const auto ofBoth = std::pair(acrossOf(a, noise), acrossOf(b, noise));
    if (!ofBoth.first || !ofBoth.second)
        return std::nullopt;
    const Across& x = *ofBoth.first;
    const Across& y = *ofBoth.second;
    // b's normal C' x (into b) is the opposite of that which runs on from a; its heights change sign with it.
    const Scalars cosine = dot(x.normal, y.normal);  // minus that of the normals as they run on
    const Scalars ofA = x.speed * x.square;
    const Scalars ofB = y.speed * (y.square * y.square);
    const Scalars bendA = x.bend * ofB;
    const Scalars bendB = (y.bend * cosine) * ofA;  // two changes of sign
    const Scalars scale = ofA * ofB;
    const size_t degree = std::max({bendA.size(), bendB.size(), scale.size()}) - 1;
    const Scalars columns[] = {raised(bendA, degree), raised(bendB, degree), raised(scale, degree),
                               raised(x.square, degree)};
    const auto& factors = binomials(static_cast<int>(degree));
    Form form(degree + 1);
    for (size_t k = 0; k <= degree; ++k)
        form[k] = Vec4(columns[0][k], columns[1][k], columns[2][k], columns[3][k]) / factors[k];
    return form;
}

}  // namespace knotspan
