#include "model/sculpting/net_directions.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/grid_evaluation.h"

namespace knotspan {

namespace {

// From so many on preparing the whole surface for fast evaluation is worth it.
constexpr size_t kMany = 500;

Vec3 unitOrZero(const Vec3& vector)
{
    const double length = glm::length(vector);
    return length > 0 ? vector / length : Vec3(0);
}

std::vector<Vec3> manyNormals(const NurbsSurface& surface, const std::vector<double>& u,
                              const std::vector<double>& v)
{
    const GridEvaluator<double> evaluator(surface, {.derivatives = 1, .normals = true});
    GridSamples<double> samples;
    evaluator.evaluateScattered(spanParameters(surface.knotsU(), u), spanParameters(surface.knotsV(), v),
                                samples);
    std::vector<Vec3> normals;
    for (size_t k = 0; k < u.size(); ++k)
        normals.push_back(samples.normal(0, static_cast<int>(k)));
    return normals;
}

}  // namespace

double grevilleParameter(const KnotVector& knots, int k)
{
    // From the first of them, so that a knot that stands there degree times is met exactly.
    const double first = knots[k + 1];
    double beyond = 0;
    for (int r = 2; r <= knots.degree(); ++r)
        beyond += knots[k + r] - first;
    return knots.inDomain(first + beyond / knots.degree());
}

Vec3 directionAlongNet(const SceneObject& object, const NetNeighbours& neighbours, ControlPointIndex index,
                       Direction direction)
{
    const ControlPointIndex at = neighbours.first(index);
    const ControlPointIndex before = neighbours.previous(at, direction).value_or(at);
    const ControlPointIndex after = neighbours.next(at, direction).value_or(at);
    const Vec3 way = object.surface.controlPoint(after.i, after.j).position -
                     object.surface.controlPoint(before.i, before.j).position;
    const double near = 1e-9 * object.surface.bounds().diagonal();
    return glm::length(way) > near ? unitOrZero(glm::dmat3(object.transform) * way) : Vec3(0);
}

std::vector<Vec3> normalsAt(const SceneObject& object, const NetNeighbours& neighbours,
                            const std::vector<ControlPointIndex>& points)
{
    const NurbsSurface& surface = object.surface;
    std::vector<double> u;
    std::vector<double> v;
    for (const ControlPointIndex index : points) {
        const ControlPointIndex at = neighbours.first(index);
        u.push_back(grevilleParameter(surface.knotsU(), at.i));
        v.push_back(grevilleParameter(surface.knotsV(), at.j));
    }
    std::vector<Vec3> normals;
    if (points.size() >= kMany)
        normals = manyNormals(surface, u, v);
    else
        for (size_t k = 0; k < points.size(); ++k)
            normals.push_back(evaluateNormal(surface, u[k], v[k]).direction);
    if (object.transform == Mat4(1.0))
        return normals;
    const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(object.transform)));
    for (Vec3& normal : normals)
        normal = unitOrZero(turn * normal);
    return normals;
}

}  // namespace knotspan
