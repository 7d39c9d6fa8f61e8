#include "model/mesh/face_triangles.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <glm/common.hpp>

#include "model/mesh/triangle_in_ksquad.h"

namespace knotspan {

namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

class FaceMeshing {
public:
    explicit FaceMeshing(const FaceTask& task)
        : task_(task),
          face_(task.face),
          errors_(task.errors),
          plane_(planeOf(task))
    {
        result_.outlineCount = static_cast<std::uint32_t>(task.samples.positions().size());
        vertexOf_.assign(PlaneTriangulation::kCorners, kNone);
        places_.resize(PlaneTriangulation::kCorners);
    }

    FaceTriangles make(bool anyway)
    {
        addOutline();
        connectOutline();
        findHairs();
        result_.crosses = missing_;
        if (missing_ && !anyway)
            return std::move(result_);
        if (missing_)
            markByRegion();
        else
            plain_.markInside([&](std::uint32_t from, std::uint32_t to) {
                const auto edge = edges_.find(key(from, to));
                return edge != edges_.end() && edge->second.count % 2 != 0;
            });
        addGrids();
        addKnotLines();
        refine();
        take();
        return std::move(result_);
    }

private:
    struct Edge {
        SeamSegment segment;
        int count = 0;
        double sliver = 0;
    };
    static std::uint64_t key(std::uint32_t from, std::uint32_t to)
    {
        return std::uint64_t{std::min(from, to)} << 32U | std::max(from, to);
    }
    static FacePlane planeOf(const FaceTask& task)
    {
        Vec2 low(std::numeric_limits<double>::infinity());
        Vec2 high(-std::numeric_limits<double>::infinity());
        for (const FaceStretch& stretch : task.stretches)
            for (const auto& sample : task.samples.of(stretch.seam)) {
                const Vec2 at = task.face.arcs()[stretch.arc].placeAt(sample.t[stretch.member]).onLattice();
                low = glm::min(low, at);
                high = glm::max(high, at);
            }
        return {task.face, task.errors, low, high};
    }

    void remember(std::uint32_t number, const OutlinePlace& place, std::uint32_t vertex)
    {
        if (number == vertexOf_.size()) {
            vertexOf_.push_back(vertex);
            places_.push_back(place);
        }
    }

    void addOutline()
    {
        for (const FaceStretch& stretch : task_.stretches) {
            const OutlineArc& arc = face_.arcs()[stretch.arc];
            std::vector<std::uint32_t>& numbers = along_.emplace_back();
            for (const auto& sample : task_.samples.of(stretch.seam)) {
                const OutlinePlace place = arc.placeAt(sample.t[stretch.member]);
                const std::uint32_t number = plain_.add(plane_.at(place));
                remember(number, place, sample.vertex);
                if (vertexOf_[number] != sample.vertex)
                    result_.same.push_back({vertexOf_[number], sample.vertex});
                numbers.push_back(number);
            }
        }
    }

    void connectOutline()
    {
        for (size_t s = 0; s < task_.stretches.size(); ++s) {
            const FaceStretch& stretch = task_.stretches[s];
            const auto& samples = task_.samples.of(stretch.seam);
            for (std::uint32_t k = 0; k + 1 < along_[s].size(); ++k) {
                const std::uint32_t from = along_[s][k];
                const std::uint32_t to = along_[s][k + 1];
                const auto [low, high] =
                    std::minmax(samples[k].t[stretch.member], samples[k + 1].t[stretch.member]);
                const double sliver = low < high ? errors_.sliver(face_.arcs()[stretch.arc], low, high) : 0.0;
                // Whether or not a triangle has it: what is narrower than the weld has none.
                if (low < high)
                    result_.bound =
                        std::max(result_.bound, errors_.chord(face_.arcs()[stretch.arc], low, high) + sliver);
                if (from == to)
                    continue;
                const SeamSegment segment{stretch.seam, k};
                if (const auto obstacle = plain_.connect(from, to)) {
                    missing_ = true;
                    result_.tooLong.push_back(segment);
                    if (const auto other = edges_.find(key(obstacle->from, obstacle->to));
                        other != edges_.end())
                        result_.tooLong.push_back(other->second.segment);
                    continue;
                }
                Edge& edge = edges_[key(from, to)];
                edge.segment = segment;
                ++edge.count;
                edge.sliver = std::max(edge.sliver, sliver);
            }
        }
    }

