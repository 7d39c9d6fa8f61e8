#include "model/mesh/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include <glm/geometric.hpp>

#include "model/mesh/deviation_measuring.h"
#include "model/mesh/nearest_triangle.h"

namespace knotspan {

namespace {

using Corners = std::vector<Vec3>;  // of a flat, convex piece of a triangle

struct Piece {
    Corners corners;
    int depth = 0;
};

Vec3 centreOf(const Corners& corners)
{
    Vec3 sum(0);
    for (const Vec3& corner : corners)
        sum += corner;
    return sum / static_cast<double>(corners.size());
}

double areaOf(const Corners& triangle)
{
    return glm::length(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0])) / 2;
}

// Both parts of a piece, by the sign of a linear function's values at its corners.
void split(const Corners& piece, std::vector<double>& values, Corners& above, Corners& below)
{
    constexpr double kRounding = 1e-13;
    double most = 0;
    for (const double value : values)
        most = std::max(most, std::abs(value));
    for (double& value : values)
        value = std::abs(value) > kRounding * most ? value : 0;
    above.clear();
    below.clear();
    for (size_t k = 0; k < piece.size(); ++k) {
        const size_t next = (k + 1) % piece.size();
        if (values[k] >= 0)
            above.push_back(piece[k]);
        if (values[k] <= 0)
            below.push_back(piece[k]);
        if ((values[k] > 0 && values[next] < 0) || (values[k] < 0 && values[next] > 0)) {
            const Vec3 between =
                piece[k] + (values[k] / (values[k] - values[next])) * (piece[next] - piece[k]);
            above.push_back(between);
            below.push_back(between);
        }
    }
}

// Looks at places, one after the other, and remembers the furthest.
class Looker {
public:
    explicit Looker(const NearestTriangle& nearest) : nearest_(&nearest) {}

    NearestTriangle::Found look(const Vec3& point)
    {
        const NearestTriangle::Found found = nearest_->to(point, last_);
        last_ = found.triangle;
        if (found.distance > largest_ || !hasLooked_) {
            largest_ = found.distance;
            at_ = point;
        }
        hasLooked_ = true;
        return found;
    }
    void add(const Looker& other)
    {
        if (other.hasLooked_ && (other.largest_ > largest_ || !hasLooked_)) {
            largest_ = other.largest_;
            at_ = other.at_;
            hasLooked_ = true;
        }
    }
    [[nodiscard]] double largest() const { return largest_; }
    [[nodiscard]] const Vec3& at() const { return at_; }

private:
    const NearestTriangle* nearest_;
    size_t last_ = 0;  // found: likely near to what is looked for next
    bool hasLooked_ = false;
    double largest_ = 0;
    Vec3 at_{0};
};

