#include "model/matching/scene_match.h"

#include <algorithm>
#include <cmath>

#include "model/matching/neighbours.h"

namespace knotspan {

namespace {

// The object with its new surface, where that is another one.
void put(Edit& edit, ObjectId id, const SharedObject& before, const std::optional<MatchedSurface>& matched)
{
    if (!matched || matched->surface == before->surface)
        return;
    auto after = std::make_shared<SceneObject>(*before);
    after->surface = matched->surface;
    edit.set(id, std::move(after));
}

double overlap(const EdgePart& x, const EdgePart& y)
{
    return std::min(x.to, y.to) - std::max(x.from, y.from);
}

// The one that shares most with the edge.
std::optional<ObjectEdge> sameAmong(const std::vector<ObjectEdge>& edges, const ObjectEdge& edge)
{
    std::optional<ObjectEdge> best;
    double most = 0;
    for (const ObjectEdge& other : edges) {
        if (isSameEdge(other, edge) && overlap(other.edge.a, edge.edge.a) > most) {
            most = overlap(other.edge.a, edge.edge.a);
            best = other;
        }
    }
    return best;
}

std::vector<ObjectEdge> edgesIn(const SceneFriends& friends, const std::set<ObjectId>& objects)
{
    std::vector<ObjectEdge> edges;
    for (const FriendEdge& edge : friends.edges()) {
        const ObjectId a = friends.objects()[edge.a.surface];
        const ObjectId b = friends.objects()[edge.b.surface];
        if (objects.count(a) != 0 || objects.count(b) != 0)
            edges.push_back({edge, a, b});
    }
    return edges;
}

// How the parts of `edge` are told of in `now`: the least smooth; nothing where less than half of it meets.
std::optional<Continuity> leastSmooth(const std::vector<ObjectEdge>& now, const ObjectEdge& edge)
{
    std::optional<Continuity> least;
    double shared = 0;
    for (const ObjectEdge& other : now) {
        const double common = overlap(other.edge.a, edge.edge.a);
        if (!isSameEdge(other, edge) || common <= 0)
            continue;
        shared += common;
        if (!least || smoothnessRank(other.edge.continuity) < smoothnessRank(*least))
            least = other.edge.continuity;
    }
    if (shared < (edge.edge.a.to - edge.edge.a.from) / 2)
        return {};
    return least;
}

std::vector<SideEffects::Worse> worseIn(const std::vector<ObjectEdge>& before,
                                        const std::vector<ObjectEdge>& after, const ObjectEdge& mended)
{
    std::vector<SideEffects::Worse> worse;
    const auto rank = [](const std::optional<Continuity>& then) { return then ? smoothnessRank(*then) : -1; };
    for (const ObjectEdge& edge : before) {
        if (isSameEdge(edge, mended) && overlap(edge.edge.a, mended.edge.a) > 0)
            continue;
        const std::optional<Continuity> then = leastSmooth(after, edge);
        if (rank(then) < smoothnessRank(edge.edge.continuity))
            worse.push_back({edge, then});
    }
    std::stable_sort(worse.begin(), worse.end(),
                     [&](const auto& x, const auto& y) { return rank(x.after) < rank(y.after); });
    return worse;
}

// Whether the naked parts of before leave out some of this one.
bool isNew(const EdgePart& part, const std::vector<EdgePart>& before)
{
    constexpr double kCounts = 0.01;  // of the part: what is shorter is a shift of its ends
    double left = part.to - part.from;
    for (const EdgePart& other : before)
        if (other.isOnSameEdge(part))
            left -= std::max(overlap(other, part), 0.0);
    return left > kCounts * (part.to - part.from);
}

}  // namespace

std::vector<ObjectEdge> edgesOf(const Scene& scene, const std::set<ObjectId>& objects,
                                const FriendTolerances& tolerances)
{
    std::set<ObjectId> there;
    for (const ObjectId id : objects)
        if (scene.find(id))
            there.insert(id);
    SceneFriends friends(tolerances);
    friends.follow(partOf(scene, neighbours(scene, there, 1, 3 * tolerances.gap)), true);
    return edgesIn(friends, there);
}

bool isSameEdge(const ObjectEdge& x, const ObjectEdge& y)
{
    // What surfaces' numbers are is told by the objects.
    const auto same = [](EdgePart part, const EdgePart& other) {
        part.surface = other.surface;
        return part.isOnSameEdge(other);
    };
    return x.a == y.a && x.b == y.b && same(x.edge.a, y.edge.a) && same(x.edge.b, y.edge.b);
}

std::vector<std::optional<ObjectEdge>> foundAgain(const Scene& scene, const std::vector<ObjectEdge>& edges,
                                                  const FriendTolerances& tolerances)
{
    std::set<ObjectId> objects;
    for (const ObjectEdge& edge : edges)
        objects.insert({edge.a, edge.b});
    const std::vector<ObjectEdge> now = edgesOf(scene, objects, tolerances);
    std::vector<std::optional<ObjectEdge>> found;
    for (const ObjectEdge& edge : edges)
        found.push_back(sameAmong(now, edge));
    return found;
}

std::optional<ObjectEdge> foundAgain(const Scene& scene, const ObjectEdge& edge,
                                     const FriendTolerances& tolerances)
{
    return foundAgain(scene, std::vector{edge}, tolerances).front();
}

std::optional<size_t> numberAmong(const SceneFriends& friends, const ObjectEdge& edge)
{
    std::optional<size_t> best;
    double most = 0;
    for (size_t k = 0; k < friends.edges().size(); ++k) {
        const FriendEdge& other = friends.edges()[k];
        const ObjectEdge named{other, friends.objects()[other.a.surface], friends.objects()[other.b.surface]};
        if (isSameEdge(named, edge) && overlap(other.a, edge.edge.a) > most) {
            most = overlap(other.a, edge.edge.a);
            best = k;
        }
    }
    return best;
}

Result<SceneMatch> matchInScene(const Scene& scene, const ObjectEdge& edge, Continuity wanted,
                                MatchSides move, const FriendTolerances& tolerances)
{
    const SharedObject a = scene.find(edge.a);
    const SharedObject b = scene.find(edge.b);
    if (!a || !b)
        return failure("The edge's objects are no longer there", "Choose another edge");
    MatchRequest request{placed(*a),         placed(*b), edge.edge.a, edge.edge.b,
                         edge.edge.reversed, wanted,     move,        tolerances};
    request.edgeA.surface = 0;
    request.edgeB.surface = edge.a == edge.b ? 0 : 1;
    auto proposal = matchEdge(request);
    if (!proposal)
        return tl::unexpected(proposal.error());
    SceneMatch match;
    put(match.edit, edge.a, a, proposal->a);
    put(match.edit, edge.b, b, proposal->b);
    match.proposal = *std::move(proposal);
    return match;
}

SideEffects sideEffects(const Scene& scene, const ObjectEdge& edge, const SceneMatch& match,
                        const FriendTolerances& tolerances)
{
    Scene then = scene;
    Edit edit = match.edit;
    edit.applyTo(then);
    std::set<ObjectId> moved;
    for (const ObjectId id : {edge.a, edge.b})
        if (then.find(id) != scene.find(id))
            moved.insert(id);
    if (moved.empty())
        return {};
    const auto around = neighbours(scene, moved, 1, 3 * tolerances.gap);
    SceneFriends friends(tolerances);
    friends.follow(partOf(scene, around), true);
    const std::vector<ObjectEdge> before = edgesIn(friends, moved);
    const std::vector<EdgePart> nakedBefore = friends.nakedEdges();
    friends.follow(partOf(then, around), true);
    SideEffects effects;
    effects.worse = worseIn(before, edgesIn(friends, moved), edge);
    // The same surfaces as before, so their numbers tell which edge is which.
    const auto isTold = [&](const EdgePart& part) {
        return std::any_of(effects.worse.begin(), effects.worse.end(), [&](const SideEffects::Worse& worse) {
            return !worse.after &&
                   (worse.edge.edge.a.isOnSameEdge(part) || worse.edge.edge.b.isOnSameEdge(part));
        });
    };
    for (const EdgePart& part : friends.nakedEdges())
        if (isNew(part, nakedBefore) && !isTold(part))
            effects.naked.push_back({friends.objects()[part.surface], part});
    return effects;
}

std::string describe(const Scene& scene, const ObjectEdge& edge)
{
    return edgeName(edge.edge.a) + " of " + nameOf(scene, edge.a) + " and " + edgeName(edge.edge.b) + " of " +
           nameOf(scene, edge.b);
}

}  // namespace knotspan
