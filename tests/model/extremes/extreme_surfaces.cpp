#include "tests/model/extremes/extreme_surfaces.h"

#include <cmath>
#include <functional>
#include <random>

#include "model/geometry/knot_insertion.h"
#include "model/geometry/primitives.h"

namespace knotspan::testing {

namespace {

using Knots = std::vector<double>;

KnotVector clamped(int degree, const Knots& interior, double start, double end)
{
    Knots knots(static_cast<size_t>(degree) + 1, start);
    knots.insert(knots.end(), interior.begin(), interior.end());
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, end);
    return KnotVector::create(degree, std::move(knots)).value();
}

// Long and short spans by turns, so that every evaluation sees both.
KnotVector uneven(int degree, int spans, double ratio, double start = 0)
{
    Knots interior;
    double at = start;
    for (int k = 0; k < spans; ++k) {
        at += k % 3 == 1 ? 1 / ratio : k % 3 == 0 ? 1 : 1 / std::sqrt(ratio);
        interior.push_back(at);
    }
    interior.pop_back();
    return clamped(degree, interior, start, at);
}

// Interior knots of multiplicity 1, 2, ..., degree.
KnotVector everyMultiplicity(int degree)
{
    Knots interior;
    for (int m = 1; m <= degree; ++m)
        interior.insert(interior.end(), static_cast<size_t>(m), m);
    return clamped(degree, interior, 0, degree + 1);
}

KnotVector unclamped(int degree, int spans, const std::function<double(int)>& length)
{
    Knots knots{0};
    for (int k = 1; k <= spans + 2 * degree; ++k)
        knots.push_back(knots.back() + length(k));
    return KnotVector::create(degree, std::move(knots)).value();
}

NurbsSurface surfaceOf(const KnotVector& u, const KnotVector& v,
                       const std::function<ControlPoint(int, int)>& point)
{
    std::vector<ControlPoint> points;
    for (int i = 0; i < u.controlPointCount(); ++i)
        for (int j = 0; j < v.controlPointCount(); ++j)
            points.push_back(point(i, j));
    return NurbsSurface::create(u, v, std::move(points)).value();
}

NurbsSurface changed(const NurbsSurface& surface, const std::function<ControlPoint(ControlPoint)>& change)
{
    return surfaceOf(surface.knotsU(), surface.knotsV(),
                     [&](int i, int j) { return change(surface.controlPoint(i, j)); });
}

NurbsSurface scaled(const NurbsSurface& surface, double scale)
{
    return changed(surface, [&](ControlPoint p) { return ControlPoint{p.position * scale, p.weight}; });
}

NurbsSurface moved(const NurbsSurface& surface, const Vec3& by)
{
    return changed(surface, [&](ControlPoint p) { return ControlPoint{p.position + by, p.weight}; });
}

// About 1 x 1 x 0.5, its control points off their places; weights over `weightOrders` orders of ten.
NurbsSurface rough(const KnotVector& u, const KnotVector& v, double weightOrders = 0, unsigned seed = 1)
{
    std::mt19937 random(seed);
    const auto between = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    const double countU = u.controlPointCount();
    const double countV = v.controlPointCount();
    return surfaceOf(u, v, [&](int i, int j) -> ControlPoint {
        const double x = (i + between(-0.4, 0.4)) / countU - 0.5;
        const double y = (j + between(-0.4, 0.4)) / countV - 0.5;
        const double z = between(-0.25, 0.25);
        return {{x, y, z},
                weightOrders > 0 ? std::pow(10.0, between(-weightOrders / 2, weightOrders / 2)) : 1.0};
    });
}

// A gentle hill over [0, 1] x [0, 1], on which nothing happens however it is cut into spans.
NurbsSurface hill(int degreeU, int degreeV, bool rational)
{
    const KnotVector u = KnotVector::clampedUniform(degreeU, 2);
    const KnotVector v = KnotVector::clampedUniform(degreeV, 2);
    return surfaceOf(u, v, [&](int i, int j) -> ControlPoint {
        const double x = static_cast<double>(i) / (u.controlPointCount() - 1);
        const double y = static_cast<double>(j) / (v.controlPointCount() - 1);
        return {{x, y, 0.3 * std::sin(3 * x) * std::cos(2 * y)}, rational ? 1 + 0.5 * x + 0.3 * x * y : 1.0};
    });
}

// With degree + 2 more knots `length` apart: the control points of the short spans nearly coincide.
NurbsSurface withShortSpans(NurbsSurface surface, Direction direction, double length)
{
    const int degree = direction == Direction::U ? surface.degreeU() : surface.degreeV();
    for (int k = 0; k < degree + 2; ++k)
        surface = withKnotInserted(surface, direction, 0.3 + k * length);
    return surface;
}

class Table {
public:
    ExtremeSurface& add(const std::string& name, NurbsSurface surface)
    {
        rows.push_back({.name = name, .surface = std::move(surface), .reason = ""});
        return rows.back();
    }
    std::vector<ExtremeSurface> rows;
};

void addDegrees(Table& table)
{
    for (int degree = kMinDegree; degree <= kMaxDegree; ++degree)
        table.add("degree " + std::to_string(degree) + " x " + std::to_string(16 - degree),
                  rough(uneven(degree, 3, 4), uneven(16 - degree, 2, 4), 1.4));
    table.add("degree 15 x 15, polynomial", rough(uneven(15, 1, 1), uneven(15, 1, 1)));
    table.add("degree 15 x 15, weights 1e8", rough(uneven(15, 2, 10), uneven(15, 1, 1), 8));
}

void addWeights(Table& table)
{
    for (const int degree : {2, 3, 5, 9})
        table.add("weights 1e8, degree " + std::to_string(degree),
                  rough(uneven(degree, 4, 3), uneven(3, 4, 3), 8));
    const KnotVector cubic = uneven(3, 4, 2);
    const NurbsSurface even = rough(cubic, cubic);
    table.add("weights 1e-4 and 1e4 by turns", surfaceOf(cubic, cubic, [&](int i, int j) -> ControlPoint {
                  return {even.controlPoint(i, j).position, (i + j) % 2 ? 1e4 : 1e-4};
              }));
    auto& heavy = table.add("one weight of 1e8", surfaceOf(cubic, cubic, [&](int i, int j) -> ControlPoint {
                                return {even.controlPoint(i, j).position, i == 3 && j == 3 ? 1e8 : 1};
                            }));
    heavy.fast = {4, 1e-8, 1e-8, 1e-8, 1e-8};
    heavy.fastFloat = {16, 3, 3, 1e-5, 1e-6};
    heavy.reason =
        "the surface stays within 1e-8 of the heavy point, which only the reference takes as origin";
    table.add("one weight of 1e-8", surfaceOf(cubic, cubic, [&](int i, int j) -> ControlPoint {
                  return {even.controlPoint(i, j).position, i == 3 && j == 3 ? 1e-8 : 1};
              }));
    table.add("bilinear, weights 1 and 1e8",
              surfaceOf(uneven(1, 1, 1), uneven(1, 1, 1), [&](int i, int j) -> ControlPoint {
                  return {{i, j, i * j}, i == j ? 1e8 : 1};
              }));
}

void addSpans(Table& table)
{
    for (const double ratio : {1e3, 1e6, 1e9})
        for (const int degree : {1, 3, 5, 9}) {
            const std::string orders = std::to_string(static_cast<int>(std::log10(ratio) + 0.5));
            table.add("spans 1e" + orders + ", degree " + std::to_string(degree),
                      rough(uneven(degree, 7, ratio), uneven(3, 4, ratio), degree > 3 ? 1.4 : 0));
        }
    for (const int degree : {2, 3, 5, 9})
        table.add("every multiplicity, degree " + std::to_string(degree),
                  rough(everyMultiplicity(degree), everyMultiplicity(3), degree > 2 ? 1.4 : 0));
    table.add("knots one rounding apart",
              rough(clamped(4, {0.5, std::nextafter(0.5, 1), std::nextafter(0.5, 1) + 0x1p-53}, 0, 1),
                    uneven(3, 3, 2)));
    const auto evenly = [](int) { return 1.0; };
    const auto randomly = [](int k) { return std::pow(10.0, -(k * 7 % 5)); };
    table.add("unclamped, degree 3", rough(unclamped(3, 5, evenly), unclamped(2, 4, evenly)));
    table.add("unclamped, degree 7, rational", rough(unclamped(7, 5, evenly), unclamped(3, 4, evenly), 1.4));
    table.add("unclamped, uneven, degree 9", rough(unclamped(9, 7, randomly), unclamped(5, 6, randomly), 2));
    table.add("knots from 1e6, degree 3", rough(uneven(3, 5, 10, 1e6), uneven(3, 3, 10, -1e6)));
    table.add("knots from 1e6, spans 1e6, degree 9",
              rough(uneven(9, 4, 1e6, 1e6), uneven(5, 3, 10, 1e6), 1.4));
    table.add("domain of 1e-12", rough(clamped(3, {-3e-13, 1e-13}, -1e-12, 1e-12), uneven(3, 2, 2), 1.4));
    table.add("domain of 1e12", rough(clamped(3, {1e11, 7e11}, 0, 1e12), uneven(3, 2, 2), 1.4));
}

// Closed: the first `degree` control points again at the end, the knot spans as well.
void addPeriodic(Table& table)
{
    const int degree = 3;
    const int distinct = 7;
    const KnotVector around = unclamped(degree, distinct, [](int k) { return 0.5 + (k % distinct) * 0.25; });
    const KnotVector along = uneven(2, 3, 3);
    for (const bool rational : {false, true})
        table.add(
            rational ? "periodic, rational" : "periodic",
            surfaceOf(around, along, [&](int i, int j) -> ControlPoint {
                const int k = i % distinct;
                const double angle = 2 * 3.14159265358979 * k / distinct;
                return {{std::cos(angle), std::sin(angle), 0.5 * j + 0.1 * k}, rational ? 1 + 0.3 * k : 1.0};
            }));
}

void addPlaces(Table& table)
{
    const NurbsSurface part = rough(uneven(3, 4, 3), uneven(4, 3, 3), 1);
    table.add("coordinates of 1e-9", scaled(part, 1e-9));
    table.add("coordinates of 1e12", scaled(part, 1e12));
    table.add("unit part at 1e7", moved(part, {1e7, -1e7, 1e7}));
    table.add("part of 0.01 at 1e7", moved(scaled(part, 0.01), {-1e7, 1e7, 1e7}));
    table.add("part of 1 at 1e12", moved(part, {1e12, -1e12, 1e12}));
    table.add("degree 9, weights 1e8, spans 1e6, at 1e7",
              moved(rough(uneven(9, 4, 1e6), uneven(9, 2, 1e6), 8), {1e7, -1e7, 1e7}));
}

void addShapes(Table& table)
{
    table.add("sphere", sphere({0, 0, 0}, 1));
    table.add("sphere of 1e-6 at 1e3", sphere({1e3, 1e3, 1e3}, 1e-6));
    auto& thin = table.add("thin torus", torus({0, 0, 0}, 1e3, 1e-3));
    thin.reference = {4, 1e-11, 3e-11, 1e-11, 1e-9};
    thin.fast = {4, 1e-10, 3e-10, 1e-10, 1e-8};
    thin.fastFloat = {16, 0.1, 0.2, 1e-5, 1e-6};
    thin.reason =
        "weights differ across the tube, so that a millionth of the size is what is left of sums of "
        "coordinates round the ring";
    const KnotVector cubic = uneven(3, 2, 2);
    const NurbsSurface even = rough(cubic, cubic);
    const auto named = [&](const char* name, const std::function<Vec3(int, int)>& position,
                           double orders = 0) {
        table.add(name, surfaceOf(cubic, cubic, [&](int i, int j) -> ControlPoint {
                      return {position(i, j), std::pow(10.0, orders * ((i * 3 + j) % 5) / 5)};
                  }));
    };
    const auto at = [&](int i, int j) { return even.controlPoint(i, j).position; };
    named("cone's apex", [&](int i, int j) { return at(i, j) * static_cast<double>(j); });
    named(
        "cone's apex, rational", [&](int i, int j) { return at(i, j) * static_cast<double>(j); }, 2);
    named("both ends of an edge are poles",
          [&](int i, int j) { return i == 0 || i == 4 ? Vec3(i, 0, 0) : at(i, j) + Vec3(i, 0, 0); });
    named("coincident control points", [&](int i, int j) { return at(i == 2 ? 1 : i, j == 3 ? 2 : j); });
    named("doubled first row", [&](int i, int j) { return at(i == 1 ? 0 : i, j); });
    named("four control points in one", [&](int i, int j) { return at(i < 2 ? 0 : i, j < 2 ? 0 : j); });
    named("sliver", [&](int i, int j) { return at(i, j) * Vec3(1, 1e-9, 1e-9); });
    named(
        "sliver, rational", [&](int i, int j) { return at(i, j) * Vec3(1e6, 1, 1e-6); }, 4);
    named("folded net", [&](int i, int j) { return at(i ^ 1, j == 1 ? 3 : j == 3 ? 1 : j); });
    named("folded on itself", [&](int i, int j) { return at(i < 3 ? i : 4 - i, j); });
    named("on a line", [&](int i, int j) { return Vec3(1, 2, 3) * (i + 0.2 * j); });
    named("on a point", [&](int, int) { return Vec3(1, 2, 3); });
}

void addLargeNets(Table& table)
{
    table.add("500 x 500", rough(KnotVector::clampedUniform(3, 497), KnotVector::clampedUniform(3, 497)));
    auto& uneven500 =
        table.add("500 x 500, rational, uneven", rough(uneven(5, 495, 1e3), uneven(3, 497, 1e2), 2));
    uneven500.fastFloat = {16, 2e-4, 1e-4, 1e-5, 1e-6};
    uneven500.reason = "a KSQuad is 500 times smaller than its distance from the origin, and weights differ";
}

void addShortSpans(Table& table)
{
    for (const double length : {1e-3, 1e-6, 1e-9})
        for (const int degree : {2, 3, 5, 9}) {
            const std::string name = "inserted spans of 1e" +
                                     std::to_string(static_cast<int>(std::log10(length) - 0.5)) +
                                     ", degree " + std::to_string(degree);
            table.add(name, withShortSpans(hill(degree, 3, false), Direction::U, length));
            table.add(name + ", rational, both ways",
                      withShortSpans(withShortSpans(hill(degree, 3, true), Direction::U, length),
                                     Direction::V, length));
        }
}

// Beyond what is asked for: nothing here may leave evaluation as NaN.
void addRangeOfDouble(Table& table)
{
    const NurbsSurface part = rough(uneven(3, 3, 3), uneven(3, 3, 3), 1);
    table.add("coordinates of 1e-300", scaled(part, 1e-300));
    auto& denormal = table.add("coordinates of 1e-315", scaled(part, 1e-315));
    denormal.reference = {4, 1e-7, 1e-7, 1e-7, 1e-9};
    denormal.reason = "denormal coordinates have 8 digits";
    table.add("coordinates of 1e300", scaled(part, 1e300));
    table.add("coordinates of 4e307", scaled(part, 8e307));
    table.add("weights of 1e300", changed(part, [](ControlPoint p) {
                  return ControlPoint{p.position, p.weight * 1e300};
              }));
    table.add("weights of 1e-300", changed(part, [](ControlPoint p) {
                  return ControlPoint{p.position, p.weight * 1e-300};
              }));
    auto& uneasy = table.add("weights over 600 orders", rough(uneven(3, 3, 3), uneven(3, 3, 3), 600));
    uneasy.onlyFinite = true;
    uneasy.reason = "the derivatives of hundreds of orders are not representable, nor do 50 digits tell them";
    table.add("spans of 5e-310 and 1", rough(clamped(2, {5e-310}, 0, 1), uneven(2, 2, 2)));
    table.add("spans of 1e-300 and 1e10", rough(clamped(3, {1e-300}, 0, 1e10), uneven(2, 2, 2)));
    auto& vast = table.add("coordinates of 1e300, weights 1e8",
                           scaled(rough(clamped(2, {0.5, 0.5}, 0, 1), uneven(3, 3, 3), 8), 1e300));
    vast.onlyFinite = true;
    vast.reason = "derivatives are beyond the range";
    auto& steep = table.add("coordinates of 1e12, weights 1e8, spans 1e9",
                            scaled(rough(uneven(3, 4, 1e9), uneven(3, 3, 1e9), 8), 1e12));
    steep.onlyFinite = true;
    steep.reason = "float cannot hold its second derivatives";
    table.add("domain of 1e-300", rough(clamped(3, {1e-301, 3e-301}, 0, 1e-300), uneven(3, 3, 3)));
    table.add("domain of 1e300", rough(clamped(3, {1e299, 3e299}, 0, 1e300), uneven(3, 3, 3)));
}

}  // namespace

const std::vector<ExtremeSurface>& extremeSurfaces()
{
    static const std::vector<ExtremeSurface> rows = [] {
        Table table;
        addDegrees(table);
        addWeights(table);
        addSpans(table);
        addPeriodic(table);
        addPlaces(table);
        addShapes(table);
        addLargeNets(table);
        addShortSpans(table);
        addRangeOfDouble(table);
        return table.rows;
    }();
    return rows;
}

}  // namespace knotspan::testing
