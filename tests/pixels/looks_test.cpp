// That pictures by which surfaces are judged tell the truth pixel by pixel: against closed forms, met by the
// eye's ray in double, on every path.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/mesh/deviation_map.h"
#include "tests/pixels/closed_forms.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

struct Met {
    Ray ray;
    std::optional<ClosedPoint> point;
};

// How far below the form a plane lies that a picture measures it from.
constexpr double kPlane = -7;

SharedSurfaceNumbers heightsOf(const ClosedForm& form)
{
    Scene plane;
    plane.addMesh(
        meshObject("plane", {{{-99, -99, kPlane}, {99, -99, kPlane}, {0, 99, kPlane}}, {{0, 1, 2}}}));
    return deviationMap(form.scene, plane).value().distances;
}

// A closed form as the eye sees it: what is met at each pixel's centre and half-way between.
class ClosedPicture {
public:
    explicit ClosedPicture(ClosedForm form)
        : form_(std::move(form)),
          frame_(frameOf(form_.scene, PathId{}, kWidth, kHeight)),
          heights_(heightsOf(form_))
    {
        for (int y = 0; y < 2 * kHeight; ++y)
            for (int x = 0; x < 2 * kWidth; ++x) {
                const Ray ray = rayThrough(frame_, 0.5 * (x + 1), 0.5 * (y + 1));
                met_.push_back({ray, firstMet(form_, ray)});
            }
    }

    [[nodiscard]] const ClosedForm& form() const { return form_; }
    [[nodiscard]] const Frame& frame() const { return frame_; }
    [[nodiscard]] const SharedSurfaceNumbers& heights() const { return heights_; }

    // At a pixel's centre, and so many halves of a pixel beside it. Null: nothing is met, or nearly edge-on.
    [[nodiscard]] const Met* at(int x, int y, int besideX = 0, int besideY = 0) const
    {
        const int column = 2 * x + besideX;
        const int row = 2 * y + besideY;
        if (column < 0 || row < 0 || column >= 2 * kWidth || row >= 2 * kHeight)
            return nullptr;
        const Met& met = met_[static_cast<size_t>(row) * 2 * kWidth + static_cast<size_t>(column)];
        const bool shows = met.point && std::abs(glm::dot(met.point->normal, met.ray.along)) > 0.15;
        return shows ? &met : nullptr;
    }

    // Whether the surface goes on for some pixels around: neither a silhouette nor a border.
    [[nodiscard]] bool isInside(int x, int y) const
    {
        const Met* const here = at(x, y);
        for (const int dx : {-4, 4})
            for (const int dy : {-4, 4}) {
                const Met* const beside = here != nullptr ? at(x, y, dx, dy) : nullptr;
                if (beside == nullptr || glm::dot(here->point->normal, beside->point->normal) < 0.8)
                    return false;
            }
        return true;
    }

private:
    ClosedForm form_;
    Frame frame_;
    SharedSurfaceNumbers heights_;
    std::vector<Met> met_;
};

const std::vector<ClosedPicture>& closedPictures()
{
    static const std::vector<ClosedPicture> pictures = [] {
        std::vector<ClosedPicture> made;
        for (ClosedForm& form : closedForms())
            made.emplace_back(std::move(form));
        return made;
    }();
    return pictures;
}

Vec3 inView(const Frame& frame, const Vec3& direction)
{
    return {glm::dot(direction, frame.camera.right()), glm::dot(direction, frame.camera.upward()),
            -glm::dot(direction, frame.camera.forward())};
}

// The number of the band at a place, in double: the even ones are bright.
int bandAt(const Frame& frame, const Met& met)
{
    Vec3 direction = inView(frame, met.point->normal);
    if (frame.shading != Shading::isophotes)
        direction = glm::reflect(inView(frame, met.ray.along), direction);
    const double turned = glm::radians(frame.look.stripesTurnedDegrees);
    const Vec3 axis(-std::sin(turned), std::cos(turned), 0);
    const double angle = std::acos(std::clamp(glm::dot(direction, axis), -1.0, 1.0));
    const double stripes = angle * frame.look.stripes / M_PI + 0.25;
    if (frame.shading != Shading::reflection)
        return static_cast<int>(std::floor(2 * stripes));
    const double line = std::round(stripes);  // the odd ones are lines, an eighth of a stripe wide, nearly
    const bool isLine = std::abs(stripes - line) < 0.06;
    return 2 * static_cast<int>(isLine ? line : std::floor(stripes)) + (isLine ? 1 : 100);
}