    void findHairs()
    {
        for (const auto& [ends, edge] : edges_) {
            const std::uint32_t a = vertexOf_[ends >> 32U];
            const std::uint32_t b = vertexOf_[ends & 0xffffffffU];
            if (edge.count % 2 == 0 && errors_.isNothing(edge.sliver))
                result_.hairs.push_back({std::min(a, b), std::max(a, b)});
        }
        std::sort(result_.hairs.begin(), result_.hairs.end());
    }

    void markByRegion()
    {
        const auto& knotsU = face_.surface().knotsU();
        const auto& knotsV = face_.surface().knotsV();
        plain_.markEach([&](const PlaneTriangulation::Corners& triangle) {
            if (std::any_of(triangle.vertices.begin(), triangle.vertices.end(),
                            [](std::uint32_t v) { return v < PlaneTriangulation::kCorners; }))
                return false;
            Vec2 middle(0.0);
            for (const std::uint32_t vertex : triangle.vertices)
                middle += places_[vertex].onLattice() / 3.0;
            const auto at = [](const KnotVector& knots, double place) {
                const auto span = std::min(static_cast<size_t>(place), knots.spans().size() - 1);
                const double start = knots[knots.spans()[span]];
                return start + (place - static_cast<double>(span)) * (knots[knots.spans()[span] + 1] - start);
            };
            return task_.region.contains(at(knotsU, middle.x), at(knotsV, middle.y));
        });
    }

    std::uint32_t addInside(const OutlinePlace& place)
    {
        const auto number = plain_.addInside(plane_.at(place));
        if (!number)
            return kNone;
        remember(*number, place, kNone);
        return *number;
    }

    void addGrids()
    {
        for (int a = plane_.first(0); a <= plane_.last(0); ++a)
            for (int b = plane_.first(1); b <= plane_.last(1); ++b) {
                const Grid& grid = errors_.grid(a, b);
                for (int i = 1; i < grid.u; ++i)
                    for (int j = 1; j < grid.v; ++j)
                        addInside({a, b, {double(i) / grid.u, double(j) / grid.v}});
            }
    }

    void addKnotLines()
    {
        for (const int axis : {0, 1})
            for (int line = plane_.first(axis) + 1; line <= plane_.last(axis); ++line)
                addKnotLine(axis, line);
    }

    void addKnotLine(int axis, int line)
    {
        const int other = 1 - axis;
        std::vector<std::uint32_t> numbers;
        for (int span = plane_.first(other); span <= plane_.last(other); ++span) {
            const auto quad = [&](int across) {
                return axis == 0 ? errors_.grid(across, span).v : errors_.grid(span, across).u;
            };
            const int cells = std::max(quad(line - 1), quad(line));
            for (int k = span == plane_.first(other) ? 1 : 0; k < cells; ++k) {
                const double t = double(k) / cells;
                const auto number = addInside(axis == 0 ? OutlinePlace{line, span, {0, t}}
                                                        : OutlinePlace{span, line, {t, 0}});
                if (number != kNone)
                    numbers.push_back(number);
            }
        }
        const OutlinePlace start = axis == 0 ? OutlinePlace{line, plane_.first(1), {0, 0}}
                                             : OutlinePlace{plane_.first(0), line, {0, 0}};
        const GridPlace on = plane_.at(start);
        const auto across = [&](const GridPlace& at) { return axis == 0 ? at.x : at.y; };
        const auto along = [&](std::uint32_t number) {
            return axis == 0 ? plain_.places()[number].y : plain_.places()[number].x;
        };
        for (const auto& stretch : along_)
            for (const std::uint32_t number : stretch)
                if (across(plain_.places()[number]) == across(on))
                    numbers.push_back(number);
        std::sort(numbers.begin(), numbers.end(),
                  [&](std::uint32_t x, std::uint32_t y) { return along(x) < along(y); });
        numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
        for (size_t k = 0; k + 1 < numbers.size(); ++k)
            if (plain_.startsInside(numbers[k], numbers[k + 1]))
                static_cast<void>(plain_.connect(numbers[k], numbers[k + 1]));
    }

    [[nodiscard]] TriangleInKsquad inQuad(const PlaneTriangulation::Corners& triangle) const
    {
        const auto& [a, b, c] = triangle.vertices;
        return inKsquad({places_[a], places_[b], places_[c]}, plane_, errors_);
    }