class DistanceSearch {
public:
    DistanceSearch(const TriangleMesh& from, const TriangleMesh& to, double tolerance)
        : from_(from),
          nearest_(to),
          tolerance_(tolerance),
          looks_(4 * (from.triangles.size() + to.triangles.size()) + 50'000),
          furthest_(nearest_)
    {
    }

    MeshDistance run()
    {
        lookAtVertices();
        takeMean();
        for (size_t t = 0; t < from_.triangles.size(); ++t) {
            boundOver({cornersOf(t), 0}, centres_[t]);
            while (!open_.empty()) {
                const Piece piece = std::move(open_.back());
                open_.pop_back();
                const NearestTriangle::Found found = furthest_.look(centreOf(piece.corners));
                boundOver(piece, found);
            }
        }
        result_.largest = furthest_.largest();
        result_.at = furthest_.at();
        result_.uncertainty = std::max(0.0, upper_ - result_.largest);
        return result_;
    }

private:
    [[nodiscard]] Corners cornersOf(size_t triangle) const
    {
        const auto& [a, b, c] = from_.triangles[triangle];
        return {from_.vertices[a], from_.vertices[b], from_.vertices[c]};
    }

    // visit(looker, k) for all k, in parts on all processors.
    template <class Visit>
    void onAllProcessors(size_t count, const Visit& visit)
    {
        const size_t parts = std::clamp<size_t>(std::thread::hardware_concurrency(), 1, 64);
        std::vector<Looker> lookers(parts, Looker(nearest_));
        std::vector<std::thread> threads;
        for (size_t part = 0; part < parts; ++part)
            threads.emplace_back([&, part] {
                for (size_t k = count * part / parts; k < count * (part + 1) / parts; ++k)
                    visit(lookers[part], k);
            });
        for (std::thread& thread : threads)
            thread.join();
        for (const Looker& looker : lookers)
            furthest_.add(looker);
    }

    void lookAtVertices()
    {
        std::vector<char> used(from_.vertices.size(), 0);
        for (const Triangle& triangle : from_.triangles)
            for (const std::uint32_t vertex : triangle)
                used[vertex] = 1;
        onAllProcessors(from_.vertices.size(), [&](Looker& looker, size_t vertex) {
            if (used[vertex] != 0)
                (void)looker.look(from_.vertices[vertex]);
        });
    }

    // Triangles in equal parts, by their centres.
    void takeMean()
    {
        constexpr double kPlaces = 100'000;
        constexpr double kMostAlong = 300;
        std::vector<double> means(from_.triangles.size());
        for (size_t t = 0; t < from_.triangles.size(); ++t)
            result_.area += areaOf(cornersOf(t));
        centres_.resize(from_.triangles.size());
        onAllProcessors(from_.triangles.size(), [&](Looker& looker, size_t t) {
            const Corners c = cornersOf(t);
            centres_[t] = looker.look(centreOf(c));
            const double share = result_.area > 0 ? areaOf(c) / result_.area : 0;
            const int parts = static_cast<int>(std::clamp(std::sqrt(share * kPlaces), 1.0, kMostAlong));
            means[t] = share * (parts == 1 ? centres_[t].distance : meanOver(c, parts, looker));
        });
        for (const double mean : means)
            result_.mean += mean;
    }

    [[nodiscard]] static double meanOver(const Corners& c, int parts, Looker& looker)
    {
        double sum = 0;
        for (int i = 0; i < parts; ++i)
            for (int j = 0; j < 2 * (parts - i) - 1; ++j) {
                const double third = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
                const double u = (i + third) / parts;
                const double v = (j / 2 + third) / parts;
                sum += looker.look(c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0])).distance;
            }
        return sum / parts / parts;
    }

    [[nodiscard]] double goodEnough() const
    {
        return furthest_.largest() + std::max(tolerance_, 1e-4 * furthest_.largest());
    }

    // The distance is nowhere over the piece larger than this.
    [[nodiscard]] double boundBy(size_t triangle, const Corners& piece) const
    {
        const std::array<Vec3, 3> near = nearest_.corners(triangle);
        double bound = 0;
        for (const Vec3& corner : piece)
            bound = std::max(bound, distanceToTriangle(corner, near));
        return bound;
    }

    // `found`: nearest to its centre.
    void boundOver(const Piece& piece, const NearestTriangle::Found& found)
    {
        constexpr int kDeepest = 200;
        const Vec3 centre = centreOf(piece.corners);
        double bound = boundBy(found.triangle, piece.corners);
        double reach = 0;
        for (const Vec3& corner : piece.corners)
            reach = std::max(reach, glm::distance(corner, centre));
        bound = std::min(bound, found.distance + reach);
        if (bound <= goodEnough() || piece.depth == kDeepest || looks_ == 0) {
            upper_ = std::max(upper_, bound);
            return;
        }
        --looks_;
        if (piece.depth % 3 == 2 || !cutByPrism(piece, found.triangle))
            halve(piece);
    }

    // Sees to what is over the triangle and leaves the rest open. False where the piece is not cut by it.
    bool cutByPrism(const Piece& piece, size_t triangle)
    {
        const std::array<Vec3, 3> near = nearest_.corners(triangle);
        const Vec3 normal = glm::cross(near[1] - near[0], near[2] - near[0]);
        Corners inside = piece.corners;
        Corners above;
        Corners below;
        std::vector<Corners> outside;
        for (size_t side = 0; side < 3; ++side) {
            const Vec3 inwards = glm::cross(normal, near[(side + 1) % 3] - near[side]);
            std::vector<double> values;
            for (const Vec3& corner : inside)
                values.push_back(glm::dot(inwards, corner - near[side]));
            split(inside, values, above, below);
            if (above.size() < 3)
                return false;
            if (below.size() >= 3)
                outside.push_back(below);
            inside = above;
        }
        if (outside.empty())
            return false;
        for (Corners& part : outside)
            open_.push_back({std::move(part), piece.depth + 1});
        open_.push_back({std::move(inside), piece.depth + 1});
        return true;
    }

    void halve(const Piece& piece)
    {
        size_t longest = 0;
        const auto& c = piece.corners;
        const auto side = [&](size_t k) { return c[(k + 1) % c.size()] - c[k]; };
        for (size_t k = 1; k < c.size(); ++k)
            if (glm::length(side(k)) > glm::length(side(longest)))
                longest = k;
        const Vec3 middle = c[longest] + 0.5 * side(longest);
        std::vector<double> values;
        for (const Vec3& corner : c)
            values.push_back(glm::dot(corner - middle, side(longest)));
        Corners above;
        Corners below;
        split(c, values, above, below);
        for (Corners* part : {&above, &below})
            if (part->size() >= 3)
                open_.push_back({std::move(*part), piece.depth + 1});
    }

    const TriangleMesh& from_;
    NearestTriangle nearest_;
    double tolerance_;
    size_t looks_;  // that are left
    Looker furthest_;
    std::vector<NearestTriangle::Found> centres_;  // of the triangles
    std::vector<Piece> open_;
    double upper_ = 0;
    MeshDistance result_;
};

}  // namespace

MeshDistance distanceFrom(const TriangleMesh& from, const TriangleMesh& to, double tolerance)
{
    return DistanceSearch(from, to, tolerance).run();
}

}  // namespace knotspan
