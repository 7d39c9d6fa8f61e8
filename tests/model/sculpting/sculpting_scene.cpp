#include "tests/model/sculpting/sculpting_scene.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "model/samples/net.h"

namespace knotspan::testing {

NurbsSurface netOfPlaces(int countU, int countV, const Place& at,
                         const std::function<double(int, int)>& weightAt)
{
    return surfaceOf(KnotVector::clampedUniform(3, countU - 3), KnotVector::clampedUniform(3, countV - 3),
                     [&](int i, int j) {
                         return ControlPoint{at(i, j), weightAt ? weightAt(i, j) : 1.0};
                     });
}

NurbsSurface symmetricSheet(int countU, int countV)
{
    return netOfPlaces(
        countU, countV,
        [&](int i, int j) {
            const double x = i - (countU - 1) / 2.0;
            return Vec3(x, 0.9 * j + 0.03 * x * x, std::cos(0.7 * x) + 0.4 * std::sin(1.3 * j));
        },
        [&](int i, int j) { return 1 + 0.1 * std::abs(i - (countU - 1) / 2.0) + 0.05 * j; });
}

Mat4 anyTransform()
{
    Mat4 shear(1.0);
    shear[1][0] = 0.3;
    return glm::rotate(glm::translate(Mat4(1.0), Vec3(3, -2, 5)), 0.8, glm::normalize(Vec3(1, 2, -1))) *
           glm::scale(Mat4(1.0), Vec3(2, 0.5, 1.5)) * shear;
}

Scene sceneOf(const std::vector<NurbsSurface>& surfaces)
{
    Scene scene;
    for (const NurbsSurface& surface : surfaces)
        scene.add(namedObject("surface", {}, surface));
    return scene;
}

Scene applied(Scene scene, Edit edit)
{
    edit.applyTo(scene);
    return scene;
}

Vec3 placeIn(const Scene& scene, ObjectId object, int i, int j)
{
    return controlPointInModel(*scene.find(object), {i, j});
}

double largestDifference(const Scene& a, const Scene& b)
{
    const std::vector<Vec3> left = a.hullPoints();
    const std::vector<Vec3> right = b.hullPoints();
    if (left.size() != right.size())
        return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (size_t k = 0; k < left.size(); ++k)
        largest = std::max(largest, glm::distance(left[k], right[k]));
    return largest;
}

}  // namespace knotspan::testing
