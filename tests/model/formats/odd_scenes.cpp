#include "tests/model/formats/odd_scenes.h"

#include <cmath>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "model/geometry/primitives.h"

namespace knotspan::testing {
namespace {

KnotVector knots(int degree, std::vector<double> values)
{
    return KnotVector::create(degree, std::move(values)).value();
}

KnotVector even(int degree, int spans)
{
    return KnotVector::clampedUniform(degree, spans);
}

// A tube around z: `poles` control points around, the first ones again at the end.
NurbsSurface tube(const KnotVector& around, int poles)
{
    std::vector<ControlPoint> points;
    for (int i = 0; i < around.controlPointCount(); ++i) {
        const double angle = 2 * M_PI * (i % poles) / poles;
        for (const double height : {0.0, 3.0})
            points.push_back({{5 * std::cos(angle), 5 * std::sin(angle), height}, 1});
    }
    return NurbsSurface::create(around, even(1, 1), std::move(points)).value();
}

NurbsSurface flattened(NurbsSurface surface, double factor)
{
    std::vector<ControlPoint> points = surface.controlPoints();
    for (ControlPoint& point : points)
        point.position.y *= factor;
    return NurbsSurface::create(surface.knotsU(), surface.knotsV(), std::move(points)).value();
}

Scene placedAndHidden()
{
    Scene scene = sceneOf(wavySurface(even(3, 4), even(2, 5), 3));
    SceneObject object = *scene.find(ObjectId{0});
    object.transform = glm::rotate(glm::translate(Mat4(1.0), Vec3(100, -20, 3e4)), 0.3, Vec3(1, 2, 3));
    object.transform = glm::scale(object.transform, Vec3(-2, 3, 0.1));
    object.visible = false;
    scene.exchange(ObjectId{0}, std::make_shared<SceneObject>(object));
    return scene;
}

TrimCurve line(const Vec2& from, const Vec2& to)
{
    return *TrimCurve::create(even(1, 1), {{from, 1}, {to, 1}});
}

// Anticlockwise around a rectangle.
TrimLoop rectangle(const Vec2& low, const Vec2& high)
{
    return {true,
            {line(low, {high.x, low.y}), line({high.x, low.y}, high), line(high, {low.x, high.y}),
             line({low.x, high.y}, low)}};
}

// Clockwise.
TrimLoop roundHole()
{
    const double half = std::sqrt(0.5);
    const auto circle = TrimCurve::create(knots(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}), {{{0.6, 0.5}, 1},
                                                                                           {{0.6, 0.4}, half},
                                                                                           {{0.5, 0.4}, 1},
                                                                                           {{0.4, 0.4}, half},
                                                                                           {{0.4, 0.5}, 1},
                                                                                           {{0.4, 0.6}, half},
                                                                                           {{0.5, 0.6}, 1},
                                                                                           {{0.6, 0.6}, half},
                                                                                           {{0.6, 0.5}, 1}});
    return {false, {*circle}};
}

TrimLoop curvedLoop()
{
    const auto arc =
        *TrimCurve::create(even(2, 1), {{{0.9, 0.2}, 1}, {{0.95, 0.9}, std::sqrt(0.5)}, {{0.2, 0.9}, 1}});
    const auto wave = *TrimCurve::create(
        knots(3, {0, 0, 0, 0, 0.5, 1, 1, 1, 1}),
        {{{0.2, 0.9}, 1}, {{0.1, 0.8}, 1}, {{0.15, 0.5}, 1}, {{0.05, 0.3}, 1}, {{0.1, 0.1}, 1}});
    return {true, {line({0.1, 0.1}, {0.9, 0.2}), arc, wave}};
}

Scene trimmed(const NurbsSurface& surface, std::vector<TrimLoop> loops)
{
    Scene scene;
    scene.add({"trimmed", {0.2, 0.4, 0.6}, Mat4(1.0), true, surface, std::move(loops)});
    return scene;
}

}  // namespace

NurbsSurface wavySurface(const KnotVector& u, const KnotVector& v, double orders, const Vec3& at, double size)
{
    std::mt19937 random(1);
    const auto between = [&](double low, double high) {
        return low +
               (high - low) * (static_cast<double>(random()) / static_cast<double>(std::mt19937::max()));
    };
    std::vector<ControlPoint> points;
    for (int i = 0; i < u.controlPointCount(); ++i) {
        for (int j = 0; j < v.controlPointCount(); ++j) {
            const Vec3 place(1.0 * i / u.controlPointCount() + between(-0.1, 0.1),
                             1.0 * j / v.controlPointCount() + between(-0.1, 0.1), between(-0.3, 0.3));
            points.push_back({at + place * size, orders > 0 ? std::pow(10, between(-orders, orders)) : 1.0});
        }
    }
    return NurbsSurface::create(u, v, std::move(points)).value();
}

