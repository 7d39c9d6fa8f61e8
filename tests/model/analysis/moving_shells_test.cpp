// Bodies whose control points move, a few at a time: what is known of them is what one finds who looks at all
// anew.
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/analysis/shells.h"
#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

// A model, and shells that follow it.
class Body {
public:
    explicit Body(const Scene& scene)
    {
        for (const auto& [id, object] : scene.objects()) {
            surfaces_.push_back(object->surface);
            transforms_.push_back(object->transform);
        }
        box_ = scene.bounds();
        edges_ = CoincidentEdges(placed());
        shells_ = Shells(placed(), edges_);
    }

    [[nodiscard]] size_t size() const { return surfaces_.size(); }
    [[nodiscard]] const Shells& shells() const { return shells_; }
    [[nodiscard]] const NurbsSurface& surface(size_t k) const { return surfaces_[k]; }

    [[nodiscard]] std::vector<PlacedSurface> placed() const
    {
        std::vector<PlacedSurface> all;
        for (size_t k = 0; k < size(); ++k)
            all.push_back({&surfaces_[k], transforms_[k]});
        return all;
    }

    void move(size_t k, int i, int j, const Vec3& by)
    {
        const NurbsSurface& before = surfaces_[k];
        std::vector<ControlPoint> points = before.controlPoints();
        points[static_cast<size_t>(i * before.countV() + j)].position += by;
        surfaces_[k] = NurbsSurface::create(before.knotsU(), before.knotsV(), std::move(points)).value();
        const std::vector<CoincidentEdges::Change> changes{
            {static_cast<std::uint32_t>(k), {&surfaces_[k], transforms_[k]}}};
        (void)edges_.update(changes);
        shells_.update(changes, edges_);
    }

    void expectAsAnew(std::mt19937& random, const std::string& name) const
    {
        const Shells anew(placed(), CoincidentEdges(placed()));
        ASSERT_EQ(shells_.count(), anew.count()) << name;
        for (std::uint32_t k = 0; k < size(); ++k) {
            ASSERT_EQ(shells_.shellOf(k), anew.shellOf(k)) << name;
            EXPECT_EQ(shells_.side(k), anew.side(k)) << name << " " << k;
        }
        for (std::uint32_t shell = 0; shell < anew.count(); ++shell) {
            EXPECT_EQ(shells_.isClosed(shell), anew.isClosed(shell)) << name;
            for (int k = 0; k < 6; ++k) {
                Vec3 eye;
                for (int axis = 0; axis < 3; ++axis)
                    eye[axis] = randomBetween(random, box_.low[axis], box_.high[axis]);
                // Twice: looked at anew, and remembered.
                for (int turn = 0; turn < 2; ++turn)
                    EXPECT_EQ(shells_.isOutside(shell, eye, 0.01), anew.isOutside(shell, eye, 0.01)) << name;
            }
            const Vec3 still = box_.high;
            EXPECT_EQ(shells_.isOutside(shell, still, 0.02), anew.isOutside(shell, still, 0.02)) << name;
        }
    }

private:
    std::vector<NurbsSurface> surfaces_;
    std::vector<Mat4> transforms_;
    Box box_;
    CoincidentEdges edges_;
    Shells shells_;
};

// Small steps keep a body, large ones turn parts of it inside out, those of the border tear it.
TEST(MovingShells, AreThoseFoundAnew)
{
    std::mt19937 random(11);
    for (const auto& [name, scene] : {std::pair<std::string, Scene>{"T-joints", torusWithTJoints()},
                                      {"torus", findSample("torus")->make()},
                                      {"sphere", findSample("sphere")->make()}}) {
        Body body(scene);
        for (int step = 0; step < 60; ++step) {
            const size_t k = std::uniform_int_distribution<size_t>(0, body.size() - 1)(random);
            const NurbsSurface& surface = body.surface(k);
            const bool border = step % 7 == 0;
            const auto index = [&](int count) {
                return border || count < 3 ? 0 : std::uniform_int_distribution<int>(1, count - 2)(random);
            };
            const double reach = step % 5 == 4 ? 2.5 : 0.05;
            const Vec3 by(randomBetween(random, -reach, reach), randomBetween(random, -reach, reach),
                          randomBetween(random, -reach, reach));
            const int i = index(surface.countU());
            const int j = index(surface.countV());
            body.move(k, i, j, by);
            if (step % 3 == 0)
                body.expectAsAnew(random, name + " " + std::to_string(step));
            body.move(k, i, j, -by);
            if (step % 3 == 1)
                body.expectAsAnew(random, name + " and back " + std::to_string(step));
        }
    }
}

TEST(MovingShells, OfManySurfacesAreThoseFoundAnew)
{
    std::mt19937 random(12);
    Body body(findSample("knot")->make());
    for (int step = 0; step < 40; ++step)
        body.move(17, 3, 4, Vec3(0, 0, step < 20 ? 0.01 : -0.01));
    body.expectAsAnew(random, "pulled to and fro");
    for (int step = 0; step < 10; ++step)
        body.move(17, 3, 4, Vec3(0, 0, 0.4));
    body.expectAsAnew(random, "pulled out");
    for (int step = 0; step < 10; ++step)
        body.move(200, 0, 4, Vec3(0.02));
    EXPECT_FALSE(body.shells().isClosed(0));
    body.expectAsAnew(random, "torn");
}

TEST(MovingShells, KeepWhatTheyKnowOfTheirSidesWhileOnlyTheirInsideMoves)
{
    Body body(findSample("knot")->make());
    const std::uint64_t revision = body.shells().revision();
    for (int step = 0; step < 10; ++step)
        body.move(17, 3, 4, Vec3(0, 0, 0.001));
    EXPECT_EQ(body.shells().revision(), revision);
    body.move(17, 0, 4, Vec3(0, 0, 0.1));
    const std::uint64_t torn = body.shells().revision();
    EXPECT_GT(torn, revision);
    for (int step = 0; step < 10; ++step)
        body.move(17, 0, 4, Vec3(0, 0, 0.01));
    EXPECT_EQ(body.shells().revision(), torn);
}

}  // namespace
}  // namespace knotspan::testing