using Expected = std::optional<Vec3> (*)(const Frame& frame, const ClosedPicture& closed, int x, int y);

std::optional<Vec3> normalColour(const Frame& frame, const ClosedPicture& closed, int x, int y)
{
    return 0.5 + 0.5 * inView(frame, closed.at(x, y)->point->normal);
}

std::optional<Vec3> curvatureColour(const Frame& frame, const ClosedPicture& closed, int x, int y)
{
    const double number = figure(closed.at(x, y)->point->curvature, frame.look.curvature);
    const NumberRange range = *frame.look.curvatureRange;
    return colourOnRamp((number - range.low) / (range.high - range.low));
}

std::optional<Vec3> draftColour(const Frame& frame, const ClosedPicture& closed, int x, int y)
{
    const double rising = glm::dot(closed.at(x, y)->point->normal, glm::normalize(frame.look.pull));
    return colourOnRamp(0.5 + 0.5 * glm::degrees(std::asin(rising)) / frame.look.draftDegrees);
}

// Nothing where a band ends within two pixels: how ends are smoothed is not told here.
std::optional<Vec3> stripeColour(const Frame& frame, const ClosedPicture& closed, int x, int y)
{
    const Met& here = *closed.at(x, y);
    const int band = bandAt(frame, here);
    for (int dx = -3; dx <= 3; ++dx)
        for (int dy = -3; dy <= 3; ++dy) {
            const Met* const beside = closed.at(x, y, dx, dy);
            if (beside == nullptr || bandAt(frame, *beside) != band)
                return std::nullopt;
        }
    const bool bright = band % 2 == 0;
    const bool front = glm::dot(here.point->normal, here.ray.along) < 0;
    const Vec3 inside = front ? Vec3(1) : Vec3(0.75, 0.62, 0.5);
    if (frame.shading == Shading::reflection)
        return (bright ? Vec3(0.82, 0.84, 0.86) : Vec3(0.05)) * inside;
    if (frame.shading == Shading::zebra)
        return Vec3(bright ? 0.95 : 0.06) * inside;
    return (bright ? Vec3(0.93, 0.92, 0.86) : Vec3(0.16, 0.28, 0.42)) * inside;
}

std::optional<Vec3> heightColour(const Frame& frame, const ClosedPicture& closed, int x, int y)
{
    const NumberRange range = *frame.look.deviationRange;
    return colourOnRamp((closed.at(x, y)->point->position.z - kPlane - range.low) / (range.high - range.low));
}

struct LookCase {
    const char* name;
    Shading shading;
    Look look;
    Expected expected;
};

std::vector<LookCase> lookCases()
{
    Look turned;
    turned.stripesTurnedDegrees = 30;
    turned.stripes = 6;
    Look upright;
    upright.stripes = 4;
    std::vector<LookCase> cases{{"normals", Shading::normals, {}, normalColour},
                                {"zebra", Shading::zebra, upright, stripeColour},
                                {"zebra turned", Shading::zebra, turned, stripeColour},
                                {"reflection", Shading::reflection, upright, stripeColour},
                                {"isophotes", Shading::isophotes, turned, stripeColour},
                                {"draft", Shading::draft, {}, draftColour}};
    cases.back().look.draftDegrees = 40;
    cases.back().look.pull = Vec3(1, 2, 4);
    for (const CurvatureKindInfo& kind : curvatureKinds()) {
        Look look;
        look.curvature = kind.id;
        look.curvatureRange = NumberRange{-1.3, 1.9};
        cases.push_back({kind.name.c_str(), Shading::curvature, look, curvatureColour});
    }
    Look heights;
    heights.deviationRange = NumberRange{4, 10};
    cases.push_back({"deviation", Shading::deviation, heights, heightColour});
    return cases;
}