    // Halves what is too long in triangles that are too large, until there is none.
    void refine()
    {
        constexpr double kShortest = 0.5;  // in cells, of what is halved
        std::vector<std::uint32_t> open;
        for (std::uint32_t k = 0; k < plain_.triangles().size(); ++k)
            open.push_back(k);
        while (!open.empty()) {
            const std::uint32_t number = open.back();
            open.pop_back();
            const PlaneTriangulation::Corners triangle = plain_.triangles()[number];
            if (!triangle.inside)
                continue;
            const TriangleInKsquad in = inQuad(triangle);
            if (errors_.isFine(in.a, in.b, in.size()))
                continue;
            double longest = kShortest;
            double longestOutline = kShortest;
            const Edge* outline = nullptr;
            int corner = -1;
            for (int k = 0; k < 3; ++k) {
                const auto i = static_cast<size_t>((k + 1) % 3);
                const auto j = static_cast<size_t>((k + 2) % 3);
                const double length = errors_.lengthInCells(in.a, in.b, glm::abs(in.t[i] - in.t[j]));
                const auto edge = edges_.find(key(triangle.vertices[i], triangle.vertices[j]));
                if (edge != edges_.end()) {
                    if (length > longestOutline) {
                        longestOutline = length;
                        outline = &edge->second;
                    }
                } else if (length > longest) {
                    longest = length;
                    corner = k;
                }
            }
            if (corner < 0) {
                if (outline != nullptr)
                    result_.tooLong.push_back(outline->segment);
                continue;
            }
            const auto i = static_cast<size_t>((corner + 1) % 3);
            const auto j = static_cast<size_t>((corner + 2) % 3);
            const OutlinePlace middle{in.a, in.b, 0.5 * (in.t[i] + in.t[j])};
            const std::uint32_t other = triangle.neighbours[static_cast<size_t>(corner)];
            const auto added = plain_.splitEdge(number, corner, plane_.at(middle));
            if (!added)
                continue;
            remember(*added, middle, kNone);
            const auto count = static_cast<std::uint32_t>(plain_.triangles().size());
            open.insert(open.end(), {number, other, count - 2, count - 1});
        }
    }

    void take()
    {
        std::vector<std::uint32_t> inside(places_.size(), kNone);
        const auto vertex = [&](std::uint32_t number) {
            if (vertexOf_[number] != kNone)
                return vertexOf_[number];
            if (inside[number] == kNone) {
                inside[number] = static_cast<std::uint32_t>(result_.inside.size());
                result_.inside.push_back(places_[number]);
            }
            return result_.outlineCount + inside[number];
        };
        const auto countV = static_cast<std::uint32_t>(face_.surface().knotsV().spans().size());
        for (const auto& triangle : plain_.triangles()) {
            if (!triangle.inside)
                continue;
            const TriangleInKsquad in = inQuad(triangle);
            FaceTriangles::Corners corners;
            for (size_t k = 0; k < 3; ++k)
                corners.vertices[k] = vertex(triangle.vertices[k]);
            corners.t = in.t;
            corners.ksquad = static_cast<std::uint32_t>(in.a) * countV + static_cast<std::uint32_t>(in.b);
            double sliver = 0;
            for (size_t k = 0; k < 3; ++k)
                if (const auto edge = edges_.find(key(triangle.vertices[k], triangle.vertices[(k + 1) % 3]));
                    edge != edges_.end())
                    sliver = std::max(sliver, edge->second.sliver);
            result_.bound =
                std::max(result_.bound, errors_.bound(in.a, in.b, in.size()) + 2 * in.spills + sliver);
            result_.triangles.push_back(corners);
        }
        std::stable_sort(result_.triangles.begin(), result_.triangles.end(),
                         [](const auto& x, const auto& y) { return x.ksquad < y.ksquad; });
    }

    const FaceTask& task_;
    const OutlinedFace& face_;
    const FaceErrors& errors_;
    FacePlane plane_;
    PlaneTriangulation plain_;
    std::vector<std::uint32_t> vertexOf_;  // of the outline, by number in the plane
    std::vector<OutlinePlace> places_;
    std::vector<std::vector<std::uint32_t>> along_;  // by stretch
    std::unordered_map<std::uint64_t, Edge> edges_;
    bool missing_ = false;
    FaceTriangles result_;
};

}  // namespace

FaceTriangles trianglesOf(const FaceTask& task, bool anyway)
{
    if (task.stretches.empty())
        return {};
    return FaceMeshing(task).make(anyway);
}

}  // namespace knotspan
