#include "model/formats/obj_elements.h"

#include "model/formats/obj_range.h"

namespace knotspan::formats {

namespace {

// Bezier pieces that share their end points are a B-spline whose inner knots stand `degree` times.
Result<KnotVector> bezierKnots(int degree, const std::vector<double>& joints, size_t mostPoints)
{
    const auto order = static_cast<size_t>(degree) + 1;
    if (joints.size() < 2)
        return failure("A Bezier curve or surface needs two parameters or more in each direction");
    // Before the knots take memory.
    if ((joints.size() - 1) * (order - 1) >= mostPoints)
        return failure(std::to_string(joints.size() - 1) + " Bezier pieces of degree " +
                       std::to_string(degree) + " need more than its " + std::to_string(mostPoints) +
                       " control points");
    std::vector<double> knots(1, joints.front());
    for (size_t k = 0; k < joints.size(); ++k) {
        if (k > 0 && !(joints[k - 1] < joints[k]))
            return failure("Parameter " + std::to_string(k) + " is not above the one before it");
        knots.insert(knots.end(), order - 1, joints[k]);
    }
    knots.push_back(joints.back());
    return KnotVector::create(degree, std::move(knots));
}

Result<KnotVector> knotsOf(const ObjElement& element, bool alongU)
{
    const int degree = alongU ? element.basis.degreeU : element.basis.degreeV;
    const std::vector<double>& parameters = alongU ? element.parametersU : element.parametersV;
    if (degree < kMinDegree || degree > kMaxDegree)
        return failure("Its degree (deg) along " + std::string(alongU ? "u" : "v") + " is not from " +
                       std::to_string(kMinDegree) + " to " + std::to_string(kMaxDegree));
    if (parameters.empty())
        return failure("Its parameters along " + std::string(alongU ? "u (parm u)" : "v (parm v)") +
                       " are missing");
    return element.basis.bezier ? bezierKnots(degree, parameters, element.points.size())
                                : KnotVector::create(degree, parameters);
}

Result<NurbsSurface> wholeSurfaceOf(const ObjElement& element, const std::vector<ControlPoint>& vertices)
{
    auto knotsU = knotsOf(element, true);
    if (!knotsU)
        return tl::unexpected(knotsU.error());
    auto knotsV = knotsOf(element, false);
    if (!knotsV)
        return tl::unexpected(knotsV.error());
    const auto countU = static_cast<size_t>(knotsU->controlPointCount());
    const auto countV = static_cast<size_t>(knotsV->controlPointCount());
    if (element.points.size() % countU != 0 || element.points.size() / countU != countV)
        return failure("Its parameters ask for " + std::to_string(countU) + " x " + std::to_string(countV) +
                       " control points, but there are " + std::to_string(element.points.size()));
    std::vector<ControlPoint> points(element.points.size());
    for (size_t i = 0; i < countU; ++i) {
        for (size_t j = 0; j < countV; ++j) {
            ControlPoint& point = points[i * countV + j];
            point = vertices[element.points[j * countU + i]];
            point.weight = element.basis.rational ? point.weight : 1.0;
        }
    }
    return NurbsSurface::create(*std::move(knotsU), *std::move(knotsV), std::move(points));
}

}  // namespace

Result<NurbsSurface> surfaceOf(const ObjElement& element, const std::vector<ControlPoint>& vertices)
{
    auto whole = wholeSurfaceOf(element, vertices);
    if (!whole)
        return whole;
    const auto u = rangeIn(whole->knotsU(), {element.startU, element.endU});
    if (!u)
        return tl::unexpected(u.error());
    const auto v = rangeIn(whole->knotsV(), {element.startV, element.endV});
    if (!v)
        return tl::unexpected(v.error());
    return partOf(*whole, *u, *v);
}

Result<TrimCurve> trimCurveOf(const ObjElement& element, const std::vector<TrimPoint>& parameterPoints)
{
    auto knots = knotsOf(element, true);
    if (!knots)
        return tl::unexpected(knots.error());
    std::vector<TrimPoint> points;
    points.reserve(element.points.size());
    for (const std::uint32_t index : element.points) {
        const TrimPoint& point = parameterPoints[index];
        points.push_back({point.position, element.basis.rational ? point.weight : 1.0});
    }
    return TrimCurve::create(*std::move(knots), std::move(points));
}

}  // namespace knotspan::formats