Scene sceneOf(const NurbsSurface& surface)
{
    Scene scene;
    scene.add({"Fläche", {0.1, 0.5, 0.9}, Mat4(1.0), true, surface, {}});
    return scene;
}

std::vector<OddScene> oddSurfaces()
{
    const KnotVector u = even(3, 4);
    const KnotVector v = even(2, 5);
    return {
        {"weights from 1e-3 to 1e3", sceneOf(wavySurface(u, v, 3))},
        {"degree 1", sceneOf(wavySurface(even(1, 6), even(1, 3), 0))},
        {"degree 15 x 14", sceneOf(wavySurface(even(15, 3), even(14, 2), 1))},
        {"knots of full multiplicity",
         sceneOf(wavySurface(knots(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2.5, 4, 4, 4, 4}),
                             knots(2, {-5, -5, -5, -1, -1, 3, 3, 3}), 1))},
        {"unclamped knots", sceneOf(wavySurface(knots(3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}),
                                                knots(2, {0, 1, 2, 3, 4.5, 5, 6}), 1))},
        {"clamped at one end", sceneOf(wavySurface(knots(3, {0, 0, 0, 1, 4, 5, 7, 7, 7, 7}), v, 1))},
        {"outermost knots apart", sceneOf(wavySurface(knots(3, {-2, 0, 0, 0, 1, 4, 4, 4, 6}), v, 1))},
        {"knots one rounding apart",
         sceneOf(wavySurface(knots(3, {0, 0, 0, 0, 1, std::nextafter(1, 2), 2, 2, 2, 2}), v, 0))},
        {"knots 1e-13 apart",
         sceneOf(wavySurface(knots(3, {0, 0, 0, 0, 1, 1 + 1e-13, 1 + 1e-7, 2, 2, 2, 2}), v, 0))},
        {"knots far from zero",
         sceneOf(wavySurface(knots(3, {1e6, 1e6, 1e6, 1e6, 1e6 + 1, 1e6 + 2, 1e6 + 2, 1e6 + 2, 1e6 + 2}),
                             knots(2, {-1e-6, -1e-6, -1e-6, 0, 2e-6, 2e-6, 2e-6}), 0))},
        {"a micron small", sceneOf(wavySurface(u, v, 1, Vec3(0.0), 1e-3))},
        {"far away", sceneOf(wavySurface(u, v, 1, {1e7, -1e7, 1e6}, 1))},
        {"a million kilometres", sceneOf(wavySurface(u, v, 1, Vec3(0.0), 1e12))},
        {"a strip 1e-7 wide", sceneOf(flattened(wavySurface(u, v, 1), 1e-8))},
        {"a cubic tube", sceneOf(tube(even(3, 6), 8))},
        {"a tube of flats", sceneOf(tube(even(1, 8), 8))},
        {"a tube with knots all round",
         sceneOf(tube(knots(3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14}), 8))},
        {"a sphere", sceneOf(sphere({1, 2, 3}, 0.7))},
        {"placed and hidden", placedAndHidden()},
    };
}

std::vector<OddScene> trimmedScenes()
{
    const NurbsSurface wavy = wavySurface(even(3, 4), even(2, 5), 0.3);
    const NurbsSurface ball = sphere({1, 2, 3}, 0.7);
    const Vec2 low(ball.knotsU().domainStart(), ball.knotsV().domainStart());
    const Vec2 size = Vec2(ball.knotsU().domainEnd(), ball.knotsV().domainEnd()) - low;
    const auto at = [&](double u, double v) { return low + size * Vec2(u, v); };
    TrimLoop window = rectangle(at(0.2, 0.3), at(0.7, 0.5));
    window = {false,
              {line(at(0.2, 0.3), at(0.2, 0.5)), line(at(0.2, 0.5), at(0.7, 0.5)),
               line(at(0.7, 0.5), at(0.7, 0.3)), line(at(0.7, 0.3), at(0.2, 0.3))}};
    return {
        {"curves", trimmed(wavy, {curvedLoop()})},
        {"curves and a hole", trimmed(wavy, {curvedLoop(), roundHole()})},
        {"a hole in the whole", trimmed(wavy, {rectangle({0, 0}, {1, 1}), roundHole()})},
        {"half", trimmed(wavy, {rectangle({0, 0}, {0.5, 1})})},
        {"half a sphere", trimmed(ball, {rectangle(at(0, 0), at(1, 0.5))})},
        {"a piece of a sphere", trimmed(ball, {rectangle(at(0.2, 0.3), at(0.7, 0.5))})},
        {"a belt", trimmed(ball, {rectangle(at(0, 0.3), at(1, 0.5))})},
        {"a slice", trimmed(ball, {rectangle(at(0, 0), at(0.7, 1))})},
        {"a sphere with a window", trimmed(ball, {rectangle(at(0, 0), at(1, 1)), window})},
    };
}

}  // namespace knotspan::testing
