#include "model/making/object_making.h"

#include <cmath>
#include <set>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/making/numbers.h"

namespace knotspan {

namespace {

constexpr double kPi = 3.14159265358979323846;

struct Turn {
    double cosine;
    double sine;
};

Turn turnOf(double degrees)
{
    const double rest = std::remainder(degrees, 360);
    if (std::remainder(rest, 90) != 0)
        return {std::cos(rest * kPi / 180), std::sin(rest * kPi / 180)};
    if (rest == 0)
        return {1, 0};
    return std::abs(rest) == 180 ? Turn{-1, 0} : Turn{0, rest > 0 ? 1.0 : -1.0};
}

// Turns the axes a and b of what was there before, a towards b.
void turn(glm::dmat3& matrix, int a, int b, double degrees)
{
    const auto [cosine, sine] = turnOf(degrees);
    for (int column = 0; column < 3; ++column) {
        const double x = matrix[column][a];
        const double y = matrix[column][b];
        matrix[column][a] = cosine * x - sine * y;
        matrix[column][b] = sine * x + cosine * y;
    }
}

// What a linear map that keeps `pivot` does, then moved. The difference first: a map that is none leaves 0.
Mat4 about(const Vec3& pivot, const glm::dmat3& linear, const Vec3& translation)
{
    return Mat4(Vec4(linear[0], 0), Vec4(linear[1], 0), Vec4(linear[2], 0),
                Vec4((pivot - linear * pivot) + translation, 1));
}

// "Bow 2" is "Bow" and 2, "Bow" is "Bow" and 1.
std::pair<std::string, int> numberedName(const std::string& name)
{
    const auto space = name.rfind(' ');
    if (space == std::string::npos || space == 0 || name.size() - space - 1 > 6 || space + 1 == name.size() ||
        name[space + 1] == '0' || name.find_first_not_of("0123456789", space + 1) != std::string::npos)
        return {name, 1};
    return {name.substr(0, space), std::stoi(name.substr(space + 1))};
}

}  // namespace

Result<SceneObject> mirrored(const SceneObject& object, const MirrorPlane& plane)
{
    if (auto place = requirePlace("The mirror's point", plane.point); !place)
        return tl::unexpected(place.error());
    const auto normal = requireDirection("The mirror's normal", plane.normal);
    if (!normal)
        return tl::unexpected(normal.error());
    const glm::dmat3 reflection = glm::dmat3(1.0) - 2.0 * glm::outerProduct(*normal, *normal);
    return moved(object, about(plane.point, reflection, Vec3(0)));
}

Result<Mat4> transformMatrix(const TransformNumbers& numbers)
{
    for (const auto& [what, vector] :
         {std::pair("The translation", numbers.translation), std::pair("The pivot", numbers.pivot)})
        if (auto place = requirePlace(what, vector); !place)
            return tl::unexpected(place.error());
    if (!isFinite(numbers.degrees))
        return failure("An angle is not a finite number", "Give three finite numbers");
    for (int k = 0; k < 3; ++k)
        if (auto size = requireSize("The scale's magnitude", std::abs(numbers.scale[k])); !size)
            return tl::unexpected(size.error());
    glm::dmat3 linear(1.0);
    for (int k = 0; k < 3; ++k)
        linear[k][k] = numbers.scale[k];
    turn(linear, 1, 2, numbers.degrees.x);
    turn(linear, 2, 0, numbers.degrees.y);
    turn(linear, 0, 1, numbers.degrees.z);
    return about(numbers.pivot, linear, numbers.translation);
}

Result<SceneObject> moved(const SceneObject& object, const Mat4& matrix)
{
    SceneObject result = object;
    result.transform = matrix * object.transform;
    double sum = 0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            sum += std::abs(result.transform[column][row]);
    const double volume = glm::determinant(result.transform);
    if (!std::isfinite(sum) || !std::isfinite(volume))
        return failure("That would take the object further away than can be drawn", "Give smaller numbers");
    if (volume == 0)
        return failure("That would flatten the object: it could not be undone", "Give a larger scale");
    return result;
}

SceneObject duplicated(const SceneObject& object, const Scene& scene)
{
    SceneObject result = object;
    if (object.name.empty())
        return result;
    std::set<std::string> taken;
    for (const auto& [id, other] : scene.objects())
        taken.insert(other->name);
    auto [name, number] = numberedName(object.name);
    do
        result.name = name + " " + std::to_string(++number);
    while (taken.count(result.name) != 0);
    return result;
}

Result<NurbsCurve> isoCurveInModel(const SceneObject& object, Direction across, double parameter)
{
    const auto curve = isoCurve(object.surface, across, parameter);
    if (!curve)
        return tl::unexpected(curve.error());
    return transformed(*curve, object.transform);
}

}  // namespace knotspan
