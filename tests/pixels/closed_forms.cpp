#include "tests/pixels/closed_forms.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/making/shapes.h"
#include "model/samples/sample_list.h"

namespace knotspan::testing {
namespace {

Scene sceneOf(NurbsSurface surface)
{
    Scene scene;
    scene.add({.name = "shape", .surface = std::move(surface)});
    return scene;
}

const SceneObject& objectOf(const ClosedForm& form)
{
    return *form.scene.objects().begin()->second;
}

// Which way S_u x S_v runs, asked at one place.
void turn(ClosedForm& form)
{
    const NurbsSurface& surface = objectOf(form).surface;
    const auto between = [](const KnotVector& knots) {
        return knots.domainStart() + 0.37 * (knots.domainEnd() - knots.domainStart());
    };
    const SurfacePoint at = evaluate(surface, between(surface.knotsU()), between(surface.knotsV()));
    form.side = glm::dot(form.gradient(at.position), glm::cross(at.du, at.dv)) > 0 ? 1 : -1;
}

ClosedForm sphere(double radius)
{
    ClosedForm form{.name = "sphere", .scene = sceneOf(sphereShape({}, radius).value())};
    form.f = [=](const Vec3& p) { return glm::length(p) - radius; };
    form.gradient = [](const Vec3& p) { return glm::normalize(p); };
    form.bends = [=](const Vec3&) { return std::pair(-1 / radius, -1 / radius); };
    form.isThere = [](const Vec3&) { return true; };
    return form;
}

ClosedForm torus(double major, double minor)
{
    ClosedForm form{.name = "torus", .scene = sceneOf(torusShape({}, major, minor).value())};
    const auto out = [](const Vec3& p) { return std::hypot(p.x, p.y); };
    form.f = [=](const Vec3& p) { return std::hypot(out(p) - major, p.z) - minor; };
    form.gradient = [=](const Vec3& p) {
        const double share = (out(p) - major) / out(p);
        return glm::normalize(Vec3(share * p.x, share * p.y, p.z));
    };
    form.bends = [=](const Vec3& p) {
        const double cosine = (out(p) - major) / minor;
        return std::pair(-1 / minor, -cosine / (major + minor * cosine));
    };
    form.isThere = [](const Vec3&) { return true; };
    return form;
}

ClosedForm cylinder(double radius, double height)
{
    ClosedForm form{.name = "cylinder", .scene = sceneOf(cylinderShape({}, radius, height).value())};
    form.f = [=](const Vec3& p) { return std::hypot(p.x, p.y) - radius; };
    form.gradient = [](const Vec3& p) { return glm::normalize(Vec3(p.x, p.y, 0)); };
    form.bends = [=](const Vec3&) { return std::pair(-1 / radius, 0.0); };
    form.isThere = [=](const Vec3& p) { return p.z >= 0 && p.z <= height; };
    return form;
}

// z = c x y over a square: one bilinear KSQuad.
ClosedForm saddle(double c, double half)
{
    std::vector<ControlPoint> points;
    for (const double x : {-half, half})
        for (const double y : {-half, half})
            points.push_back({Vec3(x, y, c * x * y), 1});
    const KnotVector knots = KnotVector::clampedUniform(1, 1);
    ClosedForm form{.name = "saddle", .scene = sceneOf(NurbsSurface::create(knots, knots, points).value())};
    form.f = [=](const Vec3& p) { return p.z - c * p.x * p.y; };
    form.gradient = [=](const Vec3& p) { return glm::normalize(Vec3(-c * p.y, -c * p.x, 1)); };
    form.bends = [=](const Vec3& p) {
        const double w = 1 + c * c * (p.x * p.x + p.y * p.y);
        const double mean = -c * c * c * p.x * p.y / std::pow(w, 1.5);
        const double apart = std::sqrt(mean * mean + c * c / (w * w));
        return std::pair(mean + apart, mean - apart);
    };
    form.isThere = [=](const Vec3& p) { return std::abs(p.x) <= half && std::abs(p.y) <= half; };
    return form;
}

}  // namespace

std::vector<ClosedForm> closedForms()
{
    std::vector<ClosedForm> forms{sphere(1.5), torus(2, 0.75), cylinder(1.25, 3), saddle(0.5, 2)};
    for (ClosedForm& form : forms)
        turn(form);
    return forms;
}

Ray rayThrough(const Frame& frame, double x, double y)
{
    const Camera& camera = frame.camera;
    const double high = std::tan(glm::radians(camera.verticalFovDegrees) / 2);
    const double right = (2 * x / frame.width - 1) * high * frame.width / frame.height;
    const double up = (1 - 2 * y / frame.height) * high;
    const Vec3 aside = right * camera.right() + up * camera.upward();
    if (camera.orthographic)
        return {camera.eye + camera.distance() * aside, camera.forward()};
    return {camera.eye, glm::normalize(camera.forward() + aside)};
}

std::optional<ClosedPoint> firstMet(const ClosedForm& form, const Ray& ray)
{
    const Box bounds = form.scene.bounds();
    const double middle = glm::dot(bounds.centre() - ray.from, ray.along);
    const double reach = bounds.diagonal();
    constexpr int kSteps = 160;
    const auto at = [&](double t) { return ray.from + t * ray.along; };
    double before = middle - reach;
    for (int k = 1; k <= kSteps; ++k) {
        const double after = middle - reach + 2 * reach * k / kSteps;
        if ((form.f(at(before)) > 0) != (form.f(at(after)) > 0)) {
            double low = before;
            double high = after;
            const bool above = form.f(at(low)) > 0;
            for (int step = 0; step < 60; ++step) {
                const double between = 0.5 * (low + high);
                ((form.f(at(between)) > 0) == above ? low : high) = between;
            }
            const Vec3 p = at(0.5 * (low + high));
            if (form.isThere(p)) {
                const auto [one, other] = form.bends(p);
                ClosedPoint point{p, form.side * form.gradient(p), {}};
                point.curvature.largest = std::max(form.side * one, form.side * other);
                point.curvature.smallest = std::min(form.side * one, form.side * other);
                point.curvature.gauss = one * other;
                point.curvature.mean = 0.5 * form.side * (one + other);
                return point;
            }
        }
        before = after;
    }
    return std::nullopt;
}

}  // namespace knotspan::testing
