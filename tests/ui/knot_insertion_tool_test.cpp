// A knot where the surface is clicked, its iso-curve lit up first, its shape to the last digits.
#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "tests/ui/one_surface_test.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class KnotInsertionToolTest : public OneSurfaceTest {
protected:
    [[nodiscard]] Vec2 place()
    {
        const PictureSize size = window->viewport().pictureSize();
        return {size.width * 0.5 + 13, size.height * 0.5 + 7};
    }
    [[nodiscard]] const NurbsSurface& surface() { return scene().find(id)->surface; }
    // The knot that is not in the first surface.
    [[nodiscard]] static double newKnot(const KnotVector& before, const KnotVector& after)
    {
        const std::vector<double>& was = before.values();
        const std::vector<double>& now = after.values();
        for (size_t k = 0; k < now.size(); ++k)
            if (k >= was.size() || now[k] != was[k])
                return now[k];
        return -1;
    }
    void expectSameShape()
    {
        const NurbsSurface& before = start.find(id)->surface;
        const double size = before.bounds().diagonal();
        for (int a = 0; a <= 40; ++a)
            for (int b = 0; b <= 40; ++b) {
                const double u =
                    glm::mix(before.knotsU().domainStart(), before.knotsU().domainEnd(), a / 40.0);
                const double v =
                    glm::mix(before.knotsV().domainStart(), before.knotsV().domainEnd(), b / 40.0);
                EXPECT_LE(glm::distance(evaluate(before, u, v).position, evaluate(surface(), u, v).position),
                          1e-12 * size);
            }
    }
};

TEST_F(KnotInsertionToolTest, AClickInsertsWhereTheSurfaceIsUnderIt)
{
    act("tools.knot");
    Hand hand(*window);
    hand.hover(place());
    settle(*window);
    const QImage lit = picture(*window);
    act("tools.select");
    settle(*window);
    EXPECT_GT(differingPixels(lit, picture(*window)), 100) << "the iso-curve lights up";
    act("tools.knot");
    const NurbsSurface before = start.find(id)->surface;
    hand.click(place());
    EXPECT_EQ(surface().countU(), before.countU() + 1);
    EXPECT_EQ(surface().countV(), before.countV());
    // The iso-curve of the new knot passes under the pixel.
    const double u = newKnot(before.knotsU(), surface().knotsU());
    const PictureSize size = window->viewport().pictureSize();
    double nearest = 1e9;
    for (int k = 0; k <= 2000; ++k) {
        const double v = glm::mix(before.knotsV().domainStart(), before.knotsV().domainEnd(), k / 2000.0);
        const auto at = window->viewport().frame().camera.toPixel(evaluate(before, u, v).position, size.width,
                                                                  size.height);
        if (at)
            nearest = std::min(nearest, glm::distance(*at, place()));
    }
    EXPECT_LT(nearest, 1.5);
    expectSameShape();
    EXPECT_EQ(steps(), 1);
    act("edit.undo");
    EXPECT_TRUE(scene() == start);
}

TEST_F(KnotInsertionToolTest, ShiftTakesVAndControlBoth)
{
    act("tools.knot");
    Hand hand(*window);
    const NurbsSurface before = start.find(id)->surface;
    hand.click(place(), Qt::ShiftModifier);
    EXPECT_EQ(surface().countU(), before.countU());
    EXPECT_EQ(surface().countV(), before.countV() + 1);
    settle(*window);
    hand.click(place() + Vec2(20, 10), Qt::ControlModifier);
    EXPECT_EQ(surface().countU(), before.countU() + 1);
    EXPECT_EQ(surface().countV(), before.countV() + 2);
    expectSameShape();
    EXPECT_EQ(steps(), 2);
    hand.press(place());
    hand.key(Qt::Key_Escape);
    hand.release();
    EXPECT_EQ(steps(), 2);
    hand.click({3, 3});
    EXPECT_EQ(steps(), 2);
    while (window->document().canUndo())
        window->document().undo();
    EXPECT_TRUE(scene() == start);
}

}  // namespace
}  // namespace knotspan
