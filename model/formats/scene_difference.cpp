#include "model/formats/scene_difference.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "model/files/length_units.h"

namespace knotspan::formats {
namespace {

constexpr double kSameLoop = 1e-9;  // so near, and no other loop is meant

constexpr double kSameColour = 1e-3;

double largestOf(const Vec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double largestOf(const Vec2& v)
{
    return std::max(std::abs(v.x), std::abs(v.y));
}

double share(double part, double whole)
{
    return part > 0 ? part / whole : 0;
}

// Of knots that are as many.
double knotDifference(const KnotVector& a, const KnotVector& b)
{
    double shift = 0;
    double largest = 0;
    for (size_t k = 0; k < a.values().size(); ++k) {
        shift = std::max(shift, std::abs(a.values()[k] - b.values()[k]));
        largest = std::max(largest, std::abs(a.values()[k]));
    }
    return share(shift, largest);
}

// Weights as the file may scale them: all by one factor.
template <class Point>
double weightDifference(const std::vector<Point>& a, const std::vector<Point>& b)
{
    double change = 0;
    const double factor = a.front().weight / b.front().weight;
    for (size_t k = 0; k < a.size(); ++k)
        change = std::max(change, std::abs(b[k].weight * factor / a[k].weight - 1));
    return change;
}

bool haveOneShape(const KnotVector& a, const KnotVector& b)
{
    return a.degree() == b.degree() && a.values().size() == b.values().size();
}

// What the surfaces are, in the words of a sentence: "degree 3 x 3 with 10 x 10 control points".
std::string shapeOf(const NurbsSurface& surface)
{
    return "degree " + std::to_string(surface.degreeU()) + " x " + std::to_string(surface.degreeV()) +
           " with " + std::to_string(surface.countU()) + " x " + std::to_string(surface.countV()) +
           " control points";
}

class Comparison {
public:
    // `scale` takes lengths of `back` to those of the original.
    Comparison(const SceneObject& object, const SceneObject& back, double scale)
        : object_(object),
          back_(back),
          scale_(scale)
    {
    }

    [[nodiscard]] Result<void> addTo(SceneDifference& difference) const
    {
        if (!haveOneShape(object_.surface.knotsU(), back_.surface.knotsU()) ||
            !haveOneShape(object_.surface.knotsV(), back_.surface.knotsV()))
            return failure(name() + " has " + shapeOf(object_.surface) + " here and " +
                           shapeOf(back_.surface) + " there");
        difference.knots =
            std::max({difference.knots, knotDifference(object_.surface.knotsU(), back_.surface.knotsU()),
                      knotDifference(object_.surface.knotsV(), back_.surface.knotsV())});
        difference.weights = std::max(difference.weights, weightDifference(object_.surface.controlPoints(),
                                                                           back_.surface.controlPoints()));
        addControlPoints(difference);
        difference.names += object_.name != back_.name ? 1 : 0;
        difference.colours += isOtherColour() ? 1 : 0;
        return addTrimLoops(difference);
    }

private:
    [[nodiscard]] std::string name() const
    {
        return object_.name.empty() ? "A surface without a name" : '"' + object_.name + '"';
    }

    [[nodiscard]] bool isOtherColour() const
    {
        const Colour& a = object_.colour;
        const Colour& b = back_.colour;
        return largestOf(Vec3(a.red - b.red, a.green - b.green, a.blue - b.blue)) > kSameColour;
    }

    void addControlPoints(SceneDifference& difference) const
    {
        double gap = 0;
        double largest = 0;
        const std::vector<ControlPoint>& points = object_.surface.controlPoints();
        for (size_t k = 0; k < points.size(); ++k) {
            const Vec3 here = transformed(points[k].position, object_.transform);
            const Vec3 there = transformed(back_.surface.controlPoints()[k].position, back_.transform);
            gap = std::max(gap, largestOf(there * scale_ - here));
            largest = std::max(largest, largestOf(here));
        }
        difference.controlPoints = std::max(difference.controlPoints, share(gap, largest));
    }

    [[nodiscard]] Result<void> addTrimLoops(SceneDifference& difference) const
    {
        std::vector<TrimLoop> loops = object_.trimLoops;
        if (loops.size() + 1 == back_.trimLoops.size())  // formats that want one put the border around holes
            loops = withBorder(std::move(loops), object_.surface.knotsU(), object_.surface.knotsV());
        if (loops.size() != back_.trimLoops.size())
            return failure(name() + " differs in its number of trim loops: " + std::to_string(loops.size()) +
                           " here, " + std::to_string(back_.trimLoops.size()) + " there");
        std::vector<size_t> left(loops.size());
        std::iota(left.begin(), left.end(), size_t{0});
        for (const TrimLoop& loop : loops)
            if (auto added = addTrimLoop(loop, left, difference); !added)
                return added;
        return {};
    }

    // Which loop comes first says nothing, either: some writers begin with the largest. Takes the one that
    // fits out of those that are left.
    [[nodiscard]] Result<void> addTrimLoop(const TrimLoop& loop, std::vector<size_t>& left,
                                           SceneDifference& difference) const
    {
        std::optional<double> least;
        auto best = left.end();
        for (auto it = left.begin(); it != left.end() && (!least || *least > kSameLoop); ++it)
            if (const auto found = loopDifference(loop, back_.trimLoops[*it]);
                found && (!least || *found < *least)) {
                least = found;
                best = it;
            }
        if (!least)
            return failure(name() + " has other trim curves there");
        left.erase(best);
        difference.trimCurves = std::max(difference.trimCurves, *least);
        return {};
    }

    // Where a loop begins says nothing: the beginning that fits best is taken.
    [[nodiscard]] std::optional<double> loopDifference(const TrimLoop& loop, const TrimLoop& back) const
    {
        const size_t count = loop.curves.size();
        std::optional<double> least;
        if (loop.outer == back.outer && count == back.curves.size())
            for (size_t start = 0; start < std::max<size_t>(count, 1); ++start)
                if (const auto found = curvesDifference(loop, back, start, least))
                    least = found;
        return least;
    }

    // With curve k of the one beside curve k + start of the other; nothing where those are of another make,
    // or no less than `bound` off: of long loops most beginnings are wrong from the first curve on.
    [[nodiscard]] std::optional<double> curvesDifference(const TrimLoop& loop, const TrimLoop& back,
                                                         size_t start, std::optional<double> bound) const
    {
        double largest = 0;
        for (size_t k = 0; k < loop.curves.size(); ++k) {
            const TrimCurve& a = loop.curves[k];
            const TrimCurve& b = back.curves[(k + start) % back.curves.size()];
            if (!haveOneShape(a.knots(), b.knots()))
                return std::nullopt;
            largest =
                std::max({largest, knotDifference(a.knots(), b.knots()),
                          weightDifference(a.points(), b.points()), placeDifference(a.points(), b.points())});
            if (bound && largest >= *bound)
                return std::nullopt;
        }
        return largest;
    }

    // In the parameter plane, of its largest coordinate there.
    [[nodiscard]] double placeDifference(const std::vector<TrimPoint>& a,
                                         const std::vector<TrimPoint>& b) const
    {
        const NurbsSurface& surface = object_.surface;
        const double largest =
            largestOf(Vec3(largestOf(Vec2(surface.knotsU().domainStart(), surface.knotsU().domainEnd())),
                           surface.knotsV().domainStart(), surface.knotsV().domainEnd()));
        double gap = 0;
        for (size_t k = 0; k < a.size(); ++k)
            gap = std::max(gap, largestOf(a[k].position - b[k].position));
        return share(gap, largest);
    }

    const SceneObject& object_;
    const SceneObject& back_;
    double scale_;
};

}  // namespace

double SceneDifference::largest() const
{
    return std::max({controlPoints, weights, knots, trimCurves});
}

Result<SceneDifference> differenceBetween(const Scene& scene, const Scene& back)
{
    if (scene.objects().size() != back.objects().size())
        return failure("The numbers of surfaces differ: " + std::to_string(scene.objects().size()) +
                       " here, " + std::to_string(back.objects().size()) + " there");
    const double here = millimetresIn(scene.units());
    const double there = millimetresIn(back.units());
    if (scene.units() != back.units() && !(here > 0 && there > 0))
        return failure("The lengths are in \"" + scene.units() + "\" here and in \"" + back.units() +
                       "\" there");
    const double scale = scene.units() == back.units() ? 1.0 : there / here;
    SceneDifference difference;
    auto other = back.objects().begin();
    for (const auto& [unused, object] : scene.objects())
        if (auto added = Comparison(*object, *(other++)->second, scale).addTo(difference); !added)
            return tl::unexpected(added.error());
    return difference;
}

}  // namespace knotspan::formats