void expectTrue(Renderer& renderer, const ClosedPicture& closed, const LookCase& look, PathId path)
{
    const ClosedForm& form = closed.form();
    Frame frame = closed.frame();
    frame.path = path;
    frame.shading = look.shading;
    frame.look = look.look;
    if (look.shading == Shading::deviation)
        frame.deviations = closed.heights();
    const Picture picture = drawn(renderer, form.scene, frame).picture;
    // The path surface cuts whole surfaces by a few lines: beside a pole, pixels get parameters from the
    // other side of it, from where no step finds back.
    const size_t allowed = path == PathId::surface ? 7 : 0;
    size_t looked = 0;
    size_t wrong = 0;
    double worst = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            if (!closed.isInside(x, y))
                continue;
            const auto expected = look.expected(frame, closed, x, y);
            if (!expected)
                continue;
            ++looked;
            double off = 0;
            const std::uint32_t colour = colourAt(picture, x, y);
            for (int channel = 0; channel < 3; ++channel)
                off = std::max(off, std::abs((colour >> (16 - 8 * channel) & 255U) -
                                             255 * std::clamp((*expected)[channel], 0.0, 1.0)));
            worst = std::max(worst, off);
            if (off > 1 && wrong++ == allowed)
                ADD_FAILURE() << form.name << ", " << look.name << ", " << pathInfo(path).name << ": pixel "
                              << x << ", " << y << " is off by " << off;
        }
    EXPECT_GT(looked, 300U) << form.name << ", " << look.name;
    EXPECT_LE(wrong, allowed) << form.name << ", " << look.name << ", " << pathInfo(path).name << ": of "
                              << looked << ", worst " << worst;
}

// Squares of a bilinear surface are squares of its plan.
void expectSquares(Renderer& renderer, const ClosedPicture& closed, PathId path)
{
    Frame frame = closed.frame();
    frame.path = path;
    frame.shading = Shading::checker;
    frame.look.checkerCells = 6;
    const Picture picture = drawn(renderer, closed.form().scene, frame).picture;
    const Box plan = closed.form().scene.bounds();
    size_t looked = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            if (!closed.isInside(x, y))
                continue;
            const auto squareAt = [&](const Vec3& at) {
                const Vec3 share = (at - plan.low) / (plan.high - plan.low);
                return static_cast<int>(std::floor(6 * share.x)) +
                       100 * static_cast<int>(std::floor(6 * share.y));
            };
            const Met& here = *closed.at(x, y);
            const int square = squareAt(here.point->position);
            bool isWhole = true;
            for (int dx = -3; dx <= 3; ++dx)
                for (int dy = -3; dy <= 3; ++dy) {
                    const Met* const beside = closed.at(x, y, dx, dy);
                    isWhole = isWhole && beside != nullptr && squareAt(beside->point->position) == square;
                }
            if (!isWhole)
                continue;
            ++looked;
            const bool bright = (square % 100 + square / 100) % 2 == 0;
            const bool front = glm::dot(here.point->normal, here.ray.along) < 0;
            const double expected = (bright ? 0.90 : 0.22) * (front ? 1 : 0.75);
            ASSERT_NEAR(colourAt(picture, x, y) >> 16, 255 * expected, 1) << x << ", " << y;
        }
    EXPECT_GT(looked, 300U);
}

class Looks : public ::testing::TestWithParam<PathId> {};

TEST_P(Looks, HaveTheColourOfTheClosedFormInEveryPixel)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    for (const ClosedPicture& closed : closedPictures())
        for (const LookCase& look : lookCases())
            expectTrue(*renderer, closed, look, GetParam());
}

TEST_P(Looks, CheckerHasItsSquaresWhereTheParametersHaveThem)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    expectSquares(*renderer, closedPictures().back(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Every, Looks, ::testing::ValuesIn(allPaths()), pathTestName);

}  // namespace
}  // namespace knotspan::testing
