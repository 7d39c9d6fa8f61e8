#include "model/sculpting/best_plane.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace knotspan {

namespace {

struct Turned {
    glm::dmat3 matrix;
    glm::dmat3 axes;  // columns
};

// One rotation of Jacobi's method, after which (p, q) is zero. Golub and Van Loan, Matrix Computations, 8.5.
void rotate(Turned& turned, int p, int q)
{
    const double off = turned.matrix[p][q];
    if (off == 0)
        return;
    const double ratio = (turned.matrix[q][q] - turned.matrix[p][p]) / (2 * off);
    const double tangent = (ratio >= 0 ? 1 : -1) / (std::abs(ratio) + std::hypot(1.0, ratio));
    const double cosine = 1 / std::hypot(1.0, tangent);
    glm::dmat3 rotation(1.0);
    rotation[p][p] = rotation[q][q] = cosine;
    rotation[q][p] = tangent * cosine;
    rotation[p][q] = -tangent * cosine;
    turned.matrix = glm::transpose(rotation) * turned.matrix * rotation;
    turned.matrix[p][q] = turned.matrix[q][p] = 0;
    turned.axes = turned.axes * rotation;
}

}  // namespace

BestPlane bestPlaneOf(const std::vector<Vec3>& points, const std::vector<double>& weights)
{
    const Vec3 origin = points.front();
    Vec3 sum{0};
    double weight = 0;
    double size = 0;
    for (size_t k = 0; k < points.size(); ++k) {
        sum += weights[k] * (points[k] - origin);
        weight += weights[k];
        size = std::max(size, glm::length(points[k] - origin));
    }
    BestPlane plane{origin + sum / weight, {0, 0, 1}};
    if (!(size > 0))
        return plane;
    Turned turned{glm::dmat3(0.0), glm::dmat3(1.0)};
    for (size_t k = 0; k < points.size(); ++k) {
        const Vec3 away = ((points[k] - origin) - sum / weight) / size;
        turned.matrix += weights[k] * glm::outerProduct(away, away);
    }
    for (int sweep = 0; sweep < 12; ++sweep) {
        rotate(turned, 0, 1);
        rotate(turned, 0, 2);
        rotate(turned, 1, 2);
    }
    int least = 2;
    for (const int k : {1, 0})
        least = turned.matrix[k][k] < turned.matrix[least][least] ? k : least;
    plane.normal = glm::normalize(turned.axes[least]);
    return plane;
}

}  // namespace knotspan
